#include "src/tool/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swarf {
namespace {

using Point = std::array<double, 2>;
constexpr double pi = std::numbers::pi;

[[noreturn]] void refuse(const std::string& key, const std::string& why) {
  throw DeckError("tool." + key + ": " + why);
}

double angle_from_y(const Point& p) { return std::atan2(-p[0], p[1]); } // counter-clockwise

// Foot of the rake face: from `start` along `direction` down to the core.
Point find_rake_foot(const Point& start, const Point& direction, double core) {
  const double along = start[0] * direction[0] + start[1] * direction[1];
  const double offset = start[0] * direction[1] - start[1] * direction[0];
  if (std::abs(offset) >= core)
    refuse("core_ratio", "the rake face misses the core; take a larger core_ratio or a smaller rake");
  const double t = -along - std::sqrt(core * core - offset * offset);
  return {start[0] + t * direction[0], start[1] + t * direction[1]};
}

// One tooth from the foot of its rake face to the core behind it; the edge at +y. The next foot is one pitch
// on.
Section make_tooth(const ToolDeck& tool) {
  const double R = tool.diameter / 2, rho = tool.edge_radius, core = tool.core_ratio * R;
  const double pitch = 2 * pi / tool.flutes, rake = tool.rake, clearance = tool.clearance;
  const Point centre{0, R - rho};
  const Section edge = round_edge(centre, rho, -rake, pi / 2, pi / 2 + clearance);
  const Point foot = find_rake_foot(edge.front(), {-std::sin(rake), -std::cos(rake)}, core);

  // The straight clearance face ends where it comes nearest to the axis, so that it never rubs.
  const double land = centre[1] * std::min(std::sin(clearance), pitch / 8);
  const Point heel{edge.back()[0] - land * std::cos(clearance), edge.back()[1] - land * std::sin(clearance)};
  const double heel_radius = std::hypot(heel[0], heel[1]), heel_angle = angle_from_y(heel);
  if (core > 0.95 * heel_radius) refuse("core_ratio", "leaves no flute; take a smaller core_ratio");
  const double next_foot = angle_from_y(foot) + pitch, back_end = heel_angle + 0.6 * (next_foot - heel_angle);

  Section tooth{foot};
  tooth.insert(tooth.end(), edge.begin(), edge.end());
  // Back: radius falls as a parabola, tangential to the core where it ends. Then the core.
  const auto add_polar = [&](double radius, double angle) {
    tooth.push_back({-radius * std::sin(angle), radius * std::cos(angle)});
  };
  const int back = std::max(6, int(std::ceil((back_end - heel_angle) / (6 * pi / 180))));
  for (int k = 0; k <= back; ++k) {
    const double s = double(k) / back;
    add_polar(core + (heel_radius - core) * (1 - s) * (1 - s), heel_angle + s * (back_end - heel_angle));
  }
  const int floor = std::max(3, int(std::ceil((next_foot - back_end) / (6 * pi / 180))));
  for (int k = 1; k < floor; ++k) add_polar(core, back_end + (next_foot - back_end) * k / floor);
  return tooth;
}

} // namespace

FacetSurface make_end_mill(const ToolDeck& tool) {
  if (tool.flutes < 1 || tool.flutes > max_tool_teeth)
    refuse("flutes",
           "expected 1 to " + std::to_string(max_tool_teeth) + ", got " + std::to_string(tool.flutes));
  if (!(tool.clearance > 0)) refuse("clearance", "must be larger than 0: without it the tooth's back rubs");
  if (!(tool.edge_radius >= 0 && tool.edge_radius < tool.diameter / 8))
    refuse("edge_radius", "must be at least 0 and less than an eighth of the diameter");
  const Section tooth = make_tooth(tool);
  Section section;
  for (int k = 0; k < tool.flutes; ++k) {
    const double c = std::cos(2 * pi * k / tool.flutes), s = std::sin(2 * pi * k / tool.flutes);
    for (const Point& p : tooth) section.push_back({c * p[0] - s * p[1], s * p[0] + c * p[1]});
  }

  // Layers about as tall as the edge is round, as far as 20 000 facets go.
  const int per_layer = 2 * int(section.size()), most = std::max(8, 19000 / per_layer - 1);
  const double height = tool.edge_radius > 0 ? tool.edge_radius : tool.length / 25;
  const int count = int(std::clamp(std::ceil(tool.length / height), 1.0, double(most)));
  std::vector<Layer> layers;
  for (int l = 0; l <= count; ++l) {
    const double z = tool.length * l / count;
    layers.push_back({z, std::tan(tool.helix) * z / (tool.diameter / 2)});
  }
  FacetSurface surface = loft(section, layers);
  for (Triple& v : surface.vertices) {
    v[0] += tool.runout * std::sin(tool.runout_angle);
    v[1] += tool.runout * std::cos(tool.runout_angle);
  }
  return surface;
}

} // namespace swarf
