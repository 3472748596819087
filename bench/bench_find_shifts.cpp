// A pair: geometry 22, V grad W 4, q 2, W 12, over W(spacing) 1, gradient 3, pairing 8, surface 9, A 12: 73.
// A particle: K and its blend 119, K d 15, the shift 85. Reals: position 3, inverse_support, volume,
// surface_normal 3, contact_force 3, friction_force 3, both strains in, displacement 3, corrected 3, normal 3
// out. Of a neighbour
// 8. And the constraint bits.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_find_shifts(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  Particles particles = c.particles;
  particles.surface_normal = VectorField("surface_normal", particles.count);
  particles.shifted_strain = ScalarField("shifted_strain", particles.count);
  Kokkos::deep_copy(particles.shifted_strain, Real(-1)); // all have flowed
  for (auto _ : state) find_shifts(particles, c.neighbors, {}, c.method);
  Cost cost = c.pair_cost(geometry_flops + 51, 219, 25, 8);
  cost.bytes += sizeof(unsigned);
  report(state, c.count(), cost);
}
BENCHMARK(bench_find_shifts)->Name("find_shifts")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
