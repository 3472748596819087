#include "swarf/hex8.hpp"
#include "swarf/kernels.hpp"

namespace swarf {

// Mean gradient, volume and velocity gradient of each active hex: B_a = (dV/dx_a) / V, L = sum_a v_a B_a
// (Flanagan & Belytschko 1981, eqs. 16-20, for any shape).
// Reads connectivity, position, velocity, active; writes gradient, volume, velocity_gradient.
// Fault: inverted_hex where the volume is not positive.
void hex_velocity_gradient(const HexMesh& m, const Status& status) {
  Kokkos::parallel_for(
      "hex_velocity_gradient", Range(0, m.points.count), KOKKOS_LAMBDA(const int e) {
        if (!m.active(e)) return;
        const HexGradient g = mean_gradient(load_corners(m.position, m.connectivity, e));
        if (!(g.volume > Real(0))) report(status, Fault::inverted_hex, e);
        m.volume(e) = g.volume;
        store_corners(m.gradient, e, g.B);
        store_tensor(m.points.velocity_gradient, e,
                     velocity_gradient(load_corners(m.velocity, m.connectivity, e), g.B));
      });
}

} // namespace swarf
