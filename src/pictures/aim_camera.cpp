#include "src/pictures/render_view.hpp"

#include <algorithm>
#include <cmath>

namespace swarf {
namespace {

using Point = std::array<double, 3>;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point unit(const Point& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

struct Extent { // of what is drawn, along the axes of the image and of the world
  Point least{1e300, 1e300, 1e300}, most{-1e300, -1e300, -1e300};
  void add(const double* box) {
    for (std::size_t c = 0; c < 3; ++c)
      least[c] = std::min(least[c], box[2 * c]), most[c] = std::max(most[c], box[2 * c + 1]);
  }
  Point centre() const {
    return {(least[0] + most[0]) / 2, (least[1] + most[1]) / 2, (least[2] + most[2]) / 2};
  }
  double across(const Point& axis) const { // of the box, projected
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += std::abs(axis[c]) * (most[c] - least[c]);
    return sum;
  }
};

Extent find_extent(const std::vector<LoadedFrame>& frames, bool everything) {
  Extent extent;
  for (const LoadedFrame& frame : frames) {
    if (frame.particles) extent.add(frame.particles->GetBounds());
    if (frame.hexes && (everything || !frame.particles)) extent.add(frame.hexes->GetBounds());
    if (frame.tool && everything) extent.add(frame.tool->GetBounds());
  }
  return extent;
}

// Does the tool press on a spot, or on a good part of the body (an impact)?
bool presses_on_a_spot(const std::vector<LoadedFrame>& frames, double whole) {
  double spread = 0;
  bool any = false;
  for (const LoadedFrame& frame : frames)
    if (frame.in_contact) any = true, spread = std::max(spread, frame.contact_spread);
  return any && spread < 0.05 * whole;
}

} // namespace

Camera aim_camera(const PictureOptions& options, const std::vector<LoadedFrame>& frames) {
  Camera camera;
  camera.direction = unit(options.view);
  const Point z{0, 0, 1}, y{0, 1, 0};
  const bool along_z = std::abs(camera.direction[2]) > 0.999;
  camera.right = unit(cross(along_z ? y : z, camera.direction));
  camera.up = cross(camera.direction, camera.right);

  const Extent extent = find_extent(frames, options.everything);
  double spacing = 0;
  for (const LoadedFrame& frame : frames) spacing = std::max(spacing, frame.spacing);
  const double across = 1.08 * extent.across(camera.right), upright = 1.08 * extent.across(camera.up);
  const double whole = std::max(across, upright);
  double window = units_per_metre * options.window;
  // About ten pixels for a particle, where all of them would be too small.
  if (window <= 0 && whole > 75 * spacing && presses_on_a_spot(frames, whole)) window = 60 * spacing;
  camera.follow = window > 0 && window < whole;
  camera.centre = extent.centre();
  if (!camera.follow) { // a view of the body's own shape
    const double shape = std::clamp(across / upright, 0.5, 1.6);
    camera.height = shape < 1 ? 640 : 560;
    camera.width = int(shape * camera.height);
    window = std::max(across, upright * shape);
  }
  camera.half_height = window * camera.height / camera.width / 2;
  camera.section = along_z && extent.across(z) < 0.15 * window;
  return camera;
}

// Where the tool presses; before and after it does, where it pressed in the nearest frame.
Point find_focus(const Camera& camera, const std::vector<LoadedFrame>& frames, std::size_t k) {
  if (!camera.follow) return camera.centre;
  for (std::size_t distance = 0; distance < frames.size(); ++distance)
    for (const bool later : {false, true}) {
      const std::size_t other = later ? k + distance : k - distance; // wraps below 0, then is too large
      if (other < frames.size() && frames[other].in_contact) return frames[other].contact;
    }
  return camera.centre;
}

} // namespace swarf
