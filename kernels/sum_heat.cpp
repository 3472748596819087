// The ledger of heat: what is stored where, above a reference, and what plastic work has made. Once per
// sample. Reads temperature, mass, plastic_work, and what the contact has brought and no temperature shows
// yet.
#include "block_sum.hpp"
#include "swarf/heat.hpp"
#include "swarf/kernels.hpp"

namespace swarf {
namespace {

KOKKOS_INLINE_FUNCTION void add_point(HeatSums& s, const MaterialPoints& p, int i, const Material& mat,
                                      Real reference) {
  s.work += heat_capacity(mat, p.mass(i)) * (p.temperature(i) - reference);
  s.plastic += mat.taylor_quinney * p.plastic_work(i);
}

} // namespace

HeatSums sum_heat(const Particles& p, const MaterialTable& materials, Real reference) {
  const bool brings = p.heat_to_tool.extent(0) > 0;
  return block_sum<HeatSums>(
      "sum_heat_of_particles", p.stored, KOKKOS_LAMBDA(int i, HeatSums& s) {
        add_point(s, p.points, i, materials(p.points.material(i)), reference);
        if (brings) s.tool += p.heat_to_tool(i);
      });
}

HeatSums sum_heat(const HexMesh& m, const MaterialTable& materials, Real reference) {
  const bool brings = m.heat_to_tool.extent(0) > 0;
  HeatSums sums = block_sum<HeatSums>(
      "sum_heat_of_hexes", m.points.count, KOKKOS_LAMBDA(int e, HeatSums& s) {
        add_point(s, m.points, e, materials(m.points.material(e)), reference);
      });
  sums.add(block_sum<HeatSums>(
      "sum_heat_of_nodes", m.nodes, KOKKOS_LAMBDA(int a, HeatSums& s) {
        s.work += m.contact_heat(a);
        if (brings) s.tool += m.heat_to_tool(a);
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
