// gather_heat and spread_temperature; items are tied particles, eight in each hex. A tied particle:
// temperature of the host 16, twice, own heat 4, shares of the nodes 16: 52. A hex: corners 8, mean 9. A
// node: 2. Reals of a tied particle: shape 8, thrice, and mass in, heat and temperature in and out; of a hex
// corner_heat 8 in, temperature out; of a node capacity in, nodal_heat out, nodal_temperature in and out.
// Indices: row, host, material and 8 entries; connectivity 8 and corners 8 of a hex; starts and row of a
// node.
#include "bench/support/tied_cube.hpp"

namespace swarf::bench {
namespace {

void bench_gather_heat(benchmark::State& state) {
  const TiedCube& c = tied_cube(state.range(0));
  for (auto _ : state) {
    gather_heat(c.tie, c.particles, c.hexes, c.materials);
    spread_temperature(c.tie, c.particles, c.hexes, c.materials);
  }
  const double reals = 29 + 9 * c.hosts() + 4 * c.nodes(), indices = 11 + 16 * c.hosts() + 3 * c.nodes();
  report(state, c.count(),
         {52 + 17 * c.hosts() + 2 * c.nodes(), reals * sizeof(Real) + indices * sizeof(int)});
}
BENCHMARK(bench_gather_heat)->Name("gather_heat")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
