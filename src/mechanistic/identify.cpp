#include "src/mechanistic/identify.hpp"
#include "src/files/results.hpp"
#include "src/units/units.hpp"
#include "src/windows/join_windows.hpp"
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace swarf {
namespace fs = std::filesystem;
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr int blocks = 12; // of a whole run

// Equations of the fit: shares . K = force.
class Fit {
 public:
  void add(const std::array<double, 6>& shares, double force) { rows.push_back({shares, force}); }

  Identified solve(const std::string& what) const {
    Identified found;
    std::vector<int> used; // coefficients that some equation sees
    for (std::size_t k = 0; k < 6; ++k)
      if (std::any_of(rows.begin(), rows.end(), [k](const Row& row) { return row.shares[k] != 0; }))
        used.push_back(int(k)), found.is_found[k] = true;
    const int n = int(rows.size()), p = int(used.size());
    Eigen::MatrixXd a(n, p);
    Eigen::VectorXd b(n), scale(p);
    for (int i = 0; i < n; ++i) {
      b(i) = rows[std::size_t(i)].force;
      for (int j = 0; j < p; ++j) a(i, j) = rows[std::size_t(i)].shares[std::size_t(used[std::size_t(j)])];
    }
    for (int j = 0; j < p; ++j) scale(j) = a.col(j).norm(), a.col(j) /= scale(j); // units differ by 1e5
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
    if (p == 0 || n < p || qr.rank() < p)
      throw DeckError(what + ": do not tell all coefficients apart. Give forces at three feeds or chip "
                             "thicknesses, or over a range of immersion.");
    const Eigen::VectorXd x = qr.solve(b);
    const double left = (a * x - b).squaredNorm();
    found.points = n;
    found.scatter = n > p ? std::sqrt(left / (n - p)) : std::numeric_limits<double>::quiet_NaN();
    const Eigen::MatrixXd covariance = (a.transpose() * a).inverse();
    for (int j = 0; j < p; ++j) {
      const std::size_t k = std::size_t(used[std::size_t(j)]);
      found.value[k] = x(j) / scale(j),
      found.error[k] = found.scatter * std::sqrt(covariance(j, j)) / scale(j);
    }
    return found;
  }

 private:
  struct Row {
    std::array<double, 6> shares;
    double force;
  };
  std::vector<Row> rows;
};

using Components = std::vector<std::pair<std::size_t, double>>; // axis, force on the tool

struct Measured {
  double immersion; // rad
  Components forces;
};
void add_mill(Fit& fit, const MillEdge& edge, const MillCut& cut, const Measured& at) {
  std::array<std::array<double, 3>, 6> sum{};
  for (int tooth = 0; tooth < cut.tool.flutes; ++tooth) {
    const auto shares = find_shares(edge, cut, tooth, at.immersion);
    for (std::size_t k = 0; k < 6; ++k)
      for (std::size_t a = 0; a < 3; ++a) sum[k][a] += shares[k].force[a];
  }
  for (const auto& [axis, force] : at.forces) {
    std::array<double, 6> row{};
    for (std::size_t k = 0; k < 6; ++k) row[k] = sum[k][axis];
    fit.add(row, force);
  }
}

// Means of the history's columns over equal parts of it; samples are means since the one before.
std::vector<std::vector<double>> block_means(const HistoryTable& history,
                                             const std::vector<std::string>& columns, double skip) {
  const auto& time = history.at("time");
  const double from = time.front() + skip * (time.back() - time.front()),
               width = (time.back() - from) / blocks;
  std::vector<std::vector<double>> sums(blocks, std::vector<double>(columns.size(), 0.0));
  std::vector<double> weight(blocks, 0.0);
  for (std::size_t i = 1; i < history.rows(); ++i) {
    const double place = (0.5 * (time[i] + time[i - 1]) - from) / width;
    if (!(place >= 0 && place < blocks)) continue;
    const std::size_t b = std::size_t(place);
    weight[b] += time[i] - time[i - 1];
    for (std::size_t c = 0; c < columns.size(); ++c)
      sums[b][c] += (time[i] - time[i - 1]) * history.at(columns[c])[i];
  }
  std::vector<std::vector<double>> means;
  for (std::size_t b = 0; b < blocks; ++b) {
    if (weight[b] <= 0) continue;
    for (double& value : sums[b]) value /= weight[b];
    means.push_back(sums[b]);
  }
  return means;
}

Deck deck_of(const fs::path& folder) {
  const PassFolder pass{folder};
  const ResultsFolder run{folder};
  return read_deck((fs::exists(pass.table()) ? pass.deck() : run.deck()).string(), run.path.string());
}

void add_mill_run(Fit& fit, const fs::path& folder, const Deck& deck, MechanisticDeck model) {
  const PassFolder pass{folder};
  const bool is_windows = fs::exists(pass.table());
  if (deck.mechanistic) model = *deck.mechanistic;
  model.helix = deck.tool->helix; // as simulated, not as the real mill has it
  const MillCut cut = find_cut(deck, model);
  const MillEdge edge(cut);
  if (is_windows) {
    const HistoryTable table = read_history(pass.table());
    for (std::size_t i = 0; i < table.rows(); ++i) {
      Components forces{{0, table.at("force_x")[i]}, {1, table.at("force_y")[i]}};
      if (cut.helix != 0) forces.emplace_back(2, table.at("force_z")[i]);
      add_mill(fit, edge, cut, {table.at("immersion")[i] * degree, forces});
    }
    return;
  }
  const HistoryTable history = read_history(open_results(folder).history());
  // The chip has to form first: a third of the way.
  for (const auto& mean : block_means(history, {"immersion", "force_x", "force_y", "force_z"}, 1.0 / 3)) {
    Components forces{{0, mean[1]}, {1, mean[2]}};
    if (cut.helix != 0) forces.emplace_back(2, mean[3]);
    add_mill(fit, edge, cut, {mean[0] * degree, forces});
  }
}

// One point of the line over the chip's thickness: the mean of the second half.
void add_wedge_run(Fit& fit, const fs::path& folder, const Deck& deck) {
  const ToolDeck& tool = *deck.tool;
  if (tool.velocity[1] != 0 || tool.velocity[2] != 0 || tool.inclination != 0)
    throw DeckError(deck.file +
                    ": tool: coefficients come from orthogonal cuts along x, without inclination.");
  double top = -1e300, low = 1e300, high = -1e300;
  for (const BodyDeck& body : deck.bodies) {
    if (body.shape != BodyShape::block)
      throw DeckError(deck.file + ": body.shape: expected blocks under a wedge.");
    top = std::max(top, body.origin[1] + body.size[1]);
    low = std::min(low, body.origin[2]), high = std::max(high, body.origin[2] + body.size[2]);
  }
  const double chip = top - tool.position[1];
  const double edge = std::min(high, tool.position[2] + 0.5 * tool.width) -
                      std::max(low, tool.position[2] - 0.5 * tool.width);
  const double width = edge * deck.output.force_scale;
  if (!(chip > 0 && edge > 0)) throw DeckError(deck.file + ": tool.position: the wedge cuts nothing.");
  const HistoryTable history = read_history(open_results(folder).history());
  double f_c = 0, f_f = 0;
  const auto means = block_means(history, {"force_x", "force_y"}, 0.5);
  for (const auto& mean : means) f_c += mean[0] / double(means.size()), f_f += mean[1] / double(means.size());
  const double sign = tool.velocity[0] > 0 ? -1 : 1; // the work holds the tool back
  fit.add({chip * width, 0, 0, width, 0, 0}, sign * f_c);
  fit.add({0, chip * width, 0, 0, width, 0}, f_f);
}

double factor_to_si(const HistoryColumn& column, Dimension dimension, const fs::path& file) {
  const auto value = parse_quantity("1 " + column.unit, dimension);
  if (const double* factor = std::get_if<double>(&value)) return *factor;
  throw ResultsError(
      fmt::format("{}:1: column {}: {}", file.string(), column.name, std::get<UnitError>(value).message));
}

} // namespace

Identified identify_from_table(const fs::path& csv, const Deck& deck, const MechanisticDeck& model) {
  HistoryTable table = read_history(csv);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::string& name = table.columns[c].name;
    const Dimension dimension = name == "immersion"          ? Dimension::angle
                                : name == "feed_per_tooth"   ? Dimension::length
                                : name.starts_with("force_") ? Dimension::force
                                                             : Dimension::none;
    if (dimension == Dimension::none) continue; // a column that the model has no use for
    const double factor = factor_to_si(table.columns[c], dimension, csv);
    for (double& value : table.values[c]) value *= factor;
  }
  for (const char* needed : {"immersion", "force_x", "force_y"})
    if (!table.has(needed))
      throw ResultsError(
          fmt::format("{}:1: has no column {}; expected \"immersion [deg],force_x [N],force_y [N]\", "
                      "and perhaps force_z and feed_per_tooth [um]",
                      csv.string(), needed));
  Fit fit;
  MillCut cut = find_cut(deck, model);
  std::vector<std::pair<double, MillEdge>> edges; // of each feed
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double feed = table.has("feed_per_tooth") ? table.at("feed_per_tooth")[i] : cut.tool.feed_per_tooth;
    auto at = std::find_if(edges.begin(), edges.end(), [&](const auto& edge) { return edge.first == feed; });
    if (at == edges.end()) {
      cut.tool.feed_per_tooth = feed;
      edges.emplace_back(feed, MillEdge(cut)), at = edges.end() - 1;
    }
    Components forces{{0, table.at("force_x")[i]}, {1, table.at("force_y")[i]}};
    if (table.has("force_z")) forces.emplace_back(2, table.at("force_z")[i]);
    add_mill(fit, at->second, cut, {table.at("immersion")[i], forces});
  }
  Identified found = fit.solve(csv.string());
  found.how = fmt::format("least squares of {} forces of {} at {} feed{}", found.points, csv.string(),
                          edges.size(), edges.size() == 1 ? "" : "s");
  return found;
}

Identified identify_from_runs(const std::vector<std::string>& folders, MechanisticDeck model) {
  Fit fit;
  std::optional<ToolKind> kind;
  for (const std::string& folder : folders) {
    const Deck deck = deck_of(folder);
    if (!deck.tool || (deck.tool->kind != ToolKind::end_mill && deck.tool->kind != ToolKind::wedge))
      throw DeckError(
          fmt::format("{}: has a tool of kind \"{}\": coefficients come from runs of an end mill or of a "
                      "wedge.",
                      folder, deck.tool ? word_of(deck.tool->kind) : "none"));
    if (kind && deck.tool->kind != *kind)
      throw DeckError(folder + ": is of another kind of tool than the folder before it. Give them apart.");
    kind = deck.tool->kind;
    if (kind == ToolKind::wedge)
      add_wedge_run(fit, folder, deck);
    else
      add_mill_run(fit, folder, deck, model);
  }
  Identified found = fit.solve(folders.front());
  found.how =
      fmt::format("least squares of {} mean forces of {} run{} of {}", found.points, folders.size(),
                  folders.size() == 1 ? "" : "s", kind == ToolKind::wedge ? "a wedge" : "an end mill");
  return found;
}

} // namespace swarf
