// No tool: what is faster than a limit, a hundredth of the particles. Speed 5. Reals: position 3, velocity 3
// in; those found are few. And the place of a row, twice in and out.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_find_active_region(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const Tool none;
  Freeze freeze;
  freeze.speed = Real(0.99) * shear_rate * Real(cube_edge(state.range(0))) * spacing,
  freeze.cell = 4 * spacing;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        find_active_region(c.particles, HexMesh{}, {none, ToolPose{}}, freeze).extent(0));
  report(state, c.count(), {5, 6.0 * sizeof(Real) + 4 * sizeof(int)});
}
BENCHMARK(bench_find_active_region)->Name("find_active_region")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
