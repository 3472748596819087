// As many cells of heat as asked for, in a row, and as many points that bring heat to them.
#pragma once
#include "bench/support/bench.hpp"
#include "swarf/kernels.hpp"
#include "tests/support/box_tool.hpp"
#include "tests/support/tool_bar.hpp"
#include <bit>

namespace swarf::bench {

struct HotTool {
  ToolHeat heat;
  ContactPoints points;
};

inline void bring_heat(const HotTool& t) {
  const ContactPoints p = t.points;
  const int cells = t.heat.cells;
  Kokkos::parallel_for(
      "bench_heat", Range(0, p.count),
      KOKKOS_LAMBDA(int i) { p.heat_to_tool(i) = 1, p.tool_cell(i) = int(i * 7919L % cells); });
}

inline HotTool make_hot_tool(int64_t size) {
  const int points = int(size), levels = std::bit_width(unsigned(size)) - 1;
  HotTool t{test::make_tool_bar(levels, points), test::make_contact_points(points, 1)};
  t.points.heat_to_tool = ScalarField("heat_to_tool", std::size_t(points));
  t.points.tool_cell = IndexField("tool_cell", std::size_t(points));
  return t;
}

inline const HotTool& hot_tool(int64_t size) { return cached(size, make_hot_tool); }

} // namespace swarf::bench
