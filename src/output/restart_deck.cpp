#include "src/output/restart_deck.hpp"
#include "src/files/results.hpp"
#include <fmt/format.h>

namespace swarf {

std::string facets_text(const Scene& scene) {
  if (scene.tool_facets.empty()) return "";
  std::string corners;
  for (const auto& facet : scene.tool_facets)
    for (const Triple& corner : facet)
      corners.append(reinterpret_cast<const char*>(corner.data()), 3 * sizeof(corner[0]));
  return fmt::format("facets = {} with the checksum {}", scene.tool_facets.size(), hash_text(corners));
}

std::string restart_text(const Deck& deck, const Scene& scene) {
  Deck physics = deck;
  physics.title.clear(), physics.picked.reset(), physics.windows.reset();
  physics.mechanistic.reset();
  physics.output = OutputDeck{};
  physics.output.force_scale = deck.output.force_scale; // of rows that are written already
  physics.run.accuracy.reset();
  if (!deck.tool || deck.tool->material.empty()) // else the tool's cells go as far as heat gets by the end
    physics.run.end_time.reset(), physics.run.end_immersion.reset();
  physics.run.threads = 0, physics.run.energy_tolerance = physics.run.energy_limit = 0;
  if (physics.tool) physics.tool->file.clear();
  std::string text = resolved_deck(physics);
  if (!deck.tool) return text;
  return text + fmt::format("\n[the tool's surface]\n{}\n", facets_text(scene));
}

} // namespace swarf
