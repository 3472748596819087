#include "src/deck/checks.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace swarf {
namespace {

// What the initial frame leaves no meaning, or has no kernel for.
void check_kernel_frame(const Deck& deck, const toml::table& root, DeckReport& report) {
  const ParticlesDeck& p = deck.particles;
  if (p.kernel_frame != KernelFrame::initial) return;
  const toml::table& table = *root["particles"].as_table();
  const auto refuse = [&](bool is_wrong, const std::string& key, const std::string& instead) {
    if (is_wrong)
      report.add(find_place(table, key), "particles." + key,
                 "does not go with kernel_frame = \"initial\". " + instead);
  };
  refuse(p.smoothing_length == SmoothingLength::evolving, "smoothing_length",
         "Kernels do not stretch with the body: use \"fixed\"");
  refuse(p.density == DensityRule::summation, "density",
         "It is that of the deformation gradient: use \"continuity\"");
  refuse(!p.correction, "correction", "At a free surface a body at rest would be strained: use true");
  refuse(!p.correct_forces, "correct_forces", "Stresses would not be pulled back: use true");
  refuse(p.pressure_diffusion > 0, "pressure_diffusion", "It acts between present neighbours: use 0");
  if (deck.sleep.distance)
    report.add(
        find_place(table, "kernel_frame"), "particles.kernel_frame",
        "\"initial\" does not go with sleep.distance: neighbours stay what they were at the start. Leave it "
        "out, or use \"current\"");
  if (conducts_heat(deck))
    report.add(find_place(table, "kernel_frame"), "particles.kernel_frame",
               "\"initial\" conducts no heat: give no material a conductivity, or use \"current\"");
}

// A particle that sees few others has a sum that goes as h^-3: h that follows it has nothing to hold it.
void check_evolving(const Deck& deck, const toml::table& root, DeckReport& report) {
  if (deck.particles.smoothing_length == SmoothingLength::evolving &&
      deck.particles.density == DensityRule::summation)
    report.add(
        find_place(*root["particles"].as_table(), "smoothing_length"), "particles.smoothing_length",
        "\"evolving\" does not go with density = \"summation\": a lone particle would grow without end. "
        "Use density = \"continuity\", or \"fixed\"");
}

void check_retire(const Deck& deck, const toml::table& root, DeckReport& report) {
  if (!deck.retire.distance) return;
  const toml::node& place = find_place(*root["retire"].as_table(), "distance");
  if (!deck.tool) report.add(place, "retire.distance", "needs a tool, which makes the chip. Leave it out");
  if (!deck.sleep.distance)
    report.add(
        place, "retire.distance",
        "needs sleep.distance, by which the run looks at what is far. Give it (\"1 m\": all is active)");
}

// Methods that conversion has no rule for: the key in its section, and what to write instead.
void refuse_methods(const Deck& deck, const toml::table& root, DeckReport& report) {
  const auto refuse = [&](bool is_wrong, const char* section, const char* key, const std::string& instead) {
    if (is_wrong)
      report.add(find_place(*root[section].as_table(), key), fmt::format("{}.{}", section, key),
                 "does not go with hexes that become particles (body.convert_distance, convert_strain). " +
                     instead);
  };
  refuse(deck.particles.kernel_frame == KernelFrame::initial, "particles", "kernel_frame",
         "Neighbours stay what they were at the start: use \"current\"");
  refuse(deck.particles.density == DensityRule::summation, "particles", "density",
         "New particles have no sum of the start to compare with: use \"continuity\"");
  refuse(deck.sleep.distance.has_value(), "sleep", "distance", "Leave it out");
  refuse(deck.hexes.delete_failed, "hexes", "delete_failed", "Leave it out");
  refuse(deck.hexes.delete_at_strain.has_value(), "hexes", "delete_at_strain", "Leave it out");
}

// Hexes that become particles: what that needs and what it does not go with.
void check_conversion(const Deck& deck, const toml::table& root, DeckReport& report) {
  const toml::array& bodies = *root["body"].as_array();
  bool any = false;
  for (std::size_t i = 0; i < deck.bodies.size(); ++i) {
    const BodyDeck& body = deck.bodies[i];
    const toml::table& table = *bodies.get(i)->as_table();
    any = any || body.converts();
    const int by_default = BodyDeck(body.shape, body.fill).convert_particles; // the resolved deck writes it
    if (!body.converts() && body.convert_particles != by_default)
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

// Heat that crosses a face has to go on inside; what else heat brings has a rule in all but conversion.
void check_heat(const Deck& deck, const toml::table& root, DeckReport& report) {
  const toml::array& bodies = *root["body"].as_array();
  for (std::size_t i = 0; i < deck.bodies.size(); ++i) {
    const BodyDeck& body = deck.bodies[i];
    const MaterialDeck* m = find_material(deck, body.material);
    const toml::table& table = *bodies.get(i)->as_table();
    if (!m) continue; // reported
    for (const FaceDeck& face : body.faces) {
      const toml::node& place = face.temperature ? find_place(*table["faces"].as_table(), face.face) : table;
      const std::string key = "body.faces." + face.face;
      if (face.temperature && m->conductivity.greatest() == 0)
        report.add(place, key,
                   fmt::format("lets heat through, but [material.{}] has no conductivity. Give it one, or "
                               "leave temperature out",
                               m->name));
      if (face.temperature && body.converts())
        report.add(place, key,
                   "heat through faces does not go with hexes that become particles (convert_distance, "
                   "convert_strain). Leave temperature out, or them");
    }
    if (!m->specific_heat.points.empty() && body.converts())
      report.add(find_place(table, "material"), "body.material",
                 fmt::format("[material.{}] has a table of specific_heat, which does not go with hexes that "
                             "become particles (convert_distance, convert_strain). Give one value",
                             m->name));
    for (const BodyDeck& other : deck.bodies)
      if (m->damage && m->thermal_expansion > 0 && other.material == body.material &&
          other.temperature != deck.bodies[i].temperature && &other < &body)
        report.add(find_place(table, "temperature"), "body.temperature",
                   fmt::format("expected {} K, as body \"{}\" of the same material: what has failed is "
                               "compared with the density at one temperature. Copy the material under "
                               "another name",
                               other.temperature, other.name));
  }
  for (const MaterialDeck& m : deck.materials) {
    const bool has_tables = !m.conductivity.points.empty() || !m.specific_heat.points.empty();
    if (m.law == Law::rigid && has_tables)
      report.add(find_place(*root["material"][m.name].as_table(),
                            m.conductivity.points.empty() ? "specific_heat" : "conductivity"),
                 "material." + m.name, "a rigid tool has no tables over temperature. Give one value");
  }
}

// A rigid material is for the tool, and the tool's is rigid; heat crosses into what conducts.
void check_tool_heat(const Deck& deck, const toml::table& root, DeckReport& report) {
  const toml::array& bodies = *root["body"].as_array();
  const bool conducts = deck.tool && !deck.tool->material.empty();
  for (std::size_t i = 0; i < deck.bodies.size(); ++i) {
    const MaterialDeck* m = find_material(deck, deck.bodies[i].material);
    if (!m) continue; // reported
    const toml::node& place = find_place(*bodies.get(i)->as_table(), "material");
    if (m->law == Law::rigid)
      report.add(
          place, "body.material",
          fmt::format("[material.{}] has law = \"rigid\", which is for a tool. Name another", m->name));
    else if (conducts && m->conductivity.greatest() == 0)
      report.add(
          place, "body.material",
          fmt::format("[material.{}] has no conductivity, so no heat can cross to the tool, which has a "
                      "material. Give it one, or leave tool.material out",
                      m->name));
  }
  if (!deck.tool) return;
  const toml::table &tool = *root["tool"].as_table(), &contact = *root["contact"].as_table();
  if (!conducts) {
    if (deck.contact.conductance)
      report.add(find_place(contact, "conductance"), "contact.conductance",
                 "the tool has no material to conduct into. Give tool.material, or leave it out");
    const ToolDeck& t = *deck.tool;
    for (const auto& [key, is_given] :
         {std::pair("held_beyond", t.held_beyond.has_value()),
          std::pair("temperature_from", !t.temperature_from.empty()),
          std::pair("heat_time", t.heat_time.has_value()), std::pair("wear_A", t.wear_A.has_value())})
      if (is_given)
        report.add(find_place(tool, key), std::string("tool.") + key,
                   "the tool has no material, so it has no temperature. Give tool.material, or leave it out");
  }
  if (deck.tool->idle_time > 0 && deck.tool->temperature_from.empty())
    report.add(find_place(tool, "idle_time"), "tool.idle_time",
               "there is no run before this one. Give temperature_from, or leave it out");
  if (deck.tool->wear_A.has_value() != deck.tool->wear_B.has_value())
    report.add(find_place(tool, deck.tool->wear_A ? "wear_A" : "wear_B"),
               deck.tool->wear_A ? "tool.wear_A" : "tool.wear_B",
               "wear needs both of its constants, wear_A and wear_B. Give the other, or leave it out");
  if (!conducts) return;
  const MaterialDeck* m = find_material(deck, deck.tool->material);
  std::vector<std::string> rigid;
  for (const MaterialDeck& other : deck.materials)
    if (other.law == Law::rigid) rigid.push_back(other.name);
  if (!m || m->law != Law::rigid)
    report.add(find_place(tool, "material"), "tool.material",
               m ? fmt::format("[material.{}] deforms. Name one with law = \"rigid\".{}", m->name,
                               suggest(m->name, rigid))
                 : describe_missing(deck.tool->material, rigid));
  if (deck.contact.heat_to_workpiece)
    report.add(
        find_place(contact, "heat_to_workpiece"), "contact.heat_to_workpiece",
        "the tool has a material: friction heat divides by itself. Leave this key out, or tool.material");
}

} // namespace

void check_methods(const Deck& deck, const toml::table& root, DeckReport& report) {
  check_kernel_frame(deck, root, report);
  check_evolving(deck, root, report);
  check_retire(deck, root, report);
  check_conversion(deck, root, report);
  check_heat(deck, root, report);
  check_tool_heat(deck, root, report);
}

} // namespace swarf
