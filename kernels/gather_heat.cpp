// The heat of each node, from the corners of its hexes and from the tied particles in them, and what it does:
//   H_a = sum over corners + sum_k N_a (Q_k + m_k c (T_k - sum_b N_b T_b)),  T_a += H_a / C_a,
// then T = mean of the corners in each hex and sum_a N_a T_a for each tied particle. The weights are those of
// the tie's velocities and forces: heat is conserved to round-off. Sums in a fixed order.
#include "swarf/kernels.hpp"
#include "swarf/material/heat.hpp"

namespace swarf {
namespace {

// sum_a N_a T_a at tied particle k.
SWARF_FN Real host_temperature(const Tie& tie, const HexMesh& m, int k) {
  Real sum = 0;
  for (int a = 0; a < 8; ++a) sum += tie.shape(k, a) * m.nodal_temperature(m.connectivity(tie.host(k), a));
  return sum;
}

// Adds what has heated tied particle k itself since the last call; to one that is frozen conduction brought
// nothing.
void take_own_heat(const Tie& tie, const Particles& p, const HexMesh& m, const MaterialTable& materials) {
  const MaterialPoints points = p.points;
  const int active = p.count + p.tied;
  Kokkos::parallel_for(
      "take_own_heat", Range(0, tie.count), KOKKOS_LAMBDA(int k) {
        const int i = tie.row(k);
        const Real conducted = i < active ? p.heat(i) : Real(0);
        p.heat(i) = conducted + heat_between(materials(points.material(i)), points.mass(i),
                                             host_temperature(tie, m, k), points.temperature(i));
      });
}

void gather_corners(const HexMesh& m) {
  Kokkos::parallel_for(
      "gather_heat", Range(0, m.nodes), KOKKOS_LAMBDA(int a) {
        Real sum = 0;
        for (int k = m.corner_start(a); k < m.corner_start(a + 1); ++k)
          sum += m.corner_heat(m.corner_of_node(k) / 8, m.corner_of_node(k) % 8);
        m.nodal_heat(a) = sum;
      });
}

void gather_tied(const Tie& tie, const Particles& p, const HexMesh& m) {
  Kokkos::parallel_for(
      "gather_tied_heat", Range(0, int(tie.row_node.extent(0))), KOKKOS_LAMBDA(int row) {
        Real sum = m.nodal_heat(tie.row_node(row));
        for (int e = tie.start(row); e < tie.start(row + 1); ++e)
          sum += tie.shape(tie.entry(e) / 8, tie.entry(e) % 8) * p.heat(tie.row(tie.entry(e) / 8));
        m.nodal_heat(tie.row_node(row)) = sum;
      });
}

} // namespace

void gather_heat(const Tie& tie, const Particles& p, const HexMesh& m, const MaterialTable& materials) {
  take_own_heat(tie, p, m, materials);
  gather_corners(m);
  gather_tied(tie, p, m);
}

void spread_temperature(const Tie& tie, const Particles& p, const HexMesh& m,
                        const MaterialTable& materials) {
  Kokkos::parallel_for(
      "warm_nodes", Range(0, m.nodes), KOKKOS_LAMBDA(int a) {
        m.nodal_temperature(a) = node_warmed_by(m, materials, a, m.nodal_temperature(a), m.nodal_heat(a));
      });
  Kokkos::parallel_for(
      "spread_temperature", Range(0, m.points.count), KOKKOS_LAMBDA(int e) {
        Real sum = 0;
        for (int a = 0; a < 8; ++a) sum += m.nodal_temperature(m.connectivity(e, a));
        m.points.temperature(e) = Real(0.125) * sum;
      });
  const ScalarField temperature = p.points.temperature;
  Kokkos::parallel_for(
      "spread_to_tied", Range(0, tie.count),
      KOKKOS_LAMBDA(int k) { temperature(tie.row(k)) = host_temperature(tie, m, k); });
}

} // namespace swarf
