// Across two periodic faces of the cube; items are particles. Distance from a plane 6, twice; an image 18.
// Reals: position 3 in, twice; of an image position 3 in and out, inverse_support in and out. Indices: place
// out and in, for each plane; source of an image.
#include "bench/support/imaged_cube.hpp"

namespace swarf::bench {
namespace {

void bench_make_images(benchmark::State& state) {
  ImagedCube c = make_imaged_cube(state.range(0));
  for (auto _ : state) make_images(c.particles, c.lists, c.planes);
  const double share = double(c.lists.images) / c.particles.count;
  report(state, c.particles.count,
         {12 + 18 * share, (6 + 8 * share) * sizeof(Real) + (4 + 2 * share) * sizeof(int)});
}
BENCHMARK(bench_make_images)->Name("make_images")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
