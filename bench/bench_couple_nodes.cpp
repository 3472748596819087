// Forces in and velocities out, as twice in a step; items are pairs of nodes, as many as asked for, on two
// faces of a plate. Turns 15 each, thrice, mean 6: 51. Reals: force 6 in and out, velocity 3 in, 3 out.
// Indices 3, twice.
#include "bench/support/hex_cube.hpp"

namespace swarf::bench {
namespace {

void bench_couple_nodes(benchmark::State& state) {
  const int n = std::max(2, int(std::lround(std::sqrt(double(state.range(0))))) - 1);
  HexMesh mesh = test::make_hex_block({n, n, 1}, test::ti64(), hex_edge);
  const int pairs = (n + 1) * (n + 1);
  mesh.coupled_nodes = View<int* [3]>("coupled_nodes", pairs);
  const View<int* [3]> rows = mesh.coupled_nodes;
  Kokkos::parallel_for(
      "bench_pairs", Range(0, pairs), KOKKOS_LAMBDA(int k) { rows(k, 0) = k, rows(k, 1) = pairs + k; });
  const TransformTable table("transforms", 1);
  Kokkos::deep_copy(table, Transform{identity3(), {0, 0, hex_edge}});
  for (auto _ : state) couple_nodes(mesh, table, true), couple_nodes(mesh, table, false);
  report(state, pairs, {51, 18.0 * sizeof(Real) + 6 * sizeof(int)});
}
BENCHMARK(bench_couple_nodes)->Name("couple_nodes")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
