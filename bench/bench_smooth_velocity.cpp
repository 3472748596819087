// A pair: x_ij 3, 1/h_ij 1, r^2 5, q 2, W 12, its share 5, v_ji 3, product and sum 6: 37. A particle:
// velocity
// 6. Reals: position 3, velocity 3, inverse_support, volume, impedance in, drift_velocity 3 out. Of
// a neighbour 9. And the constraint bits.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_smooth_velocity(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  Particles particles = c.particles;
  particles.drift_velocity = VectorField("drift_velocity", particles.count);
  const ConstraintTable table("constraints", 1);
  for (auto _ : state) smooth_velocity(particles, c.neighbors, table, Real(0.1));
  Cost cost = c.pair_cost(37, 6, 12, 9);
  cost.bytes += sizeof(unsigned);
  report(state, c.count(), cost);
}
BENCHMARK(bench_smooth_velocity)->Name("smooth_velocity")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
