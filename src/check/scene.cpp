#include "src/check/scene.hpp"
#include "src/geometry/shape.hpp"
#include "src/tool/geometry.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace swarf {

void Box::grow(const Triple& x, double margin) {
  for (std::size_t c = 0; c < 3; ++c)
    low[c] = std::min(low[c], x[c] - margin), high[c] = std::max(high[c], x[c] + margin);
}

void Box::add(const Box& other) {
  if (!other.empty()) grow(other.low), grow(other.high);
}

Box Box::moved(const Triple& way) const {
  Box box = *this;
  for (std::size_t c = 0; c < 3; ++c) box.low[c] += way[c], box.high[c] += way[c];
  return box;
}

bool Box::meets(const Box& other) const {
  for (std::size_t c = 0; c < 3; ++c)
    if (low[c] > other.high[c] || other.low[c] > high[c]) return false;
  return true;
}

double Box::diagonal() const {
  return empty() ? 0 : std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

std::vector<Box> boxes_of_bodies(const Deck& deck, const Scene& scene) {
  std::vector<Box> boxes(deck.bodies.size());
  const auto x = host_copy(scene.particles.position), node = host_copy(scene.hexes.position);
  const auto gap = host_copy(scene.particles.contact_gap);
  const auto body = host_copy(scene.particles.body), hex_body = host_copy(scene.hex_body);
  const auto corner = host_copy(scene.hexes.connectivity);
  const auto left = host_copy(scene.hexes.points.mass);
  const auto at = [](const auto& field, int row) {
    return Triple{double(field(row, 0)), double(field(row, 1)), double(field(row, 2))};
  };
  for (int i : particle_rows(scene.particles)) boxes[std::size_t(body(i))].grow(at(x, i), double(gap(i)));
  for (int e = 0; e < scene.hexes.points.count; ++e)
    for (int a = 0; left(e) > 0 && a < 8; ++a) boxes[std::size_t(hex_body(e))].grow(at(node, corner(e, a)));
  return boxes;
}

Box box_of_tool(const Deck& deck, const Scene& scene, double time) {
  const ToolPose pose = tool_pose(*deck.tool, time);
  Box box;
  for (const auto& facet : scene.tool_facets)
    for (const Triple& v : facet) {
      const double radius = std::hypot(v[0], v[1]);
      if (deck.tool->spindle_speed > 0)
        box.grow({-radius, -radius, v[2]}), box.grow({radius, radius, v[2]});
      else
        box.grow(v);
    }
  return box.moved({double(pose.position.x), double(pose.position.y), double(pose.position.z)});
}

Box way_of_tool(const Deck& deck, const Scene& scene) {
  Box box = box_of_tool(deck, scene, 0);
  box.add(box_of_tool(deck, scene, end_time_of(deck)));
  return box;
}

std::string describe_length(double metres) {
  const double size = std::abs(metres);
  const auto [scale, unit] = size < 1e-6   ? std::pair(1e9, "nm")
                             : size < 1e-3 ? std::pair(1e6, "um")
                             : size < 1    ? std::pair(1e3, "mm")
                                           : std::pair(1.0, "m");
  return fmt::format("{:.4g} {}", metres * scale, unit);
}

std::string describe_box(const Box& box) {
  double size = 0;
  for (std::size_t c = 0; c < 3; ++c) size = std::max({size, std::abs(box.low[c]), std::abs(box.high[c])});
  const auto [scale, unit] = size < 1e-3 ? std::pair(1e6, "um")
                             : size < 1  ? std::pair(1e3, "mm")
                                         : std::pair(1.0, "m");
  std::string text;
  for (std::size_t c = 0; c < 3; ++c)
    text += fmt::format("{}{} {:.4g} to {:.4g}", c == 0 ? "" : ", ", "xyz"[c], scale * box.low[c],
                        scale * box.high[c]);
  return text + " " + unit;
}

std::string describe_facets(const Scene& scene) {
  std::string text = fmt::format("{}", scene.tool_facets.size());
  if (scene.collapsed_facets > 0)
    text += fmt::format(" ({} more without area were taken out)", scene.collapsed_facets);
  return text;
}

namespace {

std::string describe_volume(double cubic_metres) { // in the cubes of a length that suits
  const double edge = std::cbrt(cubic_metres);
  const auto [scale, unit] = edge < 1e-3 ? std::pair(1e6, "um3")
                             : edge < 1  ? std::pair(1e3, "mm3")
                                         : std::pair(1.0, "m3");
  return fmt::format("{:.4g} {}", cubic_metres * scale * scale * scale, unit);
}

// What of the file's body its particles or hexes have.
std::string describe_filling(const Deck& deck, const Scene& scene, std::size_t row) {
  const BodyDeck& body = deck.bodies[row];
  const bool particles = body.fill == Fill::particles;
  const auto of = host_copy(particles ? scene.particles.body : scene.hex_body);
  const auto volume = host_copy(particles ? scene.particles.volume : scene.hexes.volume);
  const int rows = particles ? scene.particles.count : scene.hexes.points.count;
  double sum = 0;
  int count = 0;
  for (int i = 0; i < rows; ++i)
    if (of(i) == int(row)) sum += double(volume(i)), ++count;
  const Shape shape = make_shape(deck, body);
  std::string text = fmt::format("{} in {} {}", describe_volume(sum), count, word_of(body.fill));
  if (body.shape != BodyShape::stl) return text;
  double cell = 1;
  const auto [low, high] = find_box(deck, body);
  for (std::size_t d = 0; d < 3; ++d) cell *= (high[d] - low[d]) / shape.cells[d];
  const double off = 100 * (count * cell / shape.volume() - 1);
  return text + (particles ? fmt::format(", scaled to that of the surface from {:+.2f} %", off)
                           : fmt::format(", {:+.2f} % off that of the surface", off));
}

} // namespace

SceneReport look_at_scene(const Deck& deck, const Scene& scene) {
  SceneReport report;
  const std::vector<Box> boxes = boxes_of_bodies(deck, scene);
  for (std::size_t b = 0; b < boxes.size(); ++b)
    report.lines.emplace_back(fmt::format("box of \"{}\"", deck.bodies[b].name), describe_box(boxes[b]));
  for (std::size_t b = 0; b < boxes.size(); ++b)
    if (deck.bodies[b].has_file())
      report.lines.emplace_back(fmt::format("volume of \"{}\"", deck.bodies[b].name),
                                describe_filling(deck, scene, b));
  if (deck.tool) {
    report.lines.emplace_back("facets of the tool", describe_facets(scene));
    report.lines.emplace_back("box of the tool", describe_box(box_of_tool(deck, scene, 0)));
    report.lines.emplace_back("box of all its way", describe_box(way_of_tool(deck, scene)));
    if (deck.tool->spindle_speed > 0)
      report.lines.emplace_back("its immersion", fmt::format("{:.4g} to {:.4g} deg", immersion(*deck.tool, 0),
                                                             immersion(*deck.tool, end_time_of(deck))));
    report.warnings = warn_of_tool(deck, scene);
  }
  const BodyReport of_bodies = look_at_bodies(deck, scene);
  for (const std::string& pair : of_bodies.joined) report.lines.emplace_back("act as one body", pair);
  for (const std::string& pair : of_bodies.met) report.lines.emplace_back("will meet", pair);
  report.warnings.insert(report.warnings.end(), of_bodies.warnings.begin(), of_bodies.warnings.end());
  return report;
}

} // namespace swarf
