// Curves of a run as PNG, from its history.
#pragma once
#include "src/deck/deck.hpp"
#include "src/plots/chart.hpp"
#include "src/surface/surface.hpp"
#include "src/windows/join_windows.hpp"

namespace swarf {

// Forces on the tool against the immersion angle (against time for scenes without a spindle): raw thin and
// pale, filtered thick; the published values as labelled dashed lines, the mechanistic model, if there is
// one, dotted. filter_frequency as in the deck. Needs a Display. Throws ResultsError if the history has fewer
// than two samples.
void plot_forces(const ResultsFolder& results, const std::filesystem::path& png,
                 const std::vector<LabelledForce>& published, double filter_frequency);

// The mechanistic model's forces alone, from mechanistic.csv.
void plot_mechanistic(const ResultsFolder& results, const std::filesystem::path& png,
                      const std::vector<LabelledForce>& published);

// The mechanistic model's resultant between two immersions, deg, which go to `at`; no values where there is
// no model.
Curve read_model(const std::filesystem::path& csv, double from, double to, std::vector<double>& at);

// The energy ledger over the same axis: where the external work went, and the residual.
void plot_energies(const ResultsFolder& results, const std::filesystem::path& png);

// Where the heat is that plastic work and friction have made since the start: shares of it in the work, in
// the tool, gone through what is held, over the same axis; and what the books miss. False where none was
// made.
bool plot_heat(const ResultsFolder& results, const std::filesystem::path& png);

// Force over immersion from windows.csv, with bars of one standard error, own or of the scatter between
// windows. Needs a Display. Throws ResultsError.
void plot_windows(const PassFolder& folder, const std::vector<LabelledForce>& published);

// surface_stress.png, surface_strain.png, surface_temperature.png; without a display it says so.
void draw_surface(const std::string& results, const SurfaceReport& report);

} // namespace swarf
