// Density times volume 1, of the ratio the cube root 2, product 1. Reals: mass, density, volume in,
// inverse_support in and out.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_evolve_smoothing_length(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  for (auto _ : state) evolve_smoothing_length(c.particles); // V = m / rho: the cube stays as it is
  report(state, c.count(), {4, 5.0 * sizeof(Real)});
}
BENCHMARK(bench_evolve_smoothing_length)->Name("evolve_smoothing_length")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
