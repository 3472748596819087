// h follows the particle's volume, h ~ V^(1/3) (Benz 1990). Before prepare_pair_state, which sets V = m /
// rho: V is still that of the step before. Reads mass, density, volume; writes inverse_support, rows [0,
// count + tied).
#include "swarf/kernels.hpp"

namespace swarf {

void evolve_smoothing_length(const Particles& p) {
  const MaterialPoints points = p.points;
  Kokkos::parallel_for(
      "evolve_smoothing_length", Range(0, p.count + p.tied), KOKKOS_LAMBDA(int i) {
        p.inverse_support(i) *= Kokkos::cbrt(points.density(i) * p.volume(i) / points.mass(i));
      });
}

} // namespace swarf
