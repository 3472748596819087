// d + b dt 6, rotation of the step 200, what the return has kept 22, turned and scaled 18. Reals:
// hourglass_displacement 3 in and out, hourglass_rate 3, damage, stress 6, plastic_strain_rate,
// velocity_gradient 9 in. And the material.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_evolve_hourglass(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  for (auto _ : state) evolve_hourglass(c.particles, c.materials, time_step); // the rate of the cube is 0
  report(state, c.count(), {246, 26.0 * sizeof(Real) + sizeof(int)});
}
BENCHMARK(bench_evolve_hourglass)->Name("evolve_hourglass")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
