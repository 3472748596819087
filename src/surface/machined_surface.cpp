#include "src/surface/machined_surface.hpp"
#include "src/files/results.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace swarf {

MachinedSurface::MachinedSurface(const Deck& deck) {
  if (!deck.tool || (deck.tool->kind != ToolKind::wedge && deck.tool->kind != ToolKind::end_mill))
    throw ResultsError(deck.file +
                       ": only a wedge and an end mill leave a surface that swarf surface knows; this "
                       "run had " +
                       (deck.tool ? "a tool of kind " + word_of(deck.tool->kind) : "no tool"));
  tool = *deck.tool;
  if (tool.kind == ToolKind::end_mill) {
    if (deck.bodies.front().shape != BodyShape::ring)
      throw ResultsError(deck.file +
                         ": of an end mill swarf surface looks at rings, about whose axis it turns");
    mill = MillMotion{tool, deck.bodies.front().origin};
    return;
  }
  forward = Eigen::Vector3d(tool.velocity[0], tool.velocity[1], 0).normalized();
  up = forward.x() < 0 ? Eigen::Vector3d(forward.y(), -forward.x(), 0)
                       : Eigen::Vector3d(-forward.y(), forward.x(), 0);
}

SurfacePlace MachinedSurface::place(const Eigen::Vector3d& x) const {
  if (!mill) {
    const Eigen::Vector3d from = x - Eigen::Map<const Eigen::Vector3d>(tool.position.data());
    return {from.dot(forward), from.dot(up), from.z(), forward, up};
  }
  const Eigen::Vector2d from = x.head<2>() - Eigen::Map<const Eigen::Vector3d>(mill->axis.data()).head<2>();
  const double radius = from.norm(), start = mill->about_ring(tool.start_angle);
  const double about = start + std::remainder(std::atan2(from.x(), from.y()) - start, 2 * std::numbers::pi);
  const Eigen::Vector3d in(-from.x() / radius, -from.y() / radius, 0); // out of the work
  const Eigen::Vector3d ahead(from.y() / radius, -from.x() / radius, 0);
  return {mill->radius() * (about - start), mill->tip_radius(mill->where_about_ring(about)) - radius,
          x.z() - tool.position[2], ahead, in};
}

double MachinedSurface::passed(double time) const {
  const double cut = std::min(time, tool.lift_time.value_or(time));
  if (!mill) return cut * std::hypot(tool.velocity[0], tool.velocity[1]);
  return mill->radius() *
         (mill->about_ring(tool.start_angle + tool.spindle_speed * cut) - mill->about_ring(tool.start_angle));
}

} // namespace swarf
