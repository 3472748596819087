// update_images and update_image_state; items are images. Place 18, velocity 15, K sigma and artificial
// stress 90 each, D 96, hourglass_displacement 15: 324. Reals in and out: position, velocity and
// hourglass_displacement 3 each, pair_stress and velocity_gradient 9 each, artificial_stress 6; in both
// launches impedance 3, volume and smoothing_length. And the source, twice.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_update_images(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const Real edge = Real(cube_edge(state.range(0))) * spacing;
  const Vector3 z{0, 0, 1};
  const ImagePlanes planes = {{z, 0, {identity3(), edge * z}, true, true},
                              {Real(-1) * z, -edge, {identity3(), (-edge) * z}, true, true}};
  Particles particles = c.particles; // longer than the cube's, by the images
  Neighbors lists;
  lists.cutoff = c.neighbors.cutoff;
  make_images(particles, lists, planes);
  for (auto _ : state) {
    update_images(particles, lists, planes);
    update_image_state(particles, lists, planes);
  }
  report(state, lists.images, {324, 2 * 43.0 * sizeof(Real) + 2 * sizeof(int)});
}
BENCHMARK(bench_update_images)->Name("update_images")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
