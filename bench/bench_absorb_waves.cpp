// All particles in the ramp. Share that is kept 3, energy 11, velocity 3. Reals: damping, mass in, velocity 3
// and external_work in and out. And the constraint bits.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_absorb_waves(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const Particles& p = c.particles;
  Kokkos::deep_copy(p.damping, Real(1e6));
  const Motion motion{p.count,       p.position,      p.velocity,    p.force,
                      p.points.mass, p.external_work, p.constraints, {}};
  for (auto _ : state) absorb_waves(motion, p.damping, Real(1), Real(0)); // dt 0: the cube stays as it is
  report(state, c.count(), {17, 10.0 * sizeof(Real) + sizeof(unsigned)});
}
BENCHMARK(bench_absorb_waves)->Name("absorb_waves")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
