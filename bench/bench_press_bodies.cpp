// Items are points of faces that touch. Of each of 9 faces near: four triangles, 60 each; the response, 60;
// gathers 100. Reals: of both faces 12 positions, of the nodes 12 velocities and 6 forces; what a point does,
// 13 out and in, and its memory 3. Indices: the list 9.
#include "bench/support/two_cubes.hpp"
#include "swarf/tool/contact_law.hpp"

namespace swarf::bench {
namespace {

void bench_press_bodies(benchmark::State& state) {
  const test::TwoBlocks& b = two_cubes(state.range(0));
  ContactLaw law;
  law.friction = Real(0.3), law.stiffness = 1;
  for (auto _ : state) press_bodies(b.contact, b.mesh, b.particles, {law, b.materials, Real(1), Real(1e-6)});
  report(state, double(points_of_face) * b.contact.faces,
         {9 * 4 * 60 + 160, 49 * sizeof(Real) + 9 * sizeof(int)});
}
BENCHMARK(bench_press_bodies)->Name("press_bodies")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
