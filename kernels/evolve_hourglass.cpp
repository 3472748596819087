// d_i += b_i dt,  b_i = -sum_j V_j [x_ij . (v_ij - (D_i + D_j) x_ij / 2)] grad W_ij
// The displacement that the velocity gradients do not explain: where the planes of a lattice move against
// each other b is 1.8 times their velocity, in a linear field it is zero. It turns with the material and
// returns with the deviator, as the hourglass forces of the hexes do (hex8.hpp); particle_forces resists
// differences of it, the purpose of the non-hourglass penalty of Zhang et al. (2024), arXiv 2409.11474, in a
// form that keeps linear and angular momentum. Reads hourglass_rate (of particle_forces) and points; writes
// hourglass_displacement, rows [0, count + tied); tied particles have none: they follow hexes.
#include "swarf/kernels.hpp"
#include "swarf/material/stress_update.hpp"

namespace swarf {

void evolve_hourglass(const Particles& p, const MaterialTable& materials, Real dt) {
  const MaterialPoints points = p.points;
  Kokkos::parallel_for(
      "evolve_hourglass", Range(0, p.count), KOKKOS_LAMBDA(int i) {
        const Vector3 d = load_vector(p.hourglass_displacement, i) + dt * load_vector(p.hourglass_rate, i);
        const Real kept = points.damage(i) < Real(1)
                              ? share_kept(materials(points.material(i)), load_symmetric(points.stress, i),
                                           dt * points.plastic_strain_rate(i))
                              : Real(0);
        const Tensor3 turn = step_motion(load_tensor(points.velocity_gradient, i), dt).rotation;
        store_vector(p.hourglass_displacement, i, kept * multiply(turn, d));
      });
}

} // namespace swarf
