// dt / 3 tr L 4, its power 1, product 1. Reals: diagonal of velocity_gradient 3 in, smoothing_length in and
// out.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_evolve_smoothing_length(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  for (auto _ : state) evolve_smoothing_length(c.particles, Real(0)); // dt 0: the cube stays as it is
  report(state, c.count(), {6, 5.0 * sizeof(Real)});
}
BENCHMARK(bench_evolve_smoothing_length)->Name("evolve_smoothing_length")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
