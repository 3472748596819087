#include "swarf/hexes/hex8.hpp"
#include "swarf/kernels.hpp"
#include "swarf/material/stress_update.hpp"

namespace swarf {

// Force of each hex on its corners, f_a = -(V (sigma - q I) . B_a + sum_m gamma_a^m Q^m), with bulk viscosity
// q and viscous or stiffness hourglass control (Flanagan & Belytschko 1981); see hex8.hpp. Reads position,
// velocity, gradient, volume, velocity_gradient and stress of this step, mass, material, active; writes
// corner_force (0 for deleted hexes); reads and writes hourglass; adds to hourglass_work, viscous_work.
void hex_forces(const HexMesh& m, const MaterialTable& materials, const HexMethod& set, Real dt) {
  Kokkos::parallel_for(
      "hex_forces", Range(0, m.points.count), KOKKOS_LAMBDA(const int e) {
        if (m.active(e) == hex_frozen) return;
        if (m.active(e) == hex_deleted) return store_corners(m.corner_force, e, HexVectors{});
        const Material& mat = materials(m.points.material(e));
        const Real volume = m.volume(e);
        const HexVectors B = load_gradient(m.gradient, e);
        const Tensor3 L = load_tensor(m.points.velocity_gradient, e);
        const HexInertia scaled{set.mass_factor * m.points.density(e),
                                longitudinal_wave_speed(mat) / Kokkos::sqrt(set.mass_factor)};

        const Real rate = L.xx + L.yy + L.zz;
        Real q = 0;
        if (rate < Real(0))
          q = bulk_viscosity(scaled, set.viscosity_linear, set.viscosity_quadratic, characteristic_length(B),
                             rate);
        m.viscous_work(e) -= m.share(e) * volume * q * rate * dt;

        const HexModes x = project_modes(load_corners(m.position, m.connectivity, e));
        const HexModes rates = hourglass_rates(x, load_corners(m.velocity, m.connectivity, e), L);
        const bool stiffness = set.hourglass == HourglassControl::stiffness;
        const Real coefficient = stiffness ? hourglass_stiffness(mat, set.hourglass_coefficient, volume, B)
                                           : hourglass_damping(scaled, set.hourglass_coefficient, volume);
        const Real kept =
            share_kept(mat, load_symmetric(m.points.stress, e), dt * m.points.plastic_strain_rate(e));
        const Hourglass h = update_hourglass(load_modes(m.hourglass, e), rates,
                                             {stiffness, coefficient, step_motion(L, dt).rotation, kept, dt});
        store_modes(m.hourglass, e, h.force);
        m.hourglass_work(e) += h.work;

        const Symmetric3 sigma = load_symmetric(m.points.stress, e) + Symmetric3{-q, -q, -q, 0, 0, 0};
        store_corners(m.corner_force, e, corner_forces(m.share(e) * volume * sigma, B, x, h.force));
      });
}

} // namespace swarf
