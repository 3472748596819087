// h_i = h_i rho-wise: h follows the particle's volume, h ~ V^(1/3) (Benz 1990): dh/dt = h / 3 tr L.
// Reads velocity_gradient; writes smoothing_length, rows [0, count + tied).
#include "swarf/kernels.hpp"

namespace swarf {

void evolve_smoothing_length(const Particles& p, Real dt) {
  const auto L = p.points.velocity_gradient;
  Kokkos::parallel_for(
      "evolve_smoothing_length", Range(0, p.count + p.tied), KOKKOS_LAMBDA(int i) {
        p.smoothing_length(i) *= Kokkos::exp(dt / Real(3) * (L(i, 0) + L(i, 4) + L(i, 8)));
      });
}

} // namespace swarf
