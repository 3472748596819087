// update_images and update_image_state; items are images. Place 18, velocity 15, K sigma 90, D 96,
// hourglass_displacement 15: 234. Reals in and out: position, velocity and hourglass_displacement 3 each,
// pair_stress and velocity_gradient 9 each; in both launches impedance 3, volume and inverse_support. And the
// source, twice.
#include "bench/support/imaged_cube.hpp"

namespace swarf::bench {
namespace {

void bench_update_images(benchmark::State& state) {
  ImagedCube c = make_imaged_cube(state.range(0));
  for (auto _ : state) {
    update_images(c.particles, c.lists, c.planes);
    update_image_state(c.particles, c.lists, c.planes);
  }
  report(state, c.lists.images, {234, 2 * 37.0 * sizeof(Real) + 2 * sizeof(int)});
}
BENCHMARK(bench_update_images)->Name("update_images")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
