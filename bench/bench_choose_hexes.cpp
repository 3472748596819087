// A tool that is far from all: middle of the corners 27, place in the tool's frame and cell of its grid 15.
// Reals: both limits and equivalent_plastic_strain in; position of the nodes in. Indices: connectivity 8,
// active in, chosen out.
#include "bench/support/hex_cube.hpp"
#include "tests/support/box_tool.hpp"

namespace swarf::bench {
namespace {

void bench_choose_hexes(benchmark::State& state) {
  const HexCube& c = hex_cube(state.range(0));
  const double far = -10 * cube_edge(state.range(0)) * double(hex_edge), edge = double(hex_edge);
  ConversionLimits limits{ScalarField("distance", c.mesh.points.count),
                          ScalarField("strain", c.mesh.points.count),
                          test::make_box_tool({edge, edge, edge}, 2 * edge)};
  Kokkos::deep_copy(limits.distance, Real(edge)), Kokkos::deep_copy(limits.strain, Real(1));
  ToolPose pose;
  pose.position = {Real(far), 0, 0};
  for (auto _ : state) benchmark::DoNotOptimize(choose_hexes(c.mesh, limits, pose).extent(0));
  report(state, c.count(), {42, (3 + 3 * c.nodes_per_hex()) * sizeof(Real) + 10 * sizeof(int)});
}
BENCHMARK(bench_choose_hexes)->Name("choose_hexes")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
