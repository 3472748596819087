#include "swarf/hexes/hex8.hpp"
#include "swarf/kernels.hpp"
#include "swarf/particles/pair.hpp"

namespace swarf {
namespace {

// load_corners for the hexes in the lanes.
KOKKOS_FORCEINLINE_FUNCTION HexVectorsOf<Pack>
load_corners(const VectorField& field, const View<int* [8]>& connectivity, const Lanes& lanes) {
  HexVectorsOf<Pack> c;
  for (int a = 0; a < 8; ++a) {
    const auto component = [&](int d) {
      return make_pack([&](int lane) { return field(connectivity(lanes.row(lane), a), d); });
    };
    c.at[a] = {component(0), component(1), component(2)};
  }
  const Vector3Of<Pack> origin = c.at[0];
  for (int a = 0; a < 8; ++a) c.at[a] = c.at[a] - origin;
  return c;
}

KOKKOS_FORCEINLINE_FUNCTION HexVectors lane_of(const HexVectorsOf<Pack>& c, int lane) {
  HexVectors one;
  for (int a = 0; a < 8; ++a) one.at[a] = swarf::lane_of(c.at[a], lane);
  return one;
}

} // namespace

// Mean gradient, volume and velocity gradient of each active hex: B_a = (dV/dx_a) / V, L = sum_a v_a B_a
// (Flanagan & Belytschko 1981, eqs. 16-20, for any shape); consecutive hexes fill the lanes.
// Reads connectivity, position, velocity, active; writes gradient, volume, velocity_gradient.
// Fault: inverted_hex where the volume is not positive.
void hex_velocity_gradient(const HexMesh& m, const Status& status) {
  const int hexes = m.points.count, width = pack_width;
  Kokkos::parallel_for(
      "hex_velocity_gradient", Range(0, (hexes + width - 1) / width), KOKKOS_LAMBDA(const int block) {
        const int first = block * width;
        const Lanes lanes{first, Kokkos::min(width, hexes - first)};
        bool any = false;
        for (int lane = 0; lane < lanes.size; ++lane) any |= m.active(first + lane) == hex_active;
        if (!any) return;
        const HexGradientOf<Pack> g = mean_gradient(load_corners(m.position, m.connectivity, lanes));
        const Tensor3Of<Pack> L = velocity_gradient(load_corners(m.velocity, m.connectivity, lanes), g.B);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int e = first + lane;
          if (m.active(e) != hex_active) continue;
          const Real volume = lane_of(g.volume, lane);
          if (!(volume > Real(0))) report(status, Fault::inverted_hex, e);
          m.volume(e) = volume;
          store_corners(m.gradient, e, lane_of(g.B, lane));
          store_tensor(m.points.velocity_gradient, e, lane_of(L, lane));
        }
      });
}

} // namespace swarf
