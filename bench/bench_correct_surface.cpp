// A pair of a cluster at the surface: geometry 22 and grad W 3, twice; moments 14, s.grad W 6, sum 18: 88. A
// particle: s and its sum 40, the change 60. Reals: position 3, inverse_support, volume, velocity_gradient 9
// in and out, surface_shift 4 in and out, pair_stress 9, surface_term 9 out and in. Of a neighbour 14. All
// times the share of those clusters; of the others surface_shift.
#include "bench/support/surface_cube.hpp"

namespace swarf::bench {
namespace {

void bench_correct_surface(benchmark::State& state) {
  const SurfaceCube s = surface_cube(state.range(0));
  for (auto _ : state) {
    correct_surface(s.particles, s.cube.neighbors, {});
    state.PauseTiming();
    s.start_anew();
    state.ResumeTiming();
  }
  const double share = s.share();
  report(state, s.cube.count(), s.cube.pair_cost(share * 88, share * 100, 1 + share * 57, share * 14, 2));
}
BENCHMARK(bench_correct_surface)->Name("correct_surface")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
