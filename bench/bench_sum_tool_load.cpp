// None touches, as most do not: no operation. Area and contact_force 3 in.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_sum_tool_load(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const Particles& p = c.particles;
  ContactPoints points;
  points.count = p.count, points.position = p.position, points.area = p.contact_area;
  points.contact_force = VectorField("contact_force", p.count);
  const ToolLoadSums sums = make_tool_load_sums(p.count);
  const Tool none;
  for (auto _ : state) sum_tool_load(points, none, ToolPose{}, time_step, sums);
  report(state, c.count(), {0, 4.0 * sizeof(Real)});
}
BENCHMARK(bench_sum_tool_load)->Name("sum_tool_load")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
