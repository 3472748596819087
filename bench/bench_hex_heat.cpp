// Corners less the first 21, their modes 54, mean of the temperatures 16, gradient 48, B:B 48, hourglass
// modes and flow 89, heat of the corners 80, own heat 3, scale and sum 26: 385. Reals: gradient 24, volume,
// share, mass, temperature in; corner_heat 8 out; position and temperature of the nodes in. And connectivity,
// active, material.
#include "bench/support/hex_cube.hpp"

namespace swarf::bench {
namespace {

void bench_hex_heat(benchmark::State& state) {
  const HexCube& c = hex_cube(state.range(0));
  HexMesh mesh = c.mesh;
  add_heat(mesh);
  for (auto _ : state) hex_heat(mesh, c.materials, hex_time_step);
  report(state, c.count(), {385, (36 + 4 * c.nodes_per_hex()) * sizeof(Real) + 10 * sizeof(int)});
}
BENCHMARK(bench_hex_heat)->Name("hex_heat")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
