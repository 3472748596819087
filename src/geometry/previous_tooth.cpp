#include "src/geometry/shape.hpp"
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace swarf {

InnerSurface previous_tooth_surface(const ToolDeck& tool, const Triple& origin) {
  const Point feed =
      Point(tool.feed_direction[0], tool.feed_direction[1], tool.feed_direction[2]).normalized();
  const Point start(tool.position[0], tool.position[1], tool.position[2]);
  const Point axis(origin[0], origin[1], origin[2]);
  const double R = 0.5 * tool.diameter, pitch = 2 * std::numbers::pi / tool.flutes;
  return [=](double angle, double z) {
    const Point e(std::cos(angle), std::sin(angle), 0);
    // Higher up, the edge comes later. Below the end face none comes: the bore goes on straight.
    const double lag = std::max(0.0, z - start.z()) * std::tan(tool.helix) / R;
    double immersion = std::atan2(e.x(), e.y()), radius = R; // clockwise from +y, as start_angle
    // The centre moves by a feed per tooth while the immersion grows by a pitch, so each pass gains a factor
    // of feed / (pitch R), below 1e-2.
    for (int pass = 0; pass < 12; ++pass) {
      const double passings = (immersion - tool.start_angle + lag) / pitch;
      const double since = passings - std::ceil(passings); // in (-1, 0]
      Point centre = start - axis + since * tool.feed_per_tooth * feed;
      centre.z() = 0;
      const double along = centre.dot(e);
      radius = along + std::sqrt(R * R - centre.squaredNorm() + along * along);
      const Point arm = radius * e - centre;
      immersion = std::atan2(arm.x(), arm.y());
    }
    return radius;
  };
}

} // namespace swarf
