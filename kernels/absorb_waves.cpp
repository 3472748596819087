// v' = -damping v, exactly over dt, where freezing begins (freeze.hpp): a wave that runs outwards fades
// before it reaches what is held. Reads damping; writes velocity; the energy leaves by external_work.
#include "swarf/kernels.hpp"

namespace swarf {

void absorb_waves(const Motion& m, const ScalarField& damping, Real mass_factor, Real dt) {
  Kokkos::parallel_for(
      "absorb_waves", Range(0, m.count), KOKKOS_LAMBDA(int i) {
        if (damping(i) == 0 || (m.constraints(i) & held_bit)) return;
        const Vector3 v = load_vector(m.velocity, i);
        const Real kept = Kokkos::exp(-damping(i) * dt);
        m.external_work(i) -= Real(0.5) * mass_factor * m.mass(i) * (1 - kept * kept) * dot(v, v);
        store_vector(m.velocity, i, kept * v);
      });
}

} // namespace swarf
