// Items are tied particles, eight in each hex. Position and velocity from eight nodes, 12 each. Reals: shape
// 8 in, position and velocity 6 out; of a node 6 in. Indices: identity, host; connectivity 8 of a hex.
#include "bench/support/tied_cube.hpp"

namespace swarf::bench {
namespace {

void bench_project_tie(benchmark::State& state) {
  const TiedCube& c = tied_cube(state.range(0));
  for (auto _ : state) project_tie(c.tie, c.particles, c.hexes);
  report(state, c.count(), {96, (14 + 6 * c.nodes()) * sizeof(Real) + (2 + 8 * c.hosts()) * sizeof(int)});
}
BENCHMARK(bench_project_tie)->Name("project_tie")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
