#include "src/windows/join_windows.hpp"
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace swarf {
namespace {

constexpr double degree = std::numbers::pi / 180;

// As the deck says it, without the last bits of the conversion.
double in_degrees(double angle) { return std::round(angle / degree * 1e9) / 1e9; }

struct Sample {
  double place, weight; // 0 to 1 along the measurement; time
  std::array<double, 4> force;
};

// Samples are means since the one before.
std::vector<Sample> select(const HistoryTable& history, double from, double to) {
  const auto &angle = history.at("immersion"), &time = history.at("time");
  const auto &x = history.at("force_x"), &y = history.at("force_y"), &z = history.at("force_z");
  std::vector<Sample> samples;
  for (std::size_t k = 1; k < history.rows(); ++k) {
    const double place = (0.5 * (angle[k - 1] + angle[k]) - from) / (to - from);
    if (place >= 0 && place < 1) samples.push_back({place, time[k] - time[k - 1], {x[k], y[k], z[k], 0}});
  }
  return samples;
}

std::array<double, 4> mean_of(const std::vector<Sample>& samples, double from, double to) {
  std::array<double, 4> sum{};
  double weight = 0;
  for (const Sample& s : samples) {
    if (s.place < from || s.place >= to) continue;
    weight += s.weight;
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += s.weight * s.force[c];
  }
  for (double& value : sum) value /= weight; // NaN without samples
  return sum;
}

// Standard error of the mean, from the means of blocks about their line.
std::array<double, 4> error_of(const std::vector<Sample>& samples, int blocks) {
  std::array<double, 4> error{};
  std::vector<std::array<double, 4>> means;
  for (int b = 0; b < blocks; ++b)
    means.push_back(mean_of(samples, double(b) / blocks, double(b + 1) / blocks));
  for (std::size_t c = 0; c < error.size(); ++c) {
    double mean = 0, slope = 0, squares = 0, residual = 0;
    const auto place = [&](int b) { return b - 0.5 * (blocks - 1); };
    for (int b = 0; b < blocks; ++b) mean += means[std::size_t(b)][c] / blocks;
    for (int b = 0; b < blocks; ++b)
      slope += place(b) * (means[std::size_t(b)][c] - mean), squares += place(b) * place(b);
    slope /= squares;
    for (int b = 0; b < blocks; ++b)
      residual += std::pow(means[std::size_t(b)][c] - mean - slope * place(b), 2);
    error[c] = std::sqrt(residual / (blocks - 2) / blocks);
  }
  return error;
}

} // namespace

MeanForce measure_force(const HistoryTable& history, double from, double to) {
  std::vector<Sample> samples = select(history, from, to);
  if (samples.empty())
    throw ResultsError(fmt::format("the history has no sample between {:.6g} and {:.6g} deg", from, to));
  MeanForce force;
  force.mean = mean_of(samples, 0, 1);
  force.mean[3] = std::hypot(force.mean[0], force.mean[1]);
  // Each sample along the mean: lengths of noisy vectors would count the noise as force.
  if (force.mean[3] > 0)
    for (Sample& s : samples)
      s.force[3] = (s.force[0] * force.mean[0] + s.force[1] * force.mean[1]) / force.mean[3];
  force.error.fill(std::numeric_limits<double>::quiet_NaN());
  for (const int blocks : {16, 8, 4}) {
    const auto error = error_of(samples, blocks);
    for (std::size_t c = 0; c < error.size(); ++c)
      if (!(force.error[c] > error[c]) && !std::isnan(error[c])) force.error[c] = error[c];
  }
  return force;
}

double scatter_between(const std::vector<double>& immersion, const std::vector<double>& force) {
  double squares = 0;
  int count = 0;
  for (std::size_t k = 1; k + 1 < force.size(); ++k) {
    const double step = immersion[k] - immersion[k - 1], next = immersion[k + 1] - immersion[k];
    if (std::abs(next - step) > 1e-6 * step) continue; // one is missing
    const double c = std::cos(step * degree);          // a sine drops out of the difference
    squares += std::pow(force[k - 1] - 2 * c * force[k] + force[k + 1], 2) / (2 + 4 * c * c);
    ++count;
  }
  return count < 3 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(squares / count);
}

double predict_whole_pass(const Deck& whole, const std::vector<WindowResult>& results) {
  double seconds = 0, effort = 0;
  for (const WindowResult& result : results)
    if (result.is_complete()) seconds += result.core_seconds, effort += find_effort(result.window.deck);
  return effort > 0 ? seconds / effort * find_effort(whole) : 0;
}

void write_windows(const PassFolder& folder, const Deck& whole, const std::vector<WindowResult>& results,
                   double wall_seconds) {
  std::string table = "immersion [deg],force_x [N],force_y [N],force_z [N],force_planar [N],error_x [N],"
                      "error_y [N],error_z [N],error_planar [N],uncut_chip [m],core_seconds [s]\n";
  Json windows;
  std::string unfinished;
  double core_seconds = 0;
  std::vector<double> immersion, force;
  for (const WindowResult& r : results) {
    core_seconds += r.core_seconds;
    Json one;
    one.set("immersion", in_degrees(r.window.centre))
        .set("ended", r.ended)
        .set("core_seconds", r.core_seconds);
    if (r.is_complete()) {
      const auto &mean = r.force.mean, &error = r.force.error;
      table += fmt::format("{},{},{},{}\n", in_degrees(r.window.centre), fmt::join(mean, ","),
                           fmt::join(error, ","), fmt::format("{},{}", r.window.uncut_chip, r.core_seconds));
      immersion.push_back(in_degrees(r.window.centre)), force.push_back(mean[3]);
      one.set("force_planar", mean[3]).set("error_planar", error[3]).set("uncut_chip", r.window.uncut_chip);
    } else {
      unfinished += (unfinished.empty() ? "" : ", ") + r.window.name;
    }
    windows.set(r.window.name, one);
  }
  Json summary;
  summary.set("title", whole.title).set("unfinished", unfinished);
  summary.set("core_seconds", core_seconds).set("wall_seconds_of_last_call", wall_seconds);
  summary.set("predicted_core_seconds_of_whole_pass", predict_whole_pass(whole, results));
  summary.set("scatter_between_windows", scatter_between(immersion, force)).set("windows", windows);
  write_file(folder.table(), table);
  write_file(folder.summary(), summary.text() + "\n");
}

} // namespace swarf
