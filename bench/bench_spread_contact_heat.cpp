// Items are hexes, with eight tied particles in each. A hex: mean 9; a tied particle: 16; a node: 2. Reals: a
// hex's temperature in and out; of a tied particle shape 8, temperature in and out; of a node contact_heat,
// nodal_heat, capacity, nodal_temperature in and out. Indices: connectivity 8; host and row of a tied
// particle.
#include "bench/support/tied_cube.hpp"

namespace swarf::bench {
namespace {

void bench_spread_contact_heat(benchmark::State& state) {
  const TiedCube& c = tied_cube(state.range(0));
  HexMesh hexes = c.hexes;
  hexes.contact_heat = ScalarField("contact_heat", std::size_t(hexes.nodes));
  for (auto _ : state) spread_contact_heat(c.tie, c.particles, hexes, {}, c.materials);
  const double per_hex = 1 / c.hosts(), nodes = c.nodes() / c.hosts();
  report(state, c.hexes.points.count,
         {9 + 16 * per_hex + 2 * nodes,
          (2 + 10 * per_hex + 8 * nodes) * sizeof(Real) + (8 + 2 * per_hex) * sizeof(int)});
}
BENCHMARK(bench_spread_contact_heat)->Name("spread_contact_heat")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
