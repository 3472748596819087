// A pair: geometry 24, v_ij 3, V grad W 4, x.v 5, viscosity 43 (x.(D_i + D_j) x alone 24), sum of grad W 3,
// P_j and q times it 25, powers 9: 116; the artificial stress another 46: W(r)^4 14, (R_i + R_j) grad W 26,
// power 6. A particle: own stress 18, works 8, scale 3, 1/h 1. Reals: position 3, velocity 3, volume,
// smoothing_length, pair_stress 9, strain_rate 6, impedance 2 in (and artificial_stress 6); force 3 out; the
// two works in and out.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_particle_forces(benchmark::State& state, Real epsilon) {
  const ParticleCube& c = particle_cube(state.range(0));
  ParticleMethod method = c.method;
  method.artificial_stress = epsilon;
  prepare_pair_state(c.particles, c.materials, method);
  for (auto _ : state) particle_forces(c.particles, c.neighbors, method, Real(0));
  const bool artificial = epsilon > 0;
  report(state, c.count(),
         c.pair_cost(geometry_flops + 92 + (artificial ? 46 : 0), 30, artificial ? 38 : 32));
}
BENCHMARK_CAPTURE(bench_particle_forces, plain, Real(0))->Name("particle_forces")->Apply(all_sizes);
BENCHMARK_CAPTURE(bench_particle_forces, artificial, Real(0.3))
    ->Name("particle_forces, artificial stress")
    ->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
