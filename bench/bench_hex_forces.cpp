// Corners less the first 42, modes of position and velocity 108, hourglass rates 72, stiffness 52, rotation
// 166, update 144, corner forces 262, wave speed and works 15, bulk viscosity with the length of the hex 150
// for those in compression, half of them here: 936. Reals: volume, share, density, plastic_strain_rate,
// gradient 24, velocity_gradient 9, stress 6 in; hourglass 12 and two works in and out; corner_force 24 out;
// position and velocity of the nodes in. And connectivity, active, material.
#include "bench/support/hex_cube.hpp"

namespace swarf::bench {
namespace {

void bench_hex_forces(benchmark::State& state) {
  const HexCube& c = hex_cube(state.range(0));
  for (auto _ : state) hex_forces(c.mesh, c.materials, c.method, hex_time_step);
  report(state, c.count(), {936, (95 + 6 * c.nodes_per_hex()) * sizeof(Real) + 10 * sizeof(int)});
}
BENCHMARK(bench_hex_forces)->Name("hex_forces")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
