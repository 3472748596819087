#include "src/tool/geometry.hpp"
#include "src/geometry/flat_facets.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <numbers>

namespace swarf {
namespace {

Vector3 to_vector(const Triple& t) { return {Real(t[0]), Real(t[1]), Real(t[2])}; }

double turned(const ToolDeck& tool, double time) { return tool.start_angle + tool.spindle_speed * time; }

double length_of(const FacetSurface& s, int a, int b) {
  const Triple &p = s.vertices[std::size_t(a)], &q = s.vertices[std::size_t(b)];
  return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
}

// Facets so long and narrow that they have no direction: the fault of one size against the others.
void check_proportions(const ToolDeck& tool, const FacetSurface& s) {
  double longest = 0, narrow = 0, slenderest = 1e3;
  for (const auto& [a, b, c] : s.facets) {
    const double sides[] = {length_of(s, a, b), length_of(s, b, c), length_of(s, c, a)};
    const auto [least, most] = std::minmax_element(std::begin(sides), std::end(sides));
    if (!is_flat(s, {a, b, c}) || !(*most > slenderest * *least)) continue;
    longest = *most, narrow = *least, slenderest = longest / narrow;
  }
  if (longest == 0) return;
  const std::string sizes =
      fmt::format("facets of {:.3g} m by {:.3g} m, too narrow to have a direction", longest, narrow);
  const std::string other = tool.kind == ToolKind::wedge ? "width and height" : "length";
  if (tool.edge_radius > 0 && narrow < tool.edge_radius)
    throw DeckError(
        fmt::format("tool.edge_radius: {:.3g} m makes {}. Take at least {:.3g} m, or \"0 m\" for a sharp "
                    "edge, or a smaller {}",
                    tool.edge_radius, sizes, tool.edge_radius * 2e-6 * longest / narrow, other));
  const bool is_low = tool.kind == ToolKind::wedge && tool.height < tool.width;
  throw DeckError(
      fmt::format("tool.{}: makes {}. Look at the units: its sizes differ more than a millionfold",
                  tool.kind == ToolKind::end_mill ? "length"
                  : tool.kind == ToolKind::wall   ? "size"
                  : is_low                        ? "height"
                                                  : "width",
                  sizes));
}

Triple velocity_with_feed(const ToolDeck& tool) {
  const Triple& d = tool.feed_direction;
  const double length = std::hypot(d[0], d[1], d[2]);
  const double feed = tool.feed_per_tooth * tool.flutes * tool.spindle_speed / (2 * std::numbers::pi);
  Triple velocity = tool.velocity;
  if (length > 0)
    for (int a = 0; a < 3; ++a) velocity[a] += feed * d[a] / length;
  return velocity;
}

} // namespace

FacetSurface make_tool_surface(const ToolDeck& tool, const std::string& folder) {
  FacetSurface surface;
  std::string name = "tool (" + word_of(tool.kind) + ")";
  if (tool.kind == ToolKind::end_mill) {
    surface = make_end_mill(tool);
  } else if (tool.kind == ToolKind::wedge) {
    surface = make_wedge(tool);
  } else if (tool.kind == ToolKind::wall) {
    surface = make_wall(tool);
  } else {
    name = (std::filesystem::path(folder) / tool.file).string();
    surface = read_stl(name, tool.file_scale);
  }
  if (tool.kind != ToolKind::stl) check_proportions(tool, surface);
  check_surface(surface, name);
  return surface;
}

ToolPose tool_pose(const ToolDeck& tool, double time) {
  Triple velocity = velocity_with_feed(tool);
  Triple position = tool.position;
  const double cut = tool.lift_time ? std::min(time, *tool.lift_time) : time;
  for (int a = 0; a < 3; ++a) position[a] += velocity[a] * cut;
  if (cut < time) {
    for (int a = 0; a < 3; ++a) position[a] += tool.lift_velocity[a] * (time - cut);
    velocity = tool.lift_velocity;
  }
  ToolPose pose;
  pose.position = to_vector(position);
  pose.velocity = to_vector(velocity);
  pose.angle = Real(-std::fmod(turned(tool, time), 2 * std::numbers::pi));
  pose.angular_velocity = Real(-tool.spindle_speed);
  return pose;
}

double immersion(const ToolDeck& tool, double time) { return turned(tool, time) * 180 / std::numbers::pi; }

} // namespace swarf
