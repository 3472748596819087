// What a particle shows its neighbours in the force sum: P = (sigma + t) K, in the place of K, t of
// surface_stress.cpp, D = sym L, in the place of L, and the impedance of the mass-scaled material. Once after
// each velocity_gradient. Reads points. Writes rows [0, count + tied); V = m / rho, or m / rho_0 in the
// initial frame, where K is J F^-T K_0 and P the first Piola-Kirchhoff stress.
#include "swarf/kernels.hpp"
#include "swarf/material/stress_update.hpp"

namespace swarf {

void prepare_pair_state(const Particles& p, const MaterialTable& materials, const ParticleMethod& method) {
  const MaterialPoints points = p.points;
  const bool correct = method.correct_forces, initial = method.initial_frame;
  const bool surfaces = p.surface_term.extent(0) > 0;
  const Real mass_factor = method.mass_factor;
  Kokkos::parallel_for(
      "prepare_pair_state", Range(0, p.count + p.tied), KOKKOS_LAMBDA(int i) {
        const Symmetric3 stress = load_symmetric(points.stress, i);
        const Tensor3 K = correct ? load_tensor(p.pair_stress, i) : identity3();
        Tensor3 shown = multiply(to_tensor(stress), K);
        if (surfaces) {
          const Tensor3 K0 = initial ? without_cofactor(K, load_tensor(p.deformation_gradient, i)) : K;
          shown = shown + multiply(load_tensor(p.surface_term, i), K0);
        }
        store_tensor(p.pair_stress, i, shown);
        const Symmetric3 D = symmetric_part(load_tensor(points.velocity_gradient, i));
        store_tensor(points.velocity_gradient, i, to_tensor(D));
        const Real density = points.density(i) * mass_factor;
        const Real stiffness = stiffness_share(materials(points.material(i)), points.temperature(i));
        const Real speed = Kokkos::sqrt(stiffness) * longitudinal_wave_speed(materials(points.material(i))) /
                           Kokkos::sqrt(mass_factor);
        p.impedance(i, 0) = density * speed;
        p.impedance(i, 1) = density;
        p.impedance(i, 2) = stiffness * materials(points.material(i)).shear_modulus;
        if (initial) // of a deformation that has flowed, the secant modulus
          p.impedance(i, 2) *= points.damage(i) < Real(1) ? share_kept(materials(points.material(i)), stress,
                                                                       points.equivalent_plastic_strain(i))
                                                          : Real(0);
        p.volume(i) = points.mass(i) / (initial ? materials(points.material(i)).density : points.density(i));
      });
}

} // namespace swarf
