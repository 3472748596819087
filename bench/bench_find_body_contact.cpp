// Items are hexes: most of them lie inside, where each side is asked for what is behind it. Six sides:
// indices of what is behind, 6, and whether it is active; of each node a position in and out.
#include "bench/support/two_cubes.hpp"

namespace swarf::bench {
namespace {

void bench_find_body_contact(benchmark::State& state) {
  const test::TwoBlocks& b = two_cubes(state.range(0));
  BodyContact contact = b.contact;
  for (auto _ : state) find_body_contact(contact, b.mesh, b.particles, b.groups);
  report(state, b.mesh.points.count, {0, 6 * sizeof(Real) + 13 * sizeof(int)});
}
BENCHMARK(bench_find_body_contact)->Name("find_body_contact")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
