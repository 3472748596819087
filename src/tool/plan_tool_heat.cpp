// Where the work may touch the tool, and how far heat gets from there.
#include "src/tool/cells.hpp"
#include <algorithm>
#include <cmath>

namespace swarf {
namespace {

// A body moves at its first velocity, at that of a driven face, or stays.
std::vector<Point> velocities_of(const BodyDeck& body) {
  std::vector<Triple> all{{0, 0, 0}, body.velocity};
  for (const FaceDeck& face : body.faces) all.push_back(face.velocity);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::vector<Point> points;
  for (const Triple& v : all) points.emplace_back(v[0], v[1], v[2]);
  return points;
}

struct Passage {
  const ToolDeck* tool;
  Shape shape;
  Point velocity; // of the body
  double end;     // s

  // Least distance over the run: as long as the body is far, time may go on until it could have come.
  double nearest(const Point& x, double tolerance) const {
    double least = std::numeric_limits<double>::infinity();
    for (double t = 0;;) {
      const ToolPose pose = tool_pose(*tool, t);
      const Vector3 world =
          pose.position + direction_to_world(make_frame(pose), {Real(x.x()), Real(x.y()), Real(x.z())});
      const Point at = Point(double(world.x), double(world.y), double(world.z)) - t * velocity;
      const double distance = shape.signed_distance(at);
      least = std::min(least, std::max(0.0, distance));
      const Point moving = Point(double(pose.velocity.x), double(pose.velocity.y), double(pose.velocity.z));
      const double speed =
          (moving - velocity).norm() + std::abs(double(pose.angular_velocity)) * std::hypot(x.x(), x.y());
      if (least == 0 || t >= end || speed == 0) return least;
      const double next = t + std::max({distance, tolerance, speed * end / 2000}) / speed;
      // The tool may go faster once it lifts off.
      t = std::min(end, tool->lift_time && t < *tool->lift_time ? std::min(next, *tool->lift_time) : next);
    }
  }
};

// Of a body that goes on along z beyond both its ends, in the tool's frame.
std::optional<std::array<double, 2>> find_slice(const Deck& deck) {
  const auto goes_on = [](const BodyDeck& body, const std::string& name, const std::string& name_of_ring) {
    return std::any_of(body.faces.begin(), body.faces.end(), [&](const FaceDeck& face) {
      return (face.face == name || face.face == name_of_ring) &&
             (face.kind == FaceKind::periodic || face.kind == FaceKind::symmetric);
    });
  };
  for (const BodyDeck& body : deck.bodies)
    if (goes_on(body, "z_min", "bottom") && goes_on(body, "z_max", "top")) {
      const double low = body.origin[2] - deck.tool->position[2];
      return {{low, low + (body.shape == BodyShape::block ? body.size[2] : body.height)}};
    }
  return std::nullopt;
}

} // namespace

std::function<double(const Point&)> find_distance_to_work(const Deck& deck, const std::vector<Shape>& shapes,
                                                          double finest, double end) {
  std::vector<Passage> passages;
  for (Shape shape : shapes) {
    shape.inner = [least = shape.inner_least](double, double) { return least; }; // the exact one takes longer
    for (const Point& v : velocities_of(*shape.body)) passages.push_back({&*deck.tool, shape, v, end});
  }
  return [passages, finest](const Point& x) {
    double least = std::numeric_limits<double>::infinity();
    for (const Passage& p : passages) least = std::min(least, p.nearest(x, finest));
    return least;
  };
}

// 4 sqrt(alpha t): a step of temperature at the surface is felt there by half a per cent.
HeatPlan plan_tool_heat(const Deck& deck, const std::vector<Shape>& shapes, double finest) {
  HeatPlan plan;
  plan.material = *find_material(deck, deck.tool->material);
  const double diffusivity =
      plan.material.conductivity.value / plan.material.density / plan.material.specific_heat.value;
  plan.finest = finest;
  plan.reach =
      std::max(8 * finest, 4 * std::sqrt(diffusivity * deck.tool->heat_time.value_or(end_time_of(deck))));
  plan.held_beyond = deck.tool->held_beyond;
  plan.slice = find_slice(deck);
  plan.distance_to_work = find_distance_to_work(deck, shapes, finest, end_time_of(deck));
  return plan;
}

} // namespace swarf
