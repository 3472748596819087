// Items are points that bring heat, one or two to a cell: far more than touch a tool. One sum; a cell's
// division and sum. Reals: heat in thrice, out; capacity, temperature of the cell. Indices: cell twice,
// first, source.
#include "bench/support/hot_tool.hpp"

namespace swarf::bench {
namespace {

void bench_gather_tool_heat(benchmark::State& state) {
  const HotTool& t = hot_tool(state.range(0));
  for (auto _ : state) {
    state.PauseTiming();
    bring_heat(t);
    Kokkos::fence(); // the clock must not count what makes the heat
    state.ResumeTiming();
    gather_tool_heat(t.points, t.heat);
  }
  report(state, t.points.count, {3, 6.0 * sizeof(Real) + 6 * sizeof(int)});
}
BENCHMARK(bench_gather_tool_heat)->Name("gather_tool_heat")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
