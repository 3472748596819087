// A pair: geometry 22, e.(K_i + K_j) e 26, k_ij 5, product and sum 6: 59. A particle: heat and
// temperature 5. Reals: temperature in, heat_shape 6 in and out, heat_state 2 out; position 3,
// inverse_support, volume, heat_state 2, heat_shape 6, mass in, heat out, temperature in and out. Of a
// neighbour position, inverse_support, volume, heat_state, heat_shape: 13.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_conduct_heat(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const Real dt = Real(1e-18); // the temperatures of the cube stay
  for (auto _ : state) conduct_heat(c.particles, c.neighbors, {}, c.materials, dt);
  report(state, c.count(), c.pair_cost(geometry_flops + 37, 5, 20, 13));
}
BENCHMARK(bench_conduct_heat)->Name("conduct_heat")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
