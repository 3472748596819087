// What a run comes to: summary.json and the closing lines on the terminal.
#pragma once
#include "src/run/recorder.hpp"
#include "src/run/run.hpp"
#include "src/simulation/simulation.hpp"

namespace swarf {

struct RunFacts {
  const ResultsFolder& folder;
  const Deck& deck;
  const Simulation& simulation;
  const Recorder& recorder;
  const RunEnding& ending;
};

// From history.csv and the simulation: how it ended and why, warnings, counts, cost, forces (filtered peak,
// means of the last half), energies, final shape.
void write_summary(const RunFacts& run, double seconds);

// Particles that have left for good, and of them those that the tool or the work has met since.
struct RetiredCount {
  int all = 0, met = 0;
};
RetiredCount count_retired(const Particles&);

// Per-phase times and speed.
void report(const Simulation& simulation, double seconds);

} // namespace swarf
