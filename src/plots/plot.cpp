#include "src/plots/plot.hpp"

#include "src/output/history.hpp"
#include "src/plots/chart.hpp"
#include "src/plots/display.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace swarf {
namespace {

struct Axis {
  std::string title;
  std::vector<double> values;
};

// Immersion where the run has one, else time in a unit that gives handy numbers.
Axis horizontal_axis(const HistoryTable& history) {
  const auto& angle = history.at("immersion");
  const auto [least, most] = std::minmax_element(angle.begin(), angle.end());
  if (*most > *least) return {"Immersion angle [deg]", angle};
  Axis axis{"", history.at("time")};
  const double end = axis.values.back();
  const auto [scale, unit] = end < 1e-3 ? std::pair(1e6, "\u00b5s")
                             : end < 1  ? std::pair(1e3, "ms")
                                        : std::pair(1.0, "s");
  for (double& t : axis.values) t *= scale;
  axis.title = fmt::format("Time [{}]", unit);
  return axis;
}

HistoryTable load(const std::filesystem::path& file) {
  const std::string why_not = open_display();
  if (!why_not.empty()) throw ResultsError(why_not);
  HistoryTable history = read_history(file);
  if (history.rows() < 2)
    throw ResultsError(fmt::format("{}: has {} samples, a curve needs two; let the run go on", file.string(),
                                   history.rows()));
  return history;
}

std::vector<Level> levels_of(const std::vector<LabelledForce>& published) {
  std::vector<Level> levels;
  for (const LabelledForce& force : published)
    levels.push_back({fmt::format("{} ({} N)", force.label, force.force), force.force});
  return levels;
}

std::vector<Curve> force_curves(const HistoryTable& table) {
  return {{"F_x", table.at("force_x"), blue, 3},
          {"F_y", table.at("force_y"), vermilion, 3},
          {"F_z", table.at("force_z"), green, 3},
          {"planar resultant", table.at("force_planar"), black, 5}};
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double v : values)
    if (std::isfinite(v)) largest = std::max(largest, std::abs(v));
  return largest;
}

} // namespace

Curve read_model(const std::filesystem::path& csv, double from, double to, std::vector<double>& at) {
  Curve curve{"mechanistic model", {}, purple, 4, vtkPen::DOT_LINE};
  if (!std::filesystem::exists(csv)) return curve;
  const HistoryTable model = read_history(csv);
  const auto& angle = model.at("immersion");
  for (std::size_t i = 0; i < angle.size(); ++i)
    if (angle[i] >= from && angle[i] <= to)
      at.push_back(angle[i]), curve.values.push_back(model.at("force_planar")[i]);
  return curve;
}

void plot_forces(const ResultsFolder& results, const std::filesystem::path& png,
                 const std::vector<LabelledForce>& published, double filter_frequency) {
  const HistoryTable history = load(results.history());
  const HistoryTable filtered = filter_history(history, filter_frequency);
  const Axis axis = horizontal_axis(history);

  std::vector<Curve> thick = force_curves(filtered);
  const auto& planar = filtered.at("force_planar");
  const bool is_planar = largest_of(planar) > 0.01 * largest_of(filtered.at("force_z"));
  if (!is_planar) thick.erase(thick.begin(), thick.begin() + 2), thick.pop_back(); // a blow along z
  const std::vector<Level> levels = levels_of(published);
  std::vector<double> model_at;
  const Curve model = read_model(results.mechanistic(), axis.values.front(), axis.values.back(), model_at);
  std::vector<Curve> all = thick;
  if (model_at.size() > 1) all.push_back(model);
  const auto [least, most] = vertical_range(all, levels);

  Chart chart("Force on the tool", axis.title, "Force [N]");
  chart.add(axis.values,
            {is_planar ? "unfiltered resultant" : "unfiltered F_z",
             history.at(is_planar ? "force_planar" : "force_z"), grey, 1, vtkPen::SOLID_LINE, 110});
  for (const Level& level : levels)
    chart.add({axis.values.front(), axis.values.back()},
              {"", {level.value, level.value}, grey, 2.5, vtkPen::DASH_LINE});
  for (const Curve& curve : thick) chart.add(axis.values, curve);
  if (model_at.size() > 1) chart.add(model_at, model);
  chart.set_range(vtkAxis::LEFT, least, most);
  chart.set_range(vtkAxis::BOTTOM, axis.values.front(), axis.values.back());
  chart.write(png, levels);
}

void plot_mechanistic(const ResultsFolder& results, const std::filesystem::path& png,
                      const std::vector<LabelledForce>& published) {
  const HistoryTable model = load(results.mechanistic());
  const Axis axis = horizontal_axis(model);
  const std::vector<Curve> curves = force_curves(model);
  const std::vector<Level> levels = levels_of(published);
  const auto [least, most] = vertical_range(curves, levels);
  Chart chart("Force on the tool, mechanistic model", axis.title, "Force [N]");
  for (const Level& level : levels)
    chart.add({axis.values.front(), axis.values.back()},
              {"", {level.value, level.value}, grey, 2.5, vtkPen::DASH_LINE});
  for (const Curve& curve : curves) chart.add(axis.values, curve);
  chart.set_range(vtkAxis::LEFT, least, most);
  chart.set_range(vtkAxis::BOTTOM, axis.values.front(), axis.values.back());
  chart.write(png, levels);
}

void plot_energies(const ResultsFolder& results, const std::filesystem::path& png) {
  const HistoryTable history = load(results.history());
  const Axis axis = horizontal_axis(history);
  const std::vector<std::pair<const char*, Colour>> terms{
      {"plastic_work", vermilion}, {"friction_work", orange},   {"elastic_energy", blue},
      {"kinetic_energy", sky},     {"viscous_work", green},     {"hourglass_work", purple},
      {"contact_energy", grey},    {"tie_work", {150, 110, 60}}};

  double largest = largest_of(history.at("external_work"));
  for (const auto& term : terms) largest = std::max(largest, largest_of(history.at(term.first)));
  const auto [scale, unit] = largest < 1e-6   ? std::pair(1e9, "nJ")
                             : largest < 1e-3 ? std::pair(1e6, "\u00b5J")
                             : largest < 1    ? std::pair(1e3, "mJ")
                                              : std::pair(1.0, "J");
  const auto scaled = [&, scale = scale](const char* name) {
    std::vector<double> values = history.at(name);
    for (double& v : values) v *= scale;
    return values;
  };
  const auto label = [](std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
  };
  std::vector<Curve> curves{{"external work", scaled("external_work"), black, 5}};
  for (const auto& [name, colour] : terms) {
    const auto values = scaled(name);
    if (largest_of(values) > 0) curves.push_back({label(name), values, colour, 3});
  }
  curves.push_back({"energy residual", scaled("energy_residual"), black, 2.5, vtkPen::DASH_LINE});

  Chart chart("Energy", axis.title, fmt::format("Energy [{}]", unit));
  for (const Curve& curve : curves) chart.add(axis.values, curve);
  const auto [least, most] = vertical_range(curves, {});
  chart.set_range(vtkAxis::LEFT, least, most);
  chart.set_range(vtkAxis::BOTTOM, axis.values.front(), axis.values.back());
  chart.write(png, {});
}

bool plot_heat(const ResultsFolder& results, const std::filesystem::path& png) {
  const HistoryTable history = load(results.history());
  const auto& plastic = history.at("plastic_heat");
  const auto& friction = history.at("friction_work");
  const double most = plastic.back() + friction.back();
  Axis axis = horizontal_axis(history);
  std::vector<std::size_t> rows; // where a hundredth of it has been made: a share of next to nothing is noise
  for (std::size_t k = 0; k < plastic.size(); ++k)
    if (most > 0 && plastic[k] + friction[k] > 0.01 * most) rows.push_back(k);
  if (rows.size() < 2) return false;
  std::vector<double> x;
  for (const std::size_t k : rows) x.push_back(axis.values[k]);
  const auto share_of = [&](const std::vector<double>& values) {
    std::vector<double> shares;
    for (const std::size_t k : rows) shares.push_back(100 * values[k] / (plastic[k] + friction[k]));
    return shares;
  };
  const std::vector<Curve> curves{
      {"in the work and the chip", share_of(history.at("work_heat")), vermilion, 4},
      {"in the tool", share_of(history.at("tool_heat")), blue, 4},
      {"gone through held faces", share_of(history.at("heat_out")), green, 3},
      {"made by friction", share_of(friction), orange, 3, vtkPen::DASH_LINE},
      {"missing in the books", share_of(history.at("heat_residual")), black, 2.5, vtkPen::DASH_LINE}};
  Chart chart("Where the heat goes", axis.title, "Share of the heat made [%]");
  for (const Curve& curve : curves) chart.add(x, curve);
  chart.set_range(vtkAxis::LEFT, 0, 100);
  chart.set_range(vtkAxis::BOTTOM, x.front(), x.back());
  chart.write(png, {});
  return true;
}

} // namespace swarf
