// Stored 4, plastic 2. Reals: mass, temperature, plastic work in. Index: material.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_sum_heat(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(sum_heat(c.particles, c.materials, Real(298)).work);
  report(state, c.count(), {6, 3.0 * sizeof(Real) + sizeof(int)});
}
BENCHMARK(bench_sum_heat)->Name("sum_heat")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
