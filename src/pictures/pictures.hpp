// The pictures of a results folder, made from what the folder holds.
#pragma once
#include "src/plots/plot.hpp"
#include <string>

namespace swarf {

// pictures/force.png, energy.png, and heat.png where heat was made; windows.png of a pass in windows. Throws
// ResultsError, DeckError.
void draw_plots(const std::string& results);

// windows.png of a pass that was run in windows; what cannot be drawn is said, never thrown.
void draw_windows(const std::string& results);

// Plots and chip pictures at the end of a run: what cannot be drawn (no display) is said, never thrown.
void draw_all(const std::string& results);

} // namespace swarf
