// What points have done to the tool since the last call, to the patches of its surface: the sums of on_tool
// over the points of a patch in the order of their rows, whatever the number of threads. A point that has
// gone on since it touched counts where it touched last. Reads tool_patch; reads and zeroes on_tool; adds to
// sums; writes first, source.
#include "rows_by_key.hpp"
#include "swarf/kernels.hpp"

namespace swarf {

void gather_tool_surface(const ContactPoints& points, const ToolSurface& s) {
  const int rows = int(points.on_tool.extent(0));
  if (rows == 0 || s.patches == 0) return;
  const auto brought = points.on_tool;
  list_rows_by_key(
      "tool_surface", points.tool_patch, rows, s.first, s.source,
      KOKKOS_LAMBDA(int i) { return brought(i, sum_impulse) != 0 || brought(i, sum_friction) != 0; });
  Kokkos::parallel_for(
      "gather_tool_surface", Range(0, s.patches), KOKKOS_LAMBDA(const int p) {
        const int begin = s.first(p), end = s.first(p + 1);
        if (begin == end) return;
        sort_rows(s.source, begin, end);
        for (int q = 0; q < surface_sums; ++q) {
          Real sum = 0;
          for (int k = begin; k < end; ++k) {
            sum += points.on_tool(s.source(k), q);
            points.on_tool(s.source(k), q) = 0;
          }
          s.sums(p, q) += sum;
        }
      });
}

} // namespace swarf
