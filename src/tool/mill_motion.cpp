#include "src/tool/mill_motion.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace swarf {

using std::numbers::pi;

double MillMotion::pitch() const { return 2 * pi / tool.flutes; }

Triple MillMotion::position(double immersion) const {
  const Triple& d = tool.feed_direction;
  const double feed = tool.feed_per_tooth * (immersion - tool.start_angle) / pitch();
  const double length = std::hypot(d[0], d[1], d[2]);
  Triple p = tool.position;
  for (int a = 0; a < 3; ++a) p[a] += feed * d[a] / length;
  return p;
}

double MillMotion::about_ring(double immersion) const {
  const Triple p = position(immersion);
  const double x = p[0] - axis[0] + radius() * std::sin(immersion);
  const double y = p[1] - axis[1] + radius() * std::cos(immersion);
  return immersion + std::remainder(std::atan2(x, y) - immersion, 2 * pi);
}

// The two differ by the mill's distance from the axis / radius at most, below a tenth: each pass gains that.
double MillMotion::where_about_ring(double about) const {
  double immersion = about;
  for (int pass = 0; pass < 16; ++pass) immersion -= about_ring(immersion) - about;
  return immersion;
}

double MillMotion::tip_radius(double immersion) const {
  const Triple p = position(immersion);
  return std::hypot(p[0] - axis[0] + radius() * std::sin(immersion),
                    p[1] - axis[1] + radius() * std::cos(immersion));
}

bool MillMotion::is_near_axis(double immersion) const {
  const Triple p = position(immersion);
  return std::hypot(p[0] - axis[0], p[1] - axis[1]) < 0.1 * radius();
}

// The rounded edge is rho ahead of the tip; a rake face that leans forward goes on from there.
double lead_of_edge(const ToolDeck& tool, double deepest) {
  const double R = 0.5 * tool.diameter, rho = tool.edge_radius, rake = tool.rake;
  const double fall = std::max(0.0, R - rho * (1 + std::sin(rake)) - deepest);
  const double ahead = rake > 0 ? rho : rho * std::cos(rake) - fall * std::tan(rake);
  return std::atan2(ahead + tool.runout, deepest);
}

} // namespace swarf
