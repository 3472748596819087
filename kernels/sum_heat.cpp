// The ledger of heat: what is stored where, above a reference, and what plastic work has made. Once per
// sample. Reads temperature, mass, plastic_work, and what the contact has brought and no temperature shows
// yet. What tied particles have made since the last conduction is in plastic only.
#include "block_sum.hpp"
#include "swarf/kernels.hpp"
#include "swarf/material/heat.hpp"

namespace swarf {
namespace {

KOKKOS_INLINE_FUNCTION Real above(const MaterialPoints& p, int i, const Material& mat, Real reference) {
  return heat_between(mat, p.mass(i), reference, p.temperature(i));
}

KOKKOS_INLINE_FUNCTION Real mean_of_nodes(const HexMesh& m, int e) {
  Real sum = 0;
  for (int a = 0; a < 8; ++a) sum += m.nodal_temperature(m.connectivity(e, a));
  return Real(0.125) * sum;
}

} // namespace

HeatSums sum_heat(const Particles& p, const MaterialTable& materials, Real reference) {
  const bool brings = p.heat_to_tool.extent(0) > 0, nodes_hold = p.heat.extent(0) > 0,
             has_faces = p.face_heat.extent(0) > 0;
  return block_sum<HeatSums>(
      "sum_heat_of_particles", p.stored, KOKKOS_LAMBDA(int i, HeatSums& s) {
        const Material& mat = materials(p.points.material(i));
        if (!nodes_hold || p.identity(i) < p.whole) s.work += above(p.points, i, mat, reference);
        s.plastic += mat.taylor_quinney * p.points.plastic_work(i);
        if (brings) s.tool += p.heat_to_tool(i);
        if (has_faces) s.out -= p.face_heat(i);
      });
}

HeatSums sum_heat(const HexMesh& m, const MaterialTable& materials, Real reference) {
  const bool brings = m.heat_to_tool.extent(0) > 0, nodes_hold = m.nodal_temperature.extent(0) > 0,
             has_faces = m.face_heat.extent(0) > 0;
  HeatSums sums = block_sum<HeatSums>(
      "sum_heat_of_hexes", m.points.count, KOKKOS_LAMBDA(int e, HeatSums& s) {
        const Material& mat = materials(m.points.material(e));
        s.work += above(m.points, e, mat, nodes_hold ? mean_of_nodes(m, e) : reference);
        s.plastic += mat.taylor_quinney * m.points.plastic_work(e);
      });
  sums.add(block_sum<HeatSums>(
      "sum_heat_of_nodes", m.nodes, KOKKOS_LAMBDA(int a, HeatSums& s) {
        if (nodes_hold && m.mass(a) > 0) // else its hexes have become particles
          s.work += node_heat_between(m, materials, a, reference, m.nodal_temperature(a));
        s.work += m.contact_heat(a);
        if (brings) s.tool += m.heat_to_tool(a);
        if (has_faces) s.out -= m.face_heat(a);
      }));
  return sums;
}

HeatSums sum_heat(const ToolHeat& t) {
  return block_sum<HeatSums>(
      "sum_heat", t.cells, KOKKOS_LAMBDA(int c, HeatSums& s) {
        if (t.capacity(c) < Kokkos::Experimental::infinity_v<Real>)
          s.tool += t.capacity(c) * (t.temperature(c) - t.start_temperature);
        s.out += t.out(c);
        if (t.temperature(c) > s.tool_hottest) s.tool_hottest = t.temperature(c), s.hottest_cell = c;
      });
}

} // namespace swarf
