// A pair: geometry 22, v_ji 3, V grad W 4, L 18, A 12: 59. A particle: K = A^-1 and its blend 119, L K 45,
// sym K 6. Reals: position 3, velocity 3, volume, inverse_support in, also of a neighbour;
// velocity_gradient 9, pair_stress 9, heat_shape 6 out.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_velocity_gradient(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  for (auto _ : state) velocity_gradient(c.particles, c.neighbors, c.method);
  report(state, c.count(), c.pair_cost(37, 170, 32, 8, 1, geometry_flops));
}
BENCHMARK(bench_velocity_gradient)->Name("velocity_gradient")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
