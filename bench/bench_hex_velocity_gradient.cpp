// Corners less the first 42, six faces of 84, volume 49, B 25, L 144: 764. Reals: position and velocity of
// the nodes in; gradient 24, volume, velocity_gradient 9 out. And connectivity, active.
#include "bench/support/hex_cube.hpp"

namespace swarf::bench {
namespace {

void bench_hex_velocity_gradient(benchmark::State& state) {
  const HexCube& c = hex_cube(state.range(0));
  for (auto _ : state) hex_velocity_gradient(c.mesh, c.status);
  if (test::read_status(c.status) != no_fault) state.SkipWithError("hex_velocity_gradient reports a fault");
  report(state, c.count(), {764, (34 + 6 * c.nodes_per_hex()) * sizeof(Real) + 9 * sizeof(int)});
}
BENCHMARK(bench_hex_velocity_gradient)->Name("hex_velocity_gradient")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
