// Two neighbours of each cell in the row: difference, product, sum 6, heat and temperature 3: 9; a real tool
// has six. Reals: conductance 2, capacity, temperature in; heat out and in; temperature out. Indices: start,
// neighbour 2.
#include "bench/support/hot_tool.hpp"

namespace swarf::bench {
namespace {

void bench_conduct_tool(benchmark::State& state) {
  const HotTool& t = hot_tool(state.range(0));
  for (auto _ : state) conduct_tool(t.heat, Real(0.1));
  report(state, t.heat.cells, {9, 7.0 * sizeof(Real) + 3 * sizeof(int)});
}
BENCHMARK(bench_conduct_tool)->Name("conduct_tool")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
