// Once per frame. Of a tool that does not conduct: divisions 4, products 2. Reals: sums 5, area in; 5 out.
#include "bench/support/hot_tool.hpp"

namespace swarf::bench {
namespace {

Tool make_felt_tool(int64_t size) {
  Tool tool;
  tool.surface.patches = int(size);
  tool.surface.sums = View<Real* [surface_sums]>("sums", size);
  tool.surface.area = ScalarField("area", size);
  Kokkos::deep_copy(tool.surface.sums, Real(1)), Kokkos::deep_copy(tool.surface.area, Real(1));
  return tool;
}

void bench_show_tool_surface(benchmark::State& state) {
  const Tool& tool = cached(state.range(0), make_felt_tool);
  for (auto _ : state) show_tool_surface(tool, 1);
  report(state, tool.surface.patches, {6, 11.0 * sizeof(Real)});
}
BENCHMARK(bench_show_tool_surface)->Name("show_tool_surface")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
