// A pair: geometry 22, V grad W 4, u_ji 6, v_ji 3, two outer products 36, A 12: 83. A particle: K_0 and its
// blend 119, F 54, J 14, two inverses 72, J F^-T K_0 45, L 90, sym K 6, u 3: 403. Reals: position 3,
// build_position 3, velocity 3, volume, inverse_support in; deformation_gradient 9, velocity_gradient 9,
// pair_stress 9, heat_shape 6 out. Of a neighbour 11.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_reference_gradient(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  Particles particles = c.particles;
  particles.deformation_gradient = TensorField("deformation_gradient", particles.count);
  for (auto _ : state) reference_gradient(particles, c.neighbors);
  report(state, c.count(), c.pair_cost(61, 403, 44, 11, 1, geometry_flops));
}
BENCHMARK(bench_reference_gradient)->Name("reference_gradient")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
