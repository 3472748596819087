// Before the run only. A box, all its 12 facets in one cell: of each the regions of a triangle, about 60.
// Reals: place 3 in, distance and normal 4 out.
#include "bench/support/particle_cube.hpp"
#include "tests/support/box_tool.hpp"

namespace swarf::bench {
namespace {

void bench_distance_to_tool(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const Tool box = test::make_box_tool({1, 1, 1}, 1);
  for (auto _ : state) benchmark::DoNotOptimize(distance_to_tool(box, c.particles.position).data());
  report(state, c.count(), {12 * 60, 7.0 * sizeof(Real)});
}
BENCHMARK(bench_distance_to_tool)->Name("distance_to_tool")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
