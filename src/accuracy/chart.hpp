// The measured chart of accuracy against cost (docs/reports/accuracy_cost.md), as the key run.accuracy reads
// it: compiled in, so that the program has it wherever it runs.
#pragma once
#include "src/deck/deck.hpp"

namespace swarf {

// Settings that were measured, in terms that carry over to another deck, and what came out of them. Errors
// are of the mean cutting force, relative to the chart's reference.
struct ChartPoint {
  std::string label;
  int runs = 1;               // 3: the mean of three runs, at three uncut thicknesses
  double chip_rows = 0;       // particles across the uncut chip
  int slice_rows = 0;         // particles along the periodic slice
  double wave_over_speed = 0; // wave speed of the scaled mass / cutting speed
  double courant = 0;
  bool bulk = true; // hexes behind the particles, tied; else these are fixed there
  ParticlesDeck particles;
  double sleep_rows = 0;           // sleep.distance in spacings; 0: nothing was frozen
  double run_in = 0, measured = 0; // cut before the mean and while it was taken, in uncut chips
  double error = 0, standard_error = 0;
  std::optional<double>
      level;       // most of |error| + standard error, here and at finer spacings; none: not advised
  double step = 0; // mean time step / (spacing / wave speed of the scaled mass)
  double seconds_per_particle_step = 0; // of one core of the machine that measured
};

// Windows of a pass (src/windows/windows.hpp) against the whole pass in the same cells
// (docs/reports/windows.md): the mean force over the windows.
struct WindowsPoint {
  double chip_rows = 0;                    // particles across the uncut chip
  int count = 0;                           // windows, spread over the pass
  double run_in = 0, width = 0, ahead = 0; // rad
  double error = 0, standard_error = 0;
};

struct AccuracyChart {
  ToolKind tool;                       // wedge or end_mill
  std::string title, deck;             // of the scene that was measured
  std::string where;                   // the mean force was taken: "at immersion 76 to 81 deg"
  double uncertainty = 0;              // of the reference, relative
  double edge_over_chip = 0, rake = 0; // deg
  double depth = 0; // of the particles below the cut (of a mill's: below the bore), in uncut chips
  std::vector<ChartPoint> points;
  std::vector<WindowsPoint> windows; // none: windows were not measured with this tool
};

// Throws std::runtime_error: unknown keys of [particles] and missing values are faults.
std::vector<AccuracyChart> read_accuracy_charts(const std::string& toml);

// Those of src/accuracy/chart.toml.
const std::vector<AccuracyChart>& accuracy_charts();

} // namespace swarf
