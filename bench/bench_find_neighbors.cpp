// Counted: the distance of every pair that ends in a list, 8, in each of the two passes; candidates that do
// not are overhead. Reals: position 3 in, build_position 3 out; the list out. Of a
// neighbour its position, twice.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_find_neighbors(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  Neighbors lists;
  lists.cutoff = c.neighbors.cutoff, lists.skin = c.neighbors.skin;
  for (auto _ : state) find_neighbors(lists, c.particles);
  report(state, c.count(), c.pair_cost(0, 0, 6, 6, 1, 16));
  state.counters["pairs_per_item"] = c.pairs;
  state.counters["near_pairs_per_item"] = c.near;
  state.counters["listed_pairs_per_item"] = c.listed;
  state.counters["lane_pairs_per_item"] = c.marked;
}
BENCHMARK(bench_find_neighbors)->Name("find_neighbors")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
