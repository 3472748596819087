// Once per frame. Of a tool that does not conduct, where four patches press on each: products and sums 8 for
// each of 5 sums, then divisions 4, products 2. Reals: 4 shares, sums 4 x 5, area in; 5 out. Indices: 4 and
// the start.
#include "bench/support/hot_tool.hpp"

namespace swarf::bench {
namespace {

constexpr int presses = 4; // of the patches on each

Tool make_felt_tool(int64_t size) {
  Tool tool;
  tool.surface.patches = int(size);
  tool.surface.sums = View<Real* [surface_sums]>("sums", size);
  tool.surface.area = ScalarField("area", size);
  Kokkos::deep_copy(tool.surface.sums, Real(1)), Kokkos::deep_copy(tool.surface.area, Real(1));
  tool.surface.spread_start = IndexField("spread_start", size + 1);
  tool.surface.spread_from = IndexField("spread_from", presses * size);
  tool.surface.spread_share = ScalarField("spread_share", presses * size);
  Kokkos::deep_copy(tool.surface.spread_share, Real(1) / presses);
  const auto start = host_copy(tool.surface.spread_start), from = host_copy(tool.surface.spread_from);
  for (int p = 0; p <= int(size); ++p) start(p) = presses * p;
  for (int k = 0; k < presses * int(size); ++k) from(k) = (k / presses + k % presses) % int(size);
  Kokkos::deep_copy(tool.surface.spread_start, start), Kokkos::deep_copy(tool.surface.spread_from, from);
  return tool;
}

void bench_show_tool_surface(benchmark::State& state) {
  const Tool& tool = cached(state.range(0), make_felt_tool);
  for (auto _ : state) show_tool_surface(tool, 1);
  report(state, tool.surface.patches, {46, 30.0 * sizeof(Real) + 5.0 * sizeof(int)});
}
BENCHMARK(bench_show_tool_surface)->Name("show_tool_surface")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
