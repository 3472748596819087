#include "src/tool/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace swarf {
namespace {

Vector3 to_vector(const Triple& t) { return {Real(t[0]), Real(t[1]), Real(t[2])}; }

double turned(const ToolDeck& tool, double time) { return tool.start_angle + tool.spindle_speed * time; }

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
  std::string name = "tool (" + tool.kind + ")";
  if (tool.kind == "end_mill") {
    surface = make_end_mill(tool);
  } else if (tool.kind == "wedge") {
    surface = make_wedge(tool);
  } else if (tool.kind == "wall") {
    surface = make_wall(tool);
  } else if (tool.kind == "stl") {
    name = (std::filesystem::path(folder) / tool.file).string();
    surface = read_stl(name, tool.file_scale);
  } else {
    throw DeckError("tool.kind: \"" + tool.kind + "\" is not one of end_mill, wedge, wall, stl");
  }
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
