// The point that is deepest in contact with the tool, or nearest to it: largest gap - distance, the
// penetration of tool_contact.cpp. Of equal ones the first, so in any order. Reads position, gap, area.
#include "swarf/kernels.hpp"
#include "swarf/tool/signed_distance.hpp"

namespace swarf {

ClosestPoint find_closest_point(const ContactPoints& points, const Tool& tool, const ToolPose& pose) {
  const ToolFrame frame = make_frame(pose);
  using Deepest = Kokkos::MaxLoc<Real, int>;
  Deepest::value_type deepest;
  Kokkos::parallel_reduce(
      "find_closest_point", Range(0, points.count),
      KOKKOS_LAMBDA(const int i, Deepest::value_type& best) {
        if (points.area(i) == 0) return;
        const ToolDistance at = signed_distance(tool, to_tool(frame, load_vector(points.position, i)));
        Real depth = -Kokkos::Experimental::infinity_v<Real>;
        if (at.where == ToolDistance::Where::near) depth = points.gap(i) - at.distance;
        if (at.where == ToolDistance::Where::deep_inside) depth = points.gap(i) + tool.reach;
        if (depth > best.val || (depth == best.val && i < best.loc)) best.val = depth, best.loc = i;
      },
      Deepest(deepest));
  const bool none = points.count == 0 || deepest.val <= -Kokkos::Experimental::finite_max_v<Real>;
  if (none) return {};
  return {deepest.val, deepest.loc};
}

} // namespace swarf
