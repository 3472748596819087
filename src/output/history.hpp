// What is sampled along a run. One row per history sample; columns declared once.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace swarf {

struct ResultsFolder;

inline constexpr int max_teeth = 8;

// SI. Forces act on the workpiece's cutting counterpart, the tool; scaled by output.force_scale.
struct HistorySample {
  double time = 0, immersion = 0; // s, deg
  double step = 0;
  double dt = 0;
  std::array<double, 3> force{}; // N, on the tool, mean over the steps since the sample before
  double torque = 0;             // N m about the tool's axis
  std::array<std::array<double, 3>, max_teeth> tooth_force{};
  // J, since the start
  double kinetic = 0, elastic = 0, plastic = 0, frictional = 0, viscous = 0, hourglass = 0, contact = 0,
         tie = 0, shifting = 0;
  double external = 0, residual = 0;   // residual = (all of the above - initial) - external
  double plastic_heat = 0;             // J, made by plastic work; friction_work is the other source
  double work_heat = 0, tool_heat = 0; // J, stored since the start
  double heat_out = 0;                 // J, that has left through what is held
  double heat_residual = 0;            // J, stored and gone, less what was made
  double tool_hottest = 0;             // K, of a tool that conducts, and where in its frame, m
  std::array<double, 3> tool_hottest_at{};
  double max_temperature = 0, max_plastic_strain = 0, max_velocity = 0;
  double particles_in_contact = 0;
};

struct HistoryColumn {
  std::string name, unit; // unit "1": a pure number
};

// The columns of history.csv, and one row in the same order.
std::vector<HistoryColumn> history_columns(int teeth);
std::vector<double> history_row(const HistorySample& sample, int teeth);

// history.csv while the run goes on: each sample is one line, written at once, so that a killed run leaves a
// file that can be read. Errors are ResultsError.
class HistoryFile {
 public:
  HistoryFile(const std::filesystem::path& file, int teeth); // a new file
  HistoryFile(const std::filesystem::path& file, int teeth,
              long rows); // restart: keeps the first `rows` samples
  ~HistoryFile();
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  void append(const HistorySample& sample);
  long rows() const { return count; }

 private:
  void write(const std::string& line);
  std::filesystem::path name;
  int descriptor = -1, teeth = 0;
  long count = 0;
};

struct HistoryTable {
  std::vector<HistoryColumn> columns;
  std::vector<std::vector<double>> values; // values[column][row]

  std::size_t rows() const { return values.empty() ? 0 : values[0].size(); }
  bool has(const std::string& column) const;
  const std::vector<double>& at(const std::string& column) const; // ResultsError if it is not there
};

void write_table(const HistoryTable& table, const std::filesystem::path& file);

// A last line without its end (a run killed in the middle of a write) is left out.
HistoryTable read_history(const std::filesystem::path& file);

// Zero-phase (forward and backward) second-order Butterworth low pass over unevenly spaced samples, resampled
// evenly first (linear). frequency in Hz; at it the amplitude is 1/2, at others 1 / (1 + r^4) with
// r = tan(pi f T) / tan(pi frequency T), T the mean spacing. The ends are continued by odd reflection.
// A frequency of half the sampling rate or more leaves the values as they are.
// Throws std::invalid_argument if the times do not increase or the sizes differ.
std::vector<double> low_pass(const std::vector<double>& time, const std::vector<double>& value,
                             double frequency);
// For output.filter_frequency = 0: forty periods in the recorded time.
double default_filter_frequency(const std::vector<double>& time);

// time, immersion, and force_x, _y, _z, force_planar, torque through the low pass. force_planar is the
// resultant of the filtered components: that of the raw ones would count the noise as force.
HistoryTable filter_history(const HistoryTable& history, double frequency);

// results.h5 and history_filtered.csv from history.csv, each replaced as a whole: at checkpoints and at the
// end.
void write_history_results(const ResultsFolder& results, double filter_frequency);

} // namespace swarf
