// h / c 8, pair terms 21, rate 2; displacement 8. Reals: inverse_support, diagonal of velocity_gradient 3,
// position 3, build_position 3 in. And the material.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_stable_step(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(stable_step(c.particles, c.neighbors, c.materials, {c.method, 1}).dt);
  report(state, c.count(), {39, 10.0 * sizeof(Real) + sizeof(int)});
}
BENCHMARK(bench_stable_step)->Name("stable_step")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
