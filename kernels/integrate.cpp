// Central differences in time (Verlet): kick half, drift, kick half. The inertia is mass_factor times the
// mass; gravity acts on the unscaled mass times the same factor, so that a falling body falls.
#include "swarf/kernels.hpp"

namespace swarf {

// v += f / (s m) dt + g dt, then the constraints; external_work gets what gravity and moving faces do.
void kick(const Motion& m, const ConstraintTable& table, const Vector3& gravity, Real mass_factor, Real dt) {
  Kokkos::parallel_for(
      "kick", Range(0, m.count), KOKKOS_LAMBDA(int i) {
        if (m.constraints(i) & held_bit) return;
        const Real inertia = mass_factor * m.mass(i);
        const Vector3 before = load_vector(m.velocity, i);
        const Vector3 weight = (inertia * dt) * gravity;
        Vector3 v = before + (dt / inertia) * load_vector(m.force, i) + dt * gravity;
        Vector3 impulse = weight;
        if (m.constraints(i) != 0) {
          const Vector3 held = constrain(v, m.constraints(i), table);
          impulse = impulse + inertia * (held - v);
          v = held;
        }
        m.external_work(i) += Real(0.5) * dot(impulse, before + v);
        store_vector(m.velocity, i, v);
      });
}

void drift(const Motion& m, Real dt) {
  Kokkos::parallel_for(
      "drift", Range(0, m.count), KOKKOS_LAMBDA(int i) {
        if (m.constraints(i) & held_bit) return;
        store_vector(m.position, i, load_vector(m.position, i) + dt * load_vector(m.velocity, i));
      });
}

} // namespace swarf
