#include "src/deck_checks.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace swarf {
namespace {

// Methods that conversion has no rule for: the key in its section, and what to write instead.
void refuse_methods(const Deck& deck, const toml::table& root, DeckReport& report) {
  const auto refuse = [&](bool is_wrong, const char* section, const char* key, const std::string& instead) {
    if (is_wrong)
      report.add(find_place(*root[section].as_table(), key), fmt::format("{}.{}", section, key),
                 "does not go with hexes that become particles (body.convert_distance, convert_strain). " +
                     instead);
  };
  refuse(deck.particles.kernel_frame == "initial", "particles", "kernel_frame",
         "Neighbours stay what they were at the start: use \"current\"");
  refuse(deck.particles.density == "summation", "particles", "density",
         "New particles have no sum of the start to compare with: use \"continuity\"");
  refuse(deck.sleep.distance.has_value(), "sleep", "distance", "Leave it out");
  refuse(deck.hexes.delete_failed, "hexes", "delete_failed", "Leave it out");
  refuse(deck.hexes.delete_at_strain.has_value(), "hexes", "delete_at_strain", "Leave it out");
}

} // namespace

void check_conversion(const Deck& deck, const toml::table& root, DeckReport& report) {
  const toml::array& bodies = *root["body"].as_array();
  bool any = false;
  for (std::size_t i = 0; i < deck.bodies.size(); ++i) {
    const BodyDeck& body = deck.bodies[i];
    const toml::table& table = *bodies.get(i)->as_table();
    any = any || body.converts();
    if (!body.converts() && body.convert_particles != 2) // the default, which the resolved deck writes
      report.add(find_place(table, "convert_particles"), "body.convert_particles",
                 "nothing says when hexes become particles. Give convert_distance or convert_strain");
    if (body.convert_distance && !deck.tool)
      report.add(find_place(table, "convert_distance"), "body.convert_distance",
                 "there is no [tool] to come near. Add one, or use convert_strain");
    const bool converts = std::any_of(deck.bodies.begin(), deck.bodies.end(),
                                      [](const BodyDeck& other) { return other.converts(); });
    if (converts && !body.tie.empty())
      report.add(find_place(table, "tie"), "body.tie",
                 "does not go with hexes that become particles, which are tied as they come to be. Fill this "
                 "body with hexes that convert, or leave convert_distance and convert_strain out");
  }
  if (any) refuse_methods(deck, root, report);
}

} // namespace swarf
