// What a run comes to: summary.json and the closing lines on the terminal.
#pragma once
#include "src/results.hpp"
#include "src/simulation.hpp"

namespace swarf {

// From history.csv and the simulation: counts, cost, forces (filtered peak, means of the last half),
// energies, final shape. `ended` is "complete", "interrupted" or the fault's message.
void write_summary(const ResultsFolder& folder, const Deck& deck, const Simulation& simulation,
                   const std::string& ended, double seconds, int leaked);

// Per-phase times and speed.
void report(const Simulation& simulation, double seconds);

} // namespace swarf
