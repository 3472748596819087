// update_ghosts and update_ghost_state; items are ghosts. Place 18, velocity 15, K sigma 90, D 96,
// hourglass_displacement 15: 234. Reals in and out: position, velocity and hourglass_displacement 3 each,
// pair_stress and velocity_gradient 9 each; in both launches impedance 3, volume and inverse_support. And the
// source, twice.
#include "bench/support/cube_with_ghosts.hpp"

namespace swarf::bench {
namespace {

void bench_update_ghosts(benchmark::State& state) {
  CubeWithGhosts c = make_cube_with_ghosts(state.range(0));
  for (auto _ : state) {
    update_ghosts(c.particles, c.lists, c.planes);
    update_ghost_state(c.particles, c.lists, c.planes);
  }
  report(state, c.lists.ghosts, {234, 2 * 37.0 * sizeof(Real) + 2 * sizeof(int)});
}
BENCHMARK(bench_update_ghosts)->Name("update_ghosts")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
