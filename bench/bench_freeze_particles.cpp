// All active, one cell of the active region, so that no row changes its rank and no field moves
// (sort_particles shows what moving costs); distance 14 and damping 4. Reals: position 3 in, distance out and
// in, damping out. Indices: identity twice in, constraints in and out, the place of a row, for what is
// carried and for what moves, each twice in and out; and its key out and four times in.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_freeze_particles(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  Particles particles = c.particles;
  const VectorField region("active_region", 1);
  Freeze freeze;
  freeze.distance = 10 * Real(cube_edge(state.range(0))) * spacing, freeze.ramp = Real(0.5) * freeze.distance;
  for (auto _ : state) freeze_particles(particles, Tie{}, region, freeze);
  report(state, c.count(), {18, 6.0 * sizeof(Real) + 12 * sizeof(int) + 5 * sizeof(long)});
}
BENCHMARK(bench_freeze_particles)->Name("freeze_particles")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
