// Signed distance of points from the tool's surface and its outward normal, in the tool's frame, for the
// scene to be built from; beyond the tool's reach the distance is infinite, with its sign.
#include "swarf/kernels.hpp"
#include "swarf/tool/signed_distance.hpp"

namespace swarf {

View<Real* [4]> distance_to_tool(const Tool& tool, const VectorField& x) {
  const View<Real* [4]> result("distance_to_tool", x.extent(0));
  Kokkos::parallel_for(
      "distance_to_tool", UnevenRange(0, int(x.extent(0))), KOKKOS_LAMBDA(const int i) {
        const ToolDistance at = signed_distance(tool, load_vector(x, i));
        const Real far = Kokkos::Experimental::infinity_v<Real>;
        const bool near = at.where == ToolDistance::Where::near;
        result(i, 0) = near ? at.distance : at.where == ToolDistance::Where::deep_inside ? -far : far;
        result(i, 1) = at.normal.x, result(i, 2) = at.normal.y, result(i, 3) = at.normal.z;
      });
  return result;
}

} // namespace swarf
