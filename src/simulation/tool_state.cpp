// What the tool is asked for between steps: what its surface has felt, and temperatures that one run hands to
// the next.
#include "src/files/say.hpp"
#include "src/output/restart_deck.hpp"
#include "src/output/tool_heat_file.hpp"
#include "src/simulation/simulation.hpp"
#include "src/tool/cells.hpp"
#include <fmt/format.h>

namespace swarf {
namespace {

constexpr double most_idle_steps = 1e8;

// What two runs must have in common for the temperatures to mean the same.
std::string identity_of(const Deck& deck, const Scene& scene) {
  const MaterialDeck& m = *find_material(deck, deck.tool->material);
  return fmt::format("facets = {}\ndensity = {}\nspecific_heat = {}\nconductivity = {}\n", facets_text(scene),
                     m.density, m.specific_heat.value, m.conductivity.value);
}

} // namespace

ToolFields Simulation::take_tool_fields() {
  if (!deck.tool) return {};
  ToolFields fields = copy_tool_fields(model.tool, now - shown_since);
  const auto wear = std::make_pair(0, int(sum_wear)); // all before it
  Kokkos::deep_copy(Kokkos::subview(model.tool.surface.sums, Kokkos::ALL, wear), Real(0));
  shown_since = now;
  return fields;
}

void Simulation::write_tool_heat(const ResultsFolder& results) const {
  if (model.tool.heat.cells > 0)
    swarf::write_tool_heat(results.tool_heat(), identity_of(deck, model), model.tool.heat);
}

// The books begin after the idle time: what has left the tool till then is not of this run.
void Simulation::take_tool_temperature() {
  if (!deck.tool || deck.tool->temperature_from.empty()) return;
  const ToolHeat& heat = model.tool.heat;
  read_tool_heat(ResultsFolder{deck.tool->temperature_from}.tool_heat(), identity_of(deck, model), heat);
  const double before = double(sum_heat(heat).tool_hottest), idle = deck.tool->idle_time;
  if (!(idle <= most_idle_steps * tool_heat_step))
    throw DeckError(fmt::format("{}: tool.idle_time: makes {:.3g} steps of conduction in the tool, of {:.3g} "
                                "s: expected at most {:.0e}. "
                                "Take a shorter time, or a larger spacing",
                                deck.file, idle / tool_heat_step, tool_heat_step, most_idle_steps));
  idle_tool(heat, idle, tool_heat_step);
  Kokkos::deep_copy(heat.out, Real(0));
  const HeatSums sums = sum_heat(heat);
  initial_tool_heat = double(sums.tool);
  say("tool: {:.1f} K at its hottest after {}, {:.1f} K after {:.4g} s of idling\n", before,
      deck.tool->temperature_from, double(sums.tool_hottest), idle);
}

} // namespace swarf
