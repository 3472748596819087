// All active, one cell of the active region; items are hexes. A node: distance 14, damping 4. Reals of a
// node: position 3 in, damping out. Indices: constraints of a node in and out; connectivity 8, active in and
// out.
#include "bench/support/hex_cube.hpp"

namespace swarf::bench {
namespace {

void bench_freeze_hexes(benchmark::State& state) {
  const HexCube& c = hex_cube(state.range(0));
  HexMesh mesh = c.mesh;
  mesh.damping = ScalarField("damping", mesh.nodes);
  const VectorField region("active_region", 1);
  Freeze freeze;
  freeze.distance = 10 * Real(cube_edge(state.range(0))) * hex_edge,
  freeze.ramp = Real(0.5) * freeze.distance;
  freeze.cell = freeze.distance / 16;
  const double nodes = c.nodes_per_hex();
  for (auto _ : state) freeze_hexes(mesh, TransformTable(), region, freeze);
  report(state, c.count(), {18 * nodes, 4 * nodes * sizeof(Real) + (10 + 2 * nodes) * sizeof(int)});
}
BENCHMARK(bench_freeze_hexes)->Name("freeze_hexes")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
