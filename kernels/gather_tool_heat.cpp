// What points have brought to the tool since the last call, to its cells: T_c += sum of heat_to_tool / C_c
// over the points of the cell in the order of their rows, whatever the number of threads: places in a cell's
// list are dealt out in any order, by integers, and the list is then sorted. Reads tool_cell; reads and
// zeroes heat_to_tool; writes temperature, out, first, source.
#include "rows_by_key.hpp"
#include "swarf/kernels.hpp"

namespace swarf {

void gather_tool_heat(const ContactPoints& points, const ToolHeat& t) {
  const int rows = int(points.heat_to_tool.extent(0));
  if (rows == 0 || t.cells == 0) return;
  const ScalarField brought = points.heat_to_tool;
  list_rows_by_key(
      "tool_heat", points.tool_cell, rows, t.first, t.source,
      KOKKOS_LAMBDA(int i) { return brought(i) != 0; });
  Kokkos::parallel_for(
      "gather_tool_heat", Range(0, t.cells), KOKKOS_LAMBDA(const int c) {
        const int begin = t.first(c), end = t.first(c + 1);
        if (begin == end) return;
        sort_rows(t.source, begin, end);
        Real sum = 0;
        for (int k = begin; k < end; ++k) {
          sum += points.heat_to_tool(t.source(k));
          points.heat_to_tool(t.source(k)) = 0;
        }
        add_tool_heat(t, c, sum);
      });
}

} // namespace swarf
