// Two planes that nothing leaves through, as at most rebuilds of the lists for most particles: 5 each.
// Position 3 in, twice.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_wrap_periodic(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const Real edge = Real(cube_edge(state.range(0)) + 1) * spacing;
  const Vector3 z{0, 0, 1};
  const GhostPlanes planes = {{z, -spacing, {identity3(), edge * z}, true, true},
                              {Real(-1) * z, -edge, {identity3(), (-edge) * z}, true, true}};
  for (auto _ : state) wrap_periodic(c.particles, planes, c.status);
  report(state, c.count(), {10, 6.0 * sizeof(Real)});
}
BENCHMARK(bench_wrap_periodic)->Name("wrap_periodic")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
