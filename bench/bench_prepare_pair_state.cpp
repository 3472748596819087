// sigma K 45, D 6, impedance 8, R 6, V 1: 66. With artificial stress a point in tension, as nine of ten are
// here, takes five Jacobi sweeps: 15 rotations of 67, and 77 for the test and the sum. Reals: stress 6,
// correction 9, velocity_gradient 9, density, mass in; pair_stress 9, strain_rate 6, artificial_stress 6,
// impedance 2, volume out.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_prepare_pair_state(benchmark::State& state, Real epsilon) {
  const ParticleCube& c = particle_cube(state.range(0));
  ParticleMethod method = c.method;
  method.artificial_stress = epsilon;
  for (auto _ : state) prepare_pair_state(c.particles, c.materials, method);
  report(state, c.count(), {66.0 + (epsilon > 0 ? 15 * 67 + 77 : 0), 50.0 * sizeof(Real) + sizeof(int)});
}
BENCHMARK_CAPTURE(bench_prepare_pair_state, plain, Real(0))->Name("prepare_pair_state")->Apply(all_sizes);
BENCHMARK_CAPTURE(bench_prepare_pair_state, artificial, Real(0.3))
    ->Name("prepare_pair_state, artificial stress")
    ->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
