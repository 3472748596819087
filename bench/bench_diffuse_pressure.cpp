// Two passes over the pairs. Gradient: geometry 22, V (p_j - p_i) grad W 9. Diffusion: geometry 22, what the
// gradients do not explain 11, c 2, product and sum 5: 71. A particle: p 3, K times the gradient 15,
// changes 23. Reals: stress 3 in, pressure_state 4 out; position 3, inverse_support, volume, p, correction 9
// in, gradient 3 out; position 3, inverse_support, volume, pressure_state 4, impedance 2, velocity_gradient
// 3 in, stress 3, density and two works in and out. Of a neighbour 6 and 11.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_diffuse_pressure(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  velocity_gradient(c.particles, c.neighbors, c.method); // K, whose place the pair stress took
  // The time of a call is so short that the pressures of the cube stay.
  const PressureDiffusion set{Real(0.003), Real(1e-18), Real(0), true};
  for (auto _ : state) diffuse_pressure(c.particles, c.neighbors, {}, c.materials, set);
  report(state, c.count(), c.pair_cost(2 * geometry_flops + 27, 41, 50, 17, 2));
}
BENCHMARK(bench_diffuse_pressure)->Name("diffuse_pressure")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
