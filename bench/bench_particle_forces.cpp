// A pair: geometry 22, v_ij 3, V grad W 4, x.v 5, viscosity 38 (x.(D_i + D_j) x alone 24), sum of grad W 3,
// P_j and q times it 24, power 3: 99. The hourglass stiffness another 29: modulus 2, stretch 10, spring 5,
// its rate 7, power 2, sums 3. A particle: own stress 18, works 8, scale 3, its part of the coefficients 7.
// Reals: position 3, velocity 3, volume, inverse_support, pair_stress 9, velocity_gradient 9, impedance 2 in,
// also of a neighbour (and the shear modulus and hourglass_displacement 3); force 3 (and hourglass_rate 3)
// out; the two works in and out.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

struct Extra { // beyond the plain sum
  Real hourglass_stiffness;
  double pair_flops, reals, of_neighbor;
};

void bench_particle_forces(benchmark::State& state, const Extra& extra) {
  const ParticleCube& c = particle_cube(state.range(0));
  ParticleMethod method = c.method;
  method.hourglass_stiffness = extra.hourglass_stiffness;
  velocity_gradient(c.particles, c.neighbors, method); // anew: the pair stress takes its place
  prepare_pair_state(c.particles, c.materials, method);
  for (auto _ : state) particle_forces(c.particles, c.neighbors, method, Real(0));
  report(state, c.count(),
         c.pair_cost(geometry_flops + 77 + extra.pair_flops, 36, 35 + extra.reals, 28 + extra.of_neighbor));
}
BENCHMARK_CAPTURE(bench_particle_forces, plain, Extra{0, 0, 0, 0})->Name("particle_forces")->Apply(all_sizes);
BENCHMARK_CAPTURE(bench_particle_forces, stiff, Extra{Real(0.3), 29, 7, 4})
    ->Name("particle_forces, hourglass stiffness")
    ->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
