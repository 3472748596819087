// sigma K 45, D 6, impedance 8, V 1: 60. With artificial stress R 6 and, for a point in tension, as nine of
// ten are here, five Jacobi sweeps: 15 rotations of 67, and 77 for the test and the sum. Reals: stress 6,
// density, mass in, velocity_gradient 9 and pair_stress 9 in and out, impedance 3, volume out, and
// artificial_stress 6 out.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_prepare_pair_state(benchmark::State& state, Real epsilon) {
  const ParticleCube& c = particle_cube(state.range(0));
  ParticleMethod method = c.method;
  method.artificial_stress = epsilon;
  Particles particles = c.particles;
  if (epsilon == 0) particles.artificial_stress = SymmetricField();
  velocity_gradient(particles, c.neighbors, method);
  const TensorField K = Kokkos::create_mirror(particles.pair_stress);
  Kokkos::deep_copy(K, particles.pair_stress);
  for (auto _ : state) {
    prepare_pair_state(particles, c.materials, method);
    state.PauseTiming(); // sigma K has taken the place of K: anew, or it would grow without bound
    Kokkos::deep_copy(particles.pair_stress, K);
    state.ResumeTiming();
  }
  const bool tensile = epsilon > 0;
  const double reals = tensile ? 54 : 48;
  report(state, c.count(), {60.0 + (tensile ? 6 + 15 * 67 + 77 : 0), reals * sizeof(Real) + sizeof(int)});
}
BENCHMARK_CAPTURE(bench_prepare_pair_state, plain, Real(0))->Name("prepare_pair_state")->Apply(all_sizes);
BENCHMARK_CAPTURE(bench_prepare_pair_state, artificial, Real(0.3))
    ->Name("prepare_pair_state, artificial stress")
    ->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
