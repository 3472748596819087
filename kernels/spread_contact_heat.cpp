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
namespace {

// What the corners of a hex show, at weights that add up to 1.
struct Brought {
  Real more = 0;        // K, or J/kg of nodes that have no temperature
  Real temperature = 0; // K, of the nodes now
};
template <class Weight>
SWARF_FN Brought sum_corners(const HexMesh& m, int e, const Weight& weight) {
  Brought sum;
  for (int a = 0; a < 8; ++a) {
    const int node = m.connectivity(e, a);
    sum.more += weight(a) * m.nodal_heat(node);
    if (m.nodal_temperature.extent(0) > 0) sum.temperature += weight(a) * m.nodal_temperature(node);
  }
  return sum;
}

// Heat is kept where the specific heat is a table: a point keeps what it is above nodes that hold the heat;
// else it takes the heat per mass that they show.
SWARF_FN Real warmed_with(const HexMesh& m, const Material& mat, Real T, const Brought& b) {
  if (m.node_material.extent(0) == 0) return T + b.more;
  const bool conducts = m.nodal_temperature.extent(0) > 0;
  return warmed_by(mat, T,
                   conducts ? heat_between(mat, Real(1), b.temperature - b.more, b.temperature) : b.more);
}

} // namespace

void spread_contact_heat(const Tie& tie, const Particles& p, const HexMesh& m,
                         const TransformTable& transforms, const MaterialTable& materials) {
  if (m.nodes == 0) return;
  Kokkos::deep_copy(m.nodal_heat, m.contact_heat);
  Kokkos::deep_copy(m.contact_heat, Real(0));
  couple_heat(m, transforms);
  const bool conducts = m.nodal_temperature.extent(0) > 0, has_tables = m.node_material.extent(0) > 0;
  Kokkos::parallel_for(
      "spread_contact_heat", Range(0, m.nodes), KOKKOS_LAMBDA(const int a) {
        if (m.nodal_heat(a) == 0) return; // nodes without hexes among them
        if (!conducts && has_tables)      // J/kg: a node that does not conduct has no temperature
          m.nodal_heat(a) *= materials(m.node_material(a)).specific_heat / m.heat_capacity(a);
        else if (has_tables)
          m.nodal_heat(a) = node_warmed_by(m, materials, a, m.nodal_temperature(a), m.nodal_heat(a)) -
                            m.nodal_temperature(a);
        else
          m.nodal_heat(a) /= m.heat_capacity(a);
        if (conducts) m.nodal_temperature(a) += m.nodal_heat(a);
      });
  Kokkos::parallel_for(
      "warm_hexes", Range(0, m.points.count), KOKKOS_LAMBDA(const int e) {
        const Brought brought = sum_corners(m, e, [](int) { return Real(0.125); });
        m.points.temperature(e) =
            warmed_with(m, materials(m.points.material(e)), m.points.temperature(e), brought);
      });
  Kokkos::parallel_for(
      "warm_tied", Range(0, tie.count), KOKKOS_LAMBDA(const int k) {
        const int i = tie.row(k);
        const Brought brought = sum_corners(m, tie.host(k), [&](int a) { return tie.shape(k, a); });
        p.points.temperature(i) =
            warmed_with(m, materials(p.points.material(i)), p.points.temperature(i), brought);
      });
}

} // namespace swarf
