// None fails: two comparisons. Reals: damage, plastic strain in. And active.
#include "bench/support/hex_cube.hpp"

namespace swarf::bench {
namespace {

void bench_delete_hexes(benchmark::State& state) {
  const HexCube& c = hex_cube(state.range(0));
  HexMethod method = c.method;
  method.delete_failed = true, method.delete_at_strain = 10;
  for (auto _ : state) delete_hexes(c.mesh, method);
  report(state, c.count(), {0, 2.0 * sizeof(Real) + sizeof(int)});
}
BENCHMARK(bench_delete_hexes)->Name("delete_hexes")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
