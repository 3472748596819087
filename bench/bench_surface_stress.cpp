// A neighbour at the surface: geometry 22, s.x 6, sum 18: 46 a pair, and once for all lanes T 27. They are a
// share of all neighbours. A particle: its own T 45, t 18. Reals: position 3, inverse_support, volume, stress
// 6, surface_shift 4 in, surface_term 9 out. Of a neighbour one, of those at the surface 15.
#include "bench/support/surface_cube.hpp"

namespace swarf::bench {
namespace {

void bench_surface_stress(benchmark::State& state) {
  const SurfaceCube s = surface_cube(state.range(0));
  correct_surface(s.particles, s.cube.neighbors, {});
  for (auto _ : state) surface_stress(s.particles, s.cube.neighbors, {});
  const auto shift = host_copy(s.particles.surface_shift);
  double share = 0;
  for (int i = 0; i < s.particles.count; ++i) share += shift(i, 0) != 0;
  share /= s.particles.count;
  report(state, s.cube.count(),
         s.cube.pair_cost(share * (46 + 27.0 / pack_width), share * 63, 24, 1 + share * 14));
}
BENCHMARK(bench_surface_stress)->Name("surface_stress")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
