// What the contact has brought to nodes becomes temperature:
//   dT_a = Q_a / C_a,  T_a += dT_a,  T_e += mean of dT_a in each hex,  T_k += sum_a N_a dT_a of tied
//   particles.
// The lumped C_a is that of an eighth of each hex: heat is kept to round-off, with tied particles as nearly
// as they fill the hexes that they stand for, and hexes that do not conduct are heated without a diffusion of
// their own. Reads heat_capacity;
// reads and zeroes contact_heat; writes nodal_heat; adds to the temperatures.
#include "swarf/kernels.hpp"
#include "swarf/material/heat.hpp"

namespace swarf {

void spread_contact_heat(const Tie& tie, const Particles& p, const HexMesh& m,
                         const TransformTable& transforms) {
  if (m.nodes == 0) return;
  Kokkos::deep_copy(m.nodal_heat, m.contact_heat);
  Kokkos::deep_copy(m.contact_heat, Real(0));
  couple_heat(m, transforms);
  const bool conducts = m.nodal_temperature.extent(0) > 0;
  Kokkos::parallel_for(
      "spread_contact_heat", Range(0, m.nodes), KOKKOS_LAMBDA(const int a) {
        if (m.nodal_heat(a) == 0) return; // nodes without hexes among them
        m.nodal_heat(a) /= m.heat_capacity(a);
        if (conducts) m.nodal_temperature(a) += m.nodal_heat(a);
      });
  Kokkos::parallel_for(
      "warm_hexes", Range(0, m.points.count), KOKKOS_LAMBDA(const int e) {
        Real sum = 0;
        for (int a = 0; a < 8; ++a) sum += m.nodal_heat(m.connectivity(e, a));
        m.points.temperature(e) += Real(0.125) * sum;
      });
  const ScalarField temperature = p.points.temperature;
  Kokkos::parallel_for(
      "warm_tied", Range(0, tie.count), KOKKOS_LAMBDA(const int k) {
        Real sum = 0;
        for (int a = 0; a < 8; ++a) sum += tie.shape(k, a) * m.nodal_heat(m.connectivity(tie.host(k), a));
        temperature(tie.row(k)) += sum;
      });
}

} // namespace swarf
