// A pair: x_ij 3, 1/h_ij 1, r^2 5, q 2, W 12, its mass and the sum 3: 26. A particle: density 2.
// Reals: position 3, inverse_support, volume, impedance, reference_summation in, density out. Of a neighbour
// 6.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_sum_density(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  Particles particles = c.particles;
  particles.reference_summation = ScalarField("reference_summation", particles.count);
  for (auto _ : state) sum_density(particles, c.neighbors, c.materials);
  report(state, c.count(), c.pair_cost(26, 2, 8, 6));
}
BENCHMARK(bench_sum_density)->Name("sum_density")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
