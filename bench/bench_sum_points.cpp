// Kinetic energy and speed 10, momentum 6, seven sums 7. Reals: mass, velocity 3, seven energies, plastic
// strain, temperature in.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_sum_points(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(sum_particles(c.particles, Real(1)).kinetic);
  report(state, c.count(), {23, 13.0 * sizeof(Real)});
}
BENCHMARK(bench_sum_points)->Name("sum_points")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
