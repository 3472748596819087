// Marks the hexes that are to become particles: active ones nearer to the tool than their limit, or strained
// as much as it (conversion.hpp). Reads active, connectivity, position, equivalent_plastic_strain; returns 1
// for each chosen hex, else 0.
#include "swarf/kernels.hpp"
#include "swarf/tool/signed_distance.hpp"

namespace swarf {
namespace {

SWARF_FN Vector3 centre_of(const HexMesh& m, int e) {
  Vector3 sum{0, 0, 0};
  for (int a = 0; a < 8; ++a) sum = sum + load_vector(m.position, m.connectivity(e, a));
  return Real(0.125) * sum;
}

} // namespace

IndexField choose_hexes(const HexMesh& m, const ConversionLimits& l, const ToolPose& pose) {
  const IndexField chosen("chosen", m.points.count);
  const ToolFrame frame = make_frame(pose);
  const ConversionLimits limits = l;
  Kokkos::parallel_for(
      "choose_hexes", Range(0, m.points.count), KOKKOS_LAMBDA(int e) {
        if (m.active(e) != hex_active) return;
        const Real distance = limits.tool.facets > 0 ? limits.distance(e) : Real(0),
                   strain = limits.strain(e);
        const bool near =
            distance > Real(0) && is_within(limits.tool, to_tool(frame, centre_of(m, e)), distance);
        const bool strained = strain > Real(0) && m.points.equivalent_plastic_strain(e) >= strain;
        chosen(e) = near || strained ? 1 : 0;
      });
  return chosen;
}

} // namespace swarf
