// Number of points that lie deeper than `depth` inside the tool: none may, before the run (overlap) or in it
// (the tool leaks). Integer sum, so in any order. Reads position, area.
#include "swarf/kernels.hpp"
#include "swarf/tool/signed_distance.hpp"

namespace swarf {

int count_points_inside(const ContactPoints& points, const Tool& tool, const ToolPose& pose, Real depth) {
  const ToolFrame frame = make_frame(pose);
  int inside = 0;
  Kokkos::parallel_reduce(
      "count_points_inside", Range(0, points.count),
      KOKKOS_LAMBDA(const int i, int& count) {
        if (points.area(i) == 0) return;
        const ToolDistance at = signed_distance(tool, to_tool(frame, load_vector(points.position, i)));
        const bool deep = at.where == ToolDistance::Where::deep_inside;
        if (deep || (at.where == ToolDistance::Where::near && at.distance < -depth)) ++count;
      },
      inside);
  return inside;
}

} // namespace swarf
