// C_c dT_c/dt = sum_n G_cn (T_n - T_c) over the neighbours of each cell of the tool: what one cell gets the
// other gives, to round-off. Reads temperature, conductance; writes heat, then temperature (out of held
// cells).
#include "swarf/kernels.hpp"

namespace swarf {

void conduct_tool(const ToolHeat& t, Real dt) {
  Kokkos::parallel_for(
      "conduct_tool", Range(0, t.cells), KOKKOS_LAMBDA(const int c) {
        Real sum = 0;
        for (int e = t.start(c); e < t.start(c + 1); ++e)
          sum += t.conductance(e) * (t.temperature(t.neighbor(e)) - t.temperature(c));
        t.heat(c) = dt * sum;
      });
  Kokkos::parallel_for(
      "warm_tool", Range(0, t.cells), KOKKOS_LAMBDA(const int c) { add_tool_heat(t, c, t.heat(c)); });
}

// Below C / sum of G no cell passes beyond its neighbours.
Real stable_heat_step(const ToolHeat& t) {
  Real least = Kokkos::Experimental::infinity_v<Real>;
  Kokkos::parallel_reduce(
      "stable_heat_step_tool", Range(0, t.cells),
      KOKKOS_LAMBDA(int c, Real& dt) {
        Real sum = 0;
        for (int e = t.start(c); e < t.start(c + 1); ++e) sum += t.conductance(e);
        if (sum > Real(0)) dt = Kokkos::min(dt, t.capacity(c) / sum);
      },
      Kokkos::Min<Real>(least));
  return least;
}

} // namespace swarf
