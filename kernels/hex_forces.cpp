#include "swarf/hex8.hpp"
#include "swarf/kernels.hpp"
#include "swarf/stress_update.hpp"

namespace swarf {

namespace {

struct Hourglass {
  HexModes force; // Q^m, N
  Real work;      // J, of this step
};

// Generalised hourglass forces at the end of the step. Stiffness control: Q turns with the material, then
// grows by k q dt. Work: mean of the forces before and after, times q dt, as the central differences do it.
SWARF_FN Hourglass update_hourglass(const HexMesh& m, int e, const HexModes& q, Real coefficient,
                                    bool stiffness, const Tensor3& rotation, Real dt) {
  Hourglass h{{}, 0};
  for (int k = 0; k < 4; ++k) {
    const Vector3 old =
        multiply(rotation, Vector3{m.hourglass(e, k, 0), m.hourglass(e, k, 1), m.hourglass(e, k, 2)});
    h.force.mode[k] = stiffness ? old + (coefficient * dt) * q.mode[k] : coefficient * q.mode[k];
    h.work += Real(0.5) * dt * dot(old + h.force.mode[k], q.mode[k]);
  }
  return h;
}

SWARF_FN void store_forces(const HexMesh& m, int e, const HexVectors& f) {
  for (int a = 0; a < 8; ++a)
    m.corner_force(e, a, 0) = f.at[a].x, m.corner_force(e, a, 1) = f.at[a].y,
                         m.corner_force(e, a, 2) = f.at[a].z;
}

} // namespace

// Force of each hex on its corners, f_a = -(V (sigma - q I) . B_a + sum_m gamma_a^m Q^m), with bulk viscosity
// q and viscous or stiffness hourglass control (Flanagan & Belytschko 1981); see hex8.hpp. Reads position,
// velocity, gradient, volume, velocity_gradient and stress of this step, mass, material, active; writes
// corner_force (0 for deleted hexes); reads and writes hourglass; adds to hourglass_work, viscous_work.
void hex_forces(const HexMesh& mesh, const MaterialTable& materials, const HexMethod& method, Real dt) {
  const HexMesh m = mesh; // the kernel's own copy of the Views
  const HexMethod set = method;
  Kokkos::parallel_for(
      "hex_forces", Range(0, m.points.count), KOKKOS_LAMBDA(const int e) {
        if (!m.active(e)) return store_forces(m, e, HexVectors{});
        const Material& mat = materials(m.points.material(e));
        const Real volume = m.volume(e);
        const HexVectors B = load_gradient(m.gradient, e);
        const Tensor3 L = load_tensor(m.points.velocity_gradient, e);
        const HexInertia scaled{set.mass_factor * m.points.mass(e) / volume,
                                longitudinal_wave_speed(mat) / Kokkos::sqrt(set.mass_factor)};

        const Real rate = L.xx + L.yy + L.zz;
        Real q = 0;
        if (rate < Real(0))
          q = bulk_viscosity(scaled, set.viscosity_linear, set.viscosity_quadratic, characteristic_length(B),
                             rate);
        m.viscous_work(e) -= volume * q * rate * dt;

        const HexModes x = project_modes(load_corners(m.position, m.connectivity, e));
        const HexModes rates = hourglass_rates(x, load_corners(m.velocity, m.connectivity, e), L);
        const bool stiffness = set.hourglass == HourglassControl::stiffness;
        const Real coefficient = stiffness ? hourglass_stiffness(mat, set.hourglass_coefficient, volume, B)
                                           : hourglass_damping(scaled, set.hourglass_coefficient, volume);
        const Hourglass h =
            update_hourglass(m, e, rates, coefficient, stiffness, step_motion(L, dt).rotation, dt);
        for (int k = 0; k < 4; ++k)
          m.hourglass(e, k, 0) = h.force.mode[k].x, m.hourglass(e, k, 1) = h.force.mode[k].y,
                            m.hourglass(e, k, 2) = h.force.mode[k].z;
        m.hourglass_work(e) += h.work;

        const Symmetric3 sigma = load_symmetric(m.points.stress, e) + Symmetric3{-q, -q, -q, 0, 0, 0};
        store_forces(m, e, corner_forces(volume * sigma, B, x, h.force));
      });
}

} // namespace swarf
