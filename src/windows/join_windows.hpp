// What the windows of a pass gave, as one curve of force over immersion.
#pragma once
#include "src/files/results.hpp"
#include "src/output/history.hpp"
#include "src/windows/windows.hpp"

namespace swarf {

// N: x, y, z and the planar resultant of the means of x and y.
struct MeanForce {
  std::array<double, 4> mean{}, error{};
};

// Over the immersions between `from` and `to`, deg. The standard error is that of 16, 8 and 4 block means
// about a straight line, the largest of the three: short blocks of a force that swings slowly look surer than
// they are. NaN where samples are too few for any. Throws ResultsError where there is no sample at all.
MeanForce measure_force(const HistoryTable& history, double from, double to);

struct WindowResult {
  Window window;
  std::string ended;       // complete | interrupted | not run | what went wrong
  double core_seconds = 0; // of all its runs
  MeanForce force;         // of complete ones
  bool is_complete() const { return ended == "complete"; }
};

struct PassFolder {
  std::filesystem::path path;

  std::filesystem::path table() const { return path / "windows.csv"; }
  std::filesystem::path summary() const { return path / "windows.json"; }
  std::filesystem::path deck() const { return path / "windows.toml"; } // of the whole pass, resolved
  std::filesystem::path picture() const { return path / "windows.png"; }
};

// Standard deviation of single windows about a sine of the immersion (deg): what their own errors do not see,
// swings longer than a measurement. From each three evenly spaced neighbours; NaN with fewer than five
// windows. A part that does not follow a sine counts as scatter, 2 - 2 cos(step) of it.
double scatter_between(const std::vector<double>& immersion, const std::vector<double>& force);

// windows.csv (complete ones only) and windows.json.
void write_windows(const PassFolder& folder, const Deck& whole, const std::vector<WindowResult>& results,
                   double wall_seconds);

// Core-seconds that the whole pass would take, from what the complete windows took; 0 without any.
double predict_whole_pass(const Deck& whole, const std::vector<WindowResult>& results);

} // namespace swarf
