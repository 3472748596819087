// sigma K 45, D 6, impedance 8, V 1: 60. Reals: stress 6, density, mass in, velocity_gradient 9 and
// pair_stress 9 in and out, impedance 3, volume out.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_prepare_pair_state(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const Particles& particles = c.particles;
  velocity_gradient(particles, c.neighbors, c.method);
  const TensorField K = Kokkos::create_mirror(particles.pair_stress);
  Kokkos::deep_copy(K, particles.pair_stress);
  for (auto _ : state) {
    prepare_pair_state(particles, c.materials, c.method);
    state.PauseTiming(); // sigma K has taken the place of K: anew, or it would grow without bound
    Kokkos::deep_copy(particles.pair_stress, K);
    state.ResumeTiming();
  }
  report(state, c.count(), {60.0, 48 * sizeof(Real) + sizeof(int)});
}
BENCHMARK(bench_prepare_pair_state)->Name("prepare_pair_state")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
