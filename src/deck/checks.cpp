#include "src/deck/checks.hpp"
#include "src/deck/library.hpp"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>

namespace swarf {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;

bool is_whole_ring(const BodyDeck& body) {
  return body.end_angle - body.start_angle >= whole_turn * (1 - 1e-12);
}

double find_least_size(const BodyDeck& body) {
  if (body.shape == BodyShape::block) return *std::min_element(body.size.begin(), body.size.end());
  if (body.shape == BodyShape::cylinder) return std::min(2 * body.radius, body.height);
  const double wall = body.outer_radius - body.inner_radius;
  if (body.shape == BodyShape::ring) return std::min(wall, body.height);
  return body.inner_radius > 0 ? wall : 2 * body.outer_radius;
}

double find_volume(const BodyDeck& body) {
  constexpr double pi = std::numbers::pi;
  const double outer = body.outer_radius, inner = body.inner_radius;
  if (body.shape == BodyShape::block) return body.size[0] * body.size[1] * body.size[2];
  if (body.shape == BodyShape::cylinder) return pi * body.radius * body.radius * body.height;
  if (body.shape == BodyShape::ring)
    return (body.end_angle - body.start_angle) / 2 * (outer - inner) * (outer + inner) * body.height;
  return 4 * pi / 3 * (outer * outer * outer - inner * inner * inner);
}

void check_resolution(const BodyDeck& body, const toml::table& table, DeckReport& report) {
  if (body.spacing && body.cells)
    return report.add(find_place(table, "cells"), "body.cells", "give either spacing or cells, not both");
  constexpr double most = 1e9; // rows of a field are counted by int
  double count = 0;
  if (body.spacing) {
    const double least = find_least_size(body);
    if (*body.spacing > least * (1 + 1e-9))
      report.add(
          find_place(table, "spacing"), "body.spacing",
          fmt::format("{} m is more than the body's least size of {} m: not one cell fits. Make it smaller",
                      *body.spacing, least));
    count = find_volume(body) / std::pow(*body.spacing, 3);
  } else if (body.cells) {
    for (int cells : *body.cells) count = (count == 0 ? 1 : count) * cells;
  } else {
    const bool has_cells = body.shape != BodyShape::sphere;
    return report.add(table, "body.spacing",
                      std::string("is missing. Give spacing = \"2.5 um\"") +
                          (has_cells ? ", or the exact counts by cells" : ""));
  }
  if (!(count <= most)) // also NaN
    report.add(find_place(table, body.spacing ? "spacing" : "cells"),
               body.spacing ? "body.spacing" : "body.cells",
               fmt::format("makes {:.3g} {}, more than {:.0e}. Make the cells larger", count,
                           word_of(body.fill), most));
}

void check_sizes(const BodyDeck& body, const toml::table& table, DeckReport& report) {
  if ((body.shape == BodyShape::ring || body.shape == BodyShape::sphere) &&
      body.inner_radius >= body.outer_radius)
    report.add(find_place(table, "inner_radius"), "body.inner_radius",
               fmt::format("expected less than outer_radius = {} m, got {} m", body.outer_radius,
                           body.inner_radius));
  if (body.shape != BodyShape::ring) return;
  const double turn = body.end_angle - body.start_angle;
  if (turn <= 0 || turn > whole_turn * (1 + 1e-12))
    report.add(
        find_place(table, "end_angle"), "body.end_angle",
        fmt::format(
            "expected more than start_angle and at most a whole turn more, got {:.6g} deg after {:.6g} deg",
            body.end_angle * 360 / whole_turn, body.start_angle * 360 / whole_turn));
}

void check_faces(const BodyDeck& body, const toml::table& table, DeckReport& report) {
  const toml::table* faces = table["faces"].as_table();
  const std::vector<std::string> known = list_faces(body);
  for (const FaceDeck& face : body.faces) {
    const std::string key = "body.faces." + face.face;
    const toml::node& place = find_place(*faces, face.face);
    if (std::find(known.begin(), known.end(), face.face) == known.end()) {
      report.add(place, key,
                 fmt::format("this {} has no such face. It has {}.{}", word_of(body.shape),
                             fmt::join(known, ", "), suggest(face.face, known)));
      continue;
    }
    const std::string opposite = find_opposite(face.face);
    if (face.kind == FaceKind::symmetric && opposite.empty())
      report.add(place, key,
                 "a symmetric face must be plane, this one is curved. Use \"fixed\" or a velocity");
    if (face.kind != FaceKind::periodic) continue;
    const bool is_paired = std::any_of(body.faces.begin(), body.faces.end(), [&](const FaceDeck& other) {
      return other.face == opposite && other.kind == FaceKind::periodic;
    });
    if (opposite.empty())
      report.add(place, key, "a curved face cannot be periodic. Use \"fixed\" or a velocity");
    else if (!is_paired)
      report.add(place, key,
                 fmt::format("a periodic face needs its opposite. Write {} = \"periodic\" too", opposite));
  }
}

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

std::vector<std::string> list_faces(const BodyDeck& body) {
  if (body.shape == BodyShape::block) return {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
  if (body.shape == BodyShape::cylinder) return {"bottom", "top", "side"};
  if (body.shape == BodyShape::sphere)
    return body.inner_radius > 0 ? std::vector<std::string>{"inner", "outer"}
                                 : std::vector<std::string>{"outer"};
  if (is_whole_ring(body)) return {"inner", "outer", "bottom", "top"};
  return {"inner", "outer", "bottom", "top", "start", "end"};
}

std::string find_opposite(const std::string& face) {
  static const std::vector<std::pair<std::string, std::string>> pairs = {
      {"x_min", "x_max"}, {"y_min", "y_max"}, {"z_min", "z_max"}, {"bottom", "top"}, {"start", "end"}};
  for (const auto& [a, b] : pairs) {
    if (face == a) return b;
    if (face == b) return a;
  }
  return "";
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

void check_body(const BodyDeck& body, const toml::table& table, DeckReport& report) {
  const std::size_t before = report.count();
  check_sizes(body, table, report);
  if (report.count() > before) return; // the rest would follow from it
  check_resolution(body, table, report);
  check_faces(body, table, report);
}

void check_tool(ToolDeck& tool, const toml::table& table, const StlPlace& place, DeckReport& report) {
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
  std::error_code error;
  fs::path path = fs::absolute(fs::path(place.deck).parent_path() / tool.file, error).lexically_normal();
  if (!fs::is_regular_file(path, error) && fs::is_regular_file(place.instead, error))
    path = fs::absolute(place.instead, error).lexically_normal();
  if (!fs::is_regular_file(path, error))
    report.add(find_place(table, "file"), "tool.file",
               fmt::format("there is no file {}. Give the path of an STL file, relative to the deck",
                           path.string()));
  tool.file = path.string();
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
