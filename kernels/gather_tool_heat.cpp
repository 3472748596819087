// What points have brought to the tool since the last call, to its cells: T_c += sum of heat_to_tool / C_c
// over the points of the cell in the order of their rows, whatever the number of threads: places in a cell's
// list are dealt out in any order, by integers, and the list is then sorted. Reads tool_cell; reads and
// zeroes heat_to_tool; writes temperature, out, first, source.
#include "swarf/kernels.hpp"

namespace swarf {
namespace {

// Rows of the points of each cell: source[first[c] .. first[c + 1]).
void list_points(const ContactPoints& points, const ToolHeat& t, int rows) {
  Kokkos::deep_copy(t.first, 0);
  Kokkos::parallel_for(
      "count_by_cell", Range(0, rows), KOKKOS_LAMBDA(const int i) {
        // Atomic on an integer: a count is the same in any order.
        if (points.heat_to_tool(i) != 0) Kokkos::atomic_inc(&t.first(points.tool_cell(i)));
      });
  Kokkos::parallel_scan(
      "start_of_cell", Range(0, t.cells + 1), KOKKOS_LAMBDA(const int c, int& sum, const bool is_last) {
        sum += t.first(c);
        if (is_last) t.first(c) = sum; // one past the cell's last: the next launch counts down
      });
  Kokkos::parallel_for(
      "place_by_cell", Range(0, rows), KOKKOS_LAMBDA(const int i) {
        if (points.heat_to_tool(i) != 0)
          t.source(Kokkos::atomic_dec_fetch(&t.first(points.tool_cell(i)))) = i;
      });
}

SWARF_FN void sort_rows(const IndexField& rows, int begin, int end) { // few: by insertion
  for (int k = begin + 1; k < end; ++k) {
    const int row = rows(k);
    int at = k;
    for (; at > begin && rows(at - 1) > row; --at) rows(at) = rows(at - 1);
    rows(at) = row;
  }
}

} // namespace

void gather_tool_heat(const ContactPoints& points, const ToolHeat& t) {
  const int rows = int(points.heat_to_tool.extent(0));
  if (rows == 0 || t.cells == 0) return;
  list_points(points, t, rows);
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
