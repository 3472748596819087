#include "swarf/kernels.hpp"
#include "swarf/material/stress_update.hpp"

namespace swarf {

// Stress, density, plastic strain, temperature and damage of each point after a step dt:
//   sigma_n+1 = return(Q sigma_n Q^T + C : D dt),  rho_n+1 = rho_n det(I - L dt),
//   dT = beta sigma_y d_eps / (rho c)
// (Hughes & Winget 1980; Johnson & Cook 1983, 1985; see stress_update.hpp). Where stress depends on
// temperature: D dt less the expansion since the stress was made, at stress_temperature, and C of now.
// Reads velocity_gradient, mass, material; reads and writes the state of MaterialPoints; adds to the works.
// Faults: return_mapping, non_finite (also where the density is no longer positive).
void update_stress(const MaterialPoints& p, const MaterialTable& materials, Real dt, const Status& status,
                   const View<int*>& active) {
  const bool all = active.extent(0) == 0, knows_heat = p.stress_temperature.extent(0) > 0;
  Kokkos::parallel_for(
      "update_stress", UnevenRange(0, p.count), KOKKOS_LAMBDA(const int i) {
        if (!all && active(i) == hex_frozen) return;
        const MaterialState start{
            load_symmetric(p.stress, i), p.density(i),     p.equivalent_plastic_strain(i),
            p.plastic_strain_rate(i),    p.temperature(i), p.damage(i)};
        const Real before = knows_heat ? p.stress_temperature(i) : start.temperature;
        const StressUpdate u =
            update_point(materials(p.material(i)), start, load_tensor(p.velocity_gradient, i), dt, before);
        const MaterialState& s = u.state;
        const Real sum = s.stress.xx + s.stress.yy + s.stress.zz + s.stress.xy + s.stress.yz + s.stress.zx;
        if (!Kokkos::isfinite(sum + s.temperature) || !Kokkos::isfinite(s.density) || !(s.density > Real(0)))
          report(status, Fault::non_finite, i);
        else if (!u.converged)
          report(status, Fault::return_mapping, i);

        store_symmetric(p.stress, i, s.stress);
        if (knows_heat) p.stress_temperature(i) = start.temperature;
        p.density(i) = s.density;
        p.equivalent_plastic_strain(i) = s.equivalent_plastic_strain;
        p.plastic_strain_rate(i) = s.plastic_strain_rate;
        p.temperature(i) = s.temperature;
        p.damage(i) = s.damage;
        p.internal_work(i) += p.mass(i) * u.internal_work;
        p.plastic_work(i) += p.mass(i) * u.plastic_work;
      });
}

} // namespace swarf
