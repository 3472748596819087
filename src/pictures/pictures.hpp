// The pictures of a results folder, made from what the folder holds.
#pragma once
#include "src/surface/surface.hpp"
#include <string>

namespace swarf {

// pictures/force.png, energy.png, and heat.png where heat was made; windows.png of a pass in windows. Throws
// ResultsError, DeckError.
void draw_plots(const std::string& results);

// windows.png of a pass that was run in windows; what cannot be drawn is said, never thrown.
void draw_windows(const std::string& results);

// surface_stress.png, surface_strain.png, surface_temperature.png; without a display it says so.
void draw_surface(const std::string& results, const SurfaceReport& report);

// Plots and chip pictures at the end of a run: what cannot be drawn (no display) is said, never thrown.
void draw_all(const std::string& results);

} // namespace swarf
