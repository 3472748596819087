// 16 columns: velocity 3, hourglass_displacement 3, stress 6, density, temperature, plastic strain, damage. A
// pair: geometry 22, V grad W . K d 8, whether it is near 1, each column 4: 95. A particle: sums 34, changes
// 44, energies 76, place and works 20. Reals: the columns and the material 17 in and out; position 3,
// inverse_support, volume, corrected 3, 17 in, changes 16 out; changes 16 and mass in; changes 16,
// displacement 3, normal 3, mass, volume in, surface_normal 3 out, position 3, the columns, two works and
// shifted_strain in and out. Of a neighbour 22. And the material, three times.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_transport_fields(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  Particles particles = c.particles;
  particles.surface_normal = VectorField("surface_normal", particles.count);
  particles.shifted_strain = ScalarField("shifted_strain", particles.count);
  particles.shifting_work = ScalarField("shifting_work", particles.count);
  Kokkos::deep_copy(particles.shifted_strain, Real(-1e-12)); // shifts so short that the cube stays
  const Shifts shifts = find_shifts(particles, c.neighbors, {}, c.method);
  for (auto _ : state) transport_fields(particles, c.neighbors, {}, c.materials, shifts, Real(1));
  Cost cost = c.pair_cost(geometry_flops + 73, 174, 163, 22);
  cost.bytes += 3 * sizeof(int);
  report(state, c.count(), cost);
}
BENCHMARK(bench_transport_fields)->Name("transport_fields")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
