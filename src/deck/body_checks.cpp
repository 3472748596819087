// Rules between the keys of a body.
#include "src/deck/checks.hpp"
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

// The counts of a body from a file are known when the file is read.
void check_resolution(const BodyDeck& body, const toml::table& table, DeckReport& report) {
  if (body.shape == BodyShape::mesh) return;
  if (body.shape == BodyShape::stl) {
    if (!body.spacing) report.add(table, "body.spacing", "is missing. Give spacing = \"2.5 um\"");
    return;
  }
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
    const bool is_mesh = body.shape == BodyShape::mesh; // its sets of nodes are in its file
    if (body.has_file() && (face.kind == FaceKind::symmetric || face.kind == FaceKind::periodic)) {
      report.add(
          place, key,
          fmt::format("a face of a body from a file need not be plane, so it is not {}. Use \"fixed\", a "
                      "velocity or a temperature",
                      word_of(face.kind)));
      continue;
    }
    if (!is_mesh && std::find(known.begin(), known.end(), face.face) == known.end()) {
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

} // namespace

bool find_file(std::string& name, const std::string& deck, const std::string& kept) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path path = fs::absolute(fs::path(deck).parent_path() / name, error).lexically_normal();
  if (!fs::is_regular_file(path, error) && fs::is_regular_file(kept, error))
    path = fs::absolute(kept, error).lexically_normal();
  name = path.string();
  return fs::is_regular_file(path, error);
}

std::vector<std::string> list_faces(const BodyDeck& body) {
  if (body.shape == BodyShape::block || body.shape == BodyShape::stl)
    return {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
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

void check_body(BodyDeck& body, const toml::table& table, const BodyPlace& place, DeckReport& report) {
  const std::size_t before = report.count();
  if (body.has_file()) {
    const ResultsFolder folder{place.files.kept};
    const auto kept = folder.path.empty() ? "" : folder.body(place.row, word_of(body.shape)).string();
    if (!find_file(body.file, place.files.deck, kept))
      report.add(find_place(table, "file"), "body.file",
                 fmt::format("there is no file {}. Give its path, relative to the deck", body.file));
  } else {
    check_sizes(body, table, report);
  }
  if (report.count() > before) return; // the rest would follow from it
  check_resolution(body, table, report);
  check_faces(body, table, report);
}

} // namespace swarf
