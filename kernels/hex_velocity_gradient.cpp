#include "swarf/hex8.hpp"
#include "swarf/kernels.hpp"

namespace swarf {

// Mean gradient, volume and velocity gradient of each active hex: B_a = (dV/dx_a) / V, L = sum_a v_a B_a
// (Flanagan & Belytschko 1981, eqs. 16-20, for any shape).
// Reads connectivity, position, velocity, active; writes gradient, volume, velocity_gradient.
// Fault: inverted_hex where the volume is not positive.
void hex_velocity_gradient(const HexMesh& mesh, const Status& status) {
  const HexMesh m = mesh; // the kernel's own copy of the Views
  Kokkos::parallel_for(
      "hex_velocity_gradient", Range(0, m.points.count), KOKKOS_LAMBDA(const int e) {
        if (!m.active(e)) return;
        const HexGradient g = mean_gradient(load_corners(m.position, m.connectivity, e));
        if (!(g.volume > Real(0))) report(status, Fault::inverted_hex, e);
        m.volume(e) = g.volume;
        for (int a = 0; a < 8; ++a)
          m.gradient(e, a, 0) = g.B.at[a].x, m.gradient(e, a, 1) = g.B.at[a].y,
                           m.gradient(e, a, 2) = g.B.at[a].z;
        store_tensor(m.points.velocity_gradient, e,
                     velocity_gradient(load_corners(m.velocity, m.connectivity, e), g.B));
      });
}

} // namespace swarf
