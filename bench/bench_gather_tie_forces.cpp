// Items are tied particles, eight in each hex. The force to eight nodes, 6 each. Reals: shape 8 and force 3
// in; of a node 3 in and out. Indices: entry 8, row; start and row of a node.
#include "bench/support/tied_cube.hpp"

namespace swarf::bench {
namespace {

void bench_gather_tie_forces(benchmark::State& state) {
  const TiedCube& c = tied_cube(state.range(0));
  for (auto _ : state) gather_tie_forces(c.tie, c.particles, c.hexes);
  report(state, c.count(), {48, (11 + 6 * c.nodes()) * sizeof(Real) + (9 + 2 * c.nodes()) * sizeof(int)});
}
BENCHMARK(bench_gather_tie_forces)->Name("gather_tie_forces")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
