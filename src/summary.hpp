// What a run comes to: summary.json and the closing lines on the terminal.
#pragma once
#include "src/results.hpp"
#include "src/simulation.hpp"

namespace swarf {

// From history.csv and the simulation: counts, cost, forces (filtered peak, means of the last half),
// energies, final shape. `ended` is "complete", "interrupted" or the fault's message.
void write_summary(const ResultsFolder& folder, const Deck& deck, const Simulation& simulation,
                   const std::string& ended, double seconds, int leaked);

// Particles that have left for good, and of them those that the tool or the work has met since.
struct RetiredCount {
  int all = 0, met = 0;
};
RetiredCount count_retired(const Particles&);

// Per-phase times and speed.
void report(const Simulation& simulation, double seconds);

} // namespace swarf
