// One kick and one drift. Kick: new velocity 15, external work 13; drift 6.
// Reals: velocity 3, force 3, mass in, velocity 3 out, external_work in and out; position and velocity in,
// position out. And the constraint bits.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_integrate(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const Particles& p = c.particles;
  const Motion motion{p.count,       p.position,      p.velocity,    p.force,
                      p.points.mass, p.external_work, p.constraints, {}};
  const ConstraintTable table("constraints", 1);
  for (auto _ : state) {
    kick(motion, table, Vector3{0, 0, 0}, Real(1), Real(0)); // dt 0: the cube stays as it is
    drift(motion, Real(0));
  }
  report(state, c.count(), {34, 21.0 * sizeof(Real) + sizeof(unsigned)});
}
BENCHMARK(bench_integrate)->Name("integrate")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
