// Items are hexes. 24 additions for the eight corners of a hex; corner_force 24 Reals and 8 entries of the
// list in; for each node a start in and force 3 out.
#include "bench/support/hex_cube.hpp"

namespace swarf::bench {
namespace {

void bench_gather_corner_forces(benchmark::State& state) {
  const HexCube& c = hex_cube(state.range(0));
  for (auto _ : state) gather_corner_forces(c.mesh);
  const double node_bytes = 3 * sizeof(Real) + sizeof(int);
  report(state, c.count(), {24, 24 * sizeof(Real) + 8 * sizeof(int) + c.nodes_per_hex() * node_bytes});
}
BENCHMARK(bench_gather_corner_forces)->Name("gather_corner_forces")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
