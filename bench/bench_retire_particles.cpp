// find_work and retire_particles; all are work, as most are. How far it has moved 8, twice. Reals: position
// 3 and first position 3 in, twice; the point of the work 3 out and in. Indices: constraints and identity,
// twice; and key and row, sorted.
#include "bench/support/particle_cube.hpp"
#include "tests/support/box_tool.hpp"

namespace swarf::bench {
namespace {

void bench_retire_particles(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const double edge = double(spacing);
  const Tool tool = test::make_box_tool({edge, edge, edge}, 2 * edge);
  ToolPose pose;
  pose.position = {Real(-10 * cube_edge(state.range(0))) * spacing, 0, 0};
  Retire retire;
  retire.distance = 20 * spacing, retire.reach = spacing;
  retire.first_position = VectorField("first_position", c.particles.count);
  const VectorField from = c.particles.position, to = retire.first_position;
  const IndexField identity("identity", c.particles.count);
  Particles particles = c.particles;
  particles.identity = identity;
  Kokkos::parallel_for(
      "bench_identity", Range(0, particles.count), KOKKOS_LAMBDA(int i) {
        identity(i) = i;
        store_vector(to, i, load_vector(from, i));
      });
  for (auto _ : state) {
    const VectorField work = find_work(particles, HexMesh{}, {tool, pose}, retire);
    retire_particles(particles, work, {tool, pose}, retire);
  }
  report(state, c.count(), {16, 18.0 * sizeof(Real) + 4 * sizeof(int) + 2 * 16});
}
BENCHMARK(bench_retire_particles)->Name("retire_particles")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
