// Across two periodic faces of the cube; items are particles. Distance from a plane 6, twice; an image 18.
// Reals: position 3 in, twice; of an image position 3 in and out, smoothing_length in and out. Indices: place
// out and in, for each plane; source of an image.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_make_images(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const Real edge = Real(cube_edge(state.range(0))) * spacing;
  const Vector3 z{0, 0, 1};
  const ImagePlanes planes = {{z, 0, {identity3(), edge * z}, true, true},
                              {Real(-1) * z, -edge, {identity3(), (-edge) * z}, true, true}};
  Particles particles = c.particles; // longer than the cube's, by the images
  Neighbors lists;
  lists.cutoff = c.neighbors.cutoff;
  make_images(particles, lists, planes);
  for (auto _ : state) make_images(particles, lists, planes);
  const double share = lists.images / c.count();
  report(state, c.count(), {12 + 18 * share, (6 + 8 * share) * sizeof(Real) + (4 + 2 * share) * sizeof(int)});
}
BENCHMARK(bench_make_images)->Name("make_images")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
