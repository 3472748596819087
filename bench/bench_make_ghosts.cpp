// Across two periodic faces of the cube; items are particles. Distance from a plane 6, twice; a ghost 18.
// Reals: position 3 in, twice; of a ghost position 3 in and out, inverse_support in and out. Indices: place
// out and in, for each plane; source of a ghost.
#include "bench/support/cube_with_ghosts.hpp"

namespace swarf::bench {
namespace {

void bench_make_ghosts(benchmark::State& state) {
  CubeWithGhosts c = make_cube_with_ghosts(state.range(0));
  for (auto _ : state) make_ghosts(c.particles, c.lists, c.planes);
  const double share = double(c.lists.ghosts) / c.particles.count;
  report(state, c.particles.count,
         {12 + 18 * share, (6 + 8 * share) * sizeof(Real) + (4 + 2 * share) * sizeof(int)});
}
BENCHMARK(bench_make_ghosts)->Name("make_ghosts")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
