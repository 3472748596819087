#include "src/deck/checks.hpp"
#include "src/deck/library.hpp"
#include "src/files/results.hpp"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>

namespace swarf {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;

bool melts(const MaterialDeck& m) { return m.law == Law::johnson_cook || m.law == Law::johnson_cook_tanh; }

std::vector<std::string> names_in_library() {
  std::vector<std::string> names;
  for (const LibraryMaterial& entry : material_library()) names.push_back(entry.material.name);
  return names;
}

void check_names(const Deck& deck, const toml::array& bodies, DeckReport& report) {
  std::vector<std::string> materials;
  for (const MaterialDeck& material : deck.materials) materials.push_back(material.name);
  for (std::size_t i = 0; i < deck.bodies.size(); ++i) {
    const BodyDeck& body = deck.bodies[i];
    const toml::table& table = *bodies.get(i)->as_table();
    const auto material = std::find(materials.begin(), materials.end(), body.material);
    if (material == materials.end()) {
      report.add(find_place(table, "material"), "body.material", describe_missing(body.material, materials));
    } else if (const MaterialDeck& m = deck.materials[std::size_t(material - materials.begin())];
               melts(m) && body.temperature >= m.melt_temperature) {
      report.add(find_place(table, "temperature"), "body.temperature",
                 fmt::format("expected less than the melt_temperature of {}, {} K, got {} K", m.name,
                             m.melt_temperature, body.temperature));
    }
    for (std::size_t j = 0; j < i; ++j)
      if (deck.bodies[j].name == body.name)
        report.add(find_place(table, "name"), "body.name",
                   fmt::format("\"{}\" is the name of the body of line {} already. Choose another", body.name,
                               deck.bodies[j].line));
  }
}

void check_ties(const Deck& deck, const toml::array& bodies, DeckReport& report) {
  std::vector<std::string> hex_bodies;
  for (const BodyDeck& body : deck.bodies)
    if (body.fill == Fill::hexes) hex_bodies.push_back(body.name);
  for (std::size_t i = 0; i < deck.bodies.size(); ++i) {
    const BodyDeck& body = deck.bodies[i];
    if (body.tie.empty() || std::find(hex_bodies.begin(), hex_bodies.end(), body.tie) != hex_bodies.end())
      continue;
    const bool exists = std::any_of(deck.bodies.begin(), deck.bodies.end(),
                                    [&](const BodyDeck& other) { return other.name == body.tie; });
    const std::string wrong = exists ? "is filled with particles" : "is not a body of this deck";
    report.add(find_place(*bodies.get(i)->as_table(), "tie"), "body.tie",
               fmt::format("\"{}\" {}. Name a body with fill = \"hexes\".{}", body.tie, wrong,
                           suggest(body.tie, hex_bodies)));
  }
}

// What needs a rotating tool.
void check_spindle(const Deck& deck, const toml::table& root, DeckReport& report) {
  const bool has_spindle = deck.tool && deck.tool->spindle_speed > 0;
  const std::string advice = "needs a tool with a spindle_speed";
  const toml::table empty;
  const toml::table& output = root["output"].as_table() ? *root["output"].as_table() : empty;
  if (!has_spindle && deck.output.frame_immersion)
    report.add(find_place(output, "frame_immersion"), "output.frame_immersion", advice + ". Use frame_time");
  if (!has_spindle && !deck.output.picture_immersion.empty())
    report.add(find_place(output, "picture_immersion"), "output.picture_immersion",
               advice + ". Use picture_time");
  if (!deck.run.end_immersion) return;
  const toml::node& end = find_place(*root["run"].as_table(), "end_immersion");
  if (!has_spindle) return report.add(end, "run.end_immersion", advice + ". Use end_time");
  if (*deck.run.end_immersion <= deck.tool->start_angle)
    report.add(end, "run.end_immersion",
               fmt::format("expected more than tool.start_angle = {:.6g} deg, got {:.6g} deg",
                           deck.tool->start_angle * 360 / whole_turn,
                           *deck.run.end_immersion * 360 / whole_turn));
}

// A slice repeats itself along z; an edge that leans does not.
void check_slice(const Deck& deck, const toml::table& root, DeckReport& report) {
  if (!deck.tool) return;
  const bool leans = deck.tool->helix != 0 || deck.tool->inclination != 0;
  for (const BodyDeck& body : deck.bodies)
    for (const FaceDeck& face : body.faces) {
      if (!leans || face.kind != FaceKind::periodic || (face.face != "z_min" && face.face != "bottom"))
        continue;
      const std::string key = deck.tool->kind == ToolKind::wedge ? "inclination" : "helix";
      return report.add(
          find_place(*root["tool"].as_table(), key), "tool." + key,
          fmt::format("an edge that leans does not go with the periodic slice \"{}\" of line {}, which "
                      "repeats itself "
                      "along z. Use \"0 deg\", or leave its faces free and model the whole depth of cut",
                      body.name, body.line));
    }
}

} // namespace

std::string describe_missing(const std::string& material, const std::vector<std::string>& known) {
  if (!names_library(material))
    return fmt::format("there is no [material.{}] in this deck.{}", material, suggest(material, known));
  return fmt::format("there is no \"{}\": swarf materials lists those of the library.{}", material,
                     suggest(material, names_in_library()));
}

void check_material(const MaterialDeck& material, const toml::table& table, DeckReport& report) {
  const std::string path = "material." + material.name;
  if (material.law == Law::zerilli_armstrong && material.C0 + material.C1 <= 0)
    report.add(find_place(table, "C0"), path + ".C0",
               "expected C0 + C1 > 0: without them the material has no strength before it hardens. Give one "
               "of them");
  if (melts(material) && material.melt_temperature <= material.reference_temperature)
    report.add(find_place(table, "melt_temperature"), path + ".melt_temperature",
               fmt::format("expected more than reference_temperature = {} K, got {} K",
                           material.reference_temperature, material.melt_temperature));
}

void check_tool(ToolDeck& tool, const toml::table& table, const FilePlace& place, DeckReport& report) {
  if (tool.kind == ToolKind::end_mill && 2 * tool.runout >= tool.diameter)
    report.add(find_place(table, "runout"), "tool.runout",
               fmt::format("expected less than the mill's radius of {} m, got {} m", tool.diameter / 2,
                           tool.runout));
  if (tool.kind == ToolKind::end_mill && 2 * tool.edge_radius >= tool.diameter)
    report.add(find_place(table, "edge_radius"), "tool.edge_radius",
               fmt::format("expected less than the mill's radius of {} m, got {} m", tool.diameter / 2,
                           tool.edge_radius));
  if ((tool.kind == ToolKind::end_mill || tool.kind == ToolKind::wedge) &&
      tool.rake + tool.clearance >= whole_turn / 4)
    report.add(find_place(table, "clearance"), "tool.clearance",
               "rake and clearance leave nothing of the tool: together they must be less than 90 deg");
  const double edge_height = tool.edge_radius * (1 + std::sin(tool.rake));
  if (tool.kind == ToolKind::wedge && edge_height >= tool.height)
    report.add(find_place(table, "height"), "tool.height",
               fmt::format("expected more than the {} m that the rounded edge takes, got {} m", edge_height,
                           tool.height));
  if (tool.kind == ToolKind::wedge && tool.velocity == Triple{})
    report.add(find_place(table, "velocity"), "tool.velocity",
               "a wedge must move. Give one component a speed");
  if (tool.lift_time && tool.lift_velocity == Triple{})
    report.add(find_place(table, "lift_time"), "tool.lift_time",
               "the tool would stop in the cut. Give lift_velocity, away from the work");
  if (!tool.lift_time && tool.lift_velocity != Triple{})
    report.add(find_place(table, "lift_velocity"), "tool.lift_velocity",
               "nothing says when the tool lifts off. Give lift_time, or leave it out");
  namespace fs = std::filesystem;
  if (!tool.temperature_from.empty()) { // results/NAME is where swarf runs, wherever the deck is
    std::error_code ignored;
    tool.temperature_from = fs::absolute(tool.temperature_from, ignored).lexically_normal().string();
  }
  if (tool.kind != ToolKind::stl) return;
  if (!find_file(tool.file, place.deck, place.kept.empty() ? "" : ResultsFolder{place.kept}.tool().string()))
    report.add(
        find_place(table, "file"), "tool.file",
        fmt::format("there is no file {}. Give the path of an STL file, relative to the deck", tool.file));
}

void check_output(const OutputDeck& output, const toml::table& table, DeckReport& report) {
  if (output.frame_time && output.frame_immersion)
    report.add(find_place(table, "frame_immersion"), "output.frame_immersion",
               "give either frame_time or frame_immersion, not both");
}

void check_deck(const Deck& deck, const toml::table& root, DeckReport& report) {
  const toml::array& bodies = *root["body"].as_array();
  check_names(deck, bodies, report);
  check_ties(deck, bodies, report);
  check_spindle(deck, root, report);
  check_slice(deck, root, report);
  check_methods(deck, root, report);
  for (std::size_t i = 0; i < deck.bodies.size(); ++i)
    if (deck.bodies[i].previous_tooth && (!deck.tool || deck.tool->kind != ToolKind::end_mill))
      report.add(find_place(*bodies.get(i)->as_table(), "previous_tooth"), "body.previous_tooth",
                 "needs a tool of kind \"end_mill\"");
  const bool has_damage =
      std::any_of(deck.materials.begin(), deck.materials.end(),
                  [](const MaterialDeck& material) { return material.damage.has_value(); });
  if (deck.hexes.delete_failed && !has_damage)
    report.add(find_place(*root["hexes"].as_table(), "delete_failed"), "hexes.delete_failed",
               "no material has damage, so nothing can fail. Give a material damage = [D1, D2, D3, D4, D5]");
}

} // namespace swarf
