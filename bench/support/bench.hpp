// What every benchmark shares: sizes, and what one item costs.
#pragma once
#include "swarf/core/pack.hpp"
#include <benchmark/benchmark.h>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace swarf::bench {

// Particles or hexes: 10 k, 100 k, 1 M, or those of SWARF_BENCH_SIZES ("10000 100000").
inline std::vector<int64_t> sizes() {
  const char* asked = std::getenv("SWARF_BENCH_SIZES");
  std::istringstream words(asked ? asked : "10000 100000 1000000");
  std::vector<int64_t> found;
  for (int64_t n; words >> n;) found.push_back(n);
  return found;
}
inline void all_sizes(benchmark::internal::Benchmark* b) {
  for (const int64_t n : sizes()) b->Arg(n);
  b->UseRealTime()->Unit(benchmark::kMillisecond);
}

// Edge of the cube that holds about n cells.
inline int cube_edge(int64_t n) { return std::max(2, int(std::lround(std::cbrt(double(n))))); }

// Operations and memory traffic of one item, counted from the equations: an addition, multiplication,
// division, root or elementary function is 1; a comparison or selection is 0. Bytes: every field that the
// kernel reads or writes, once (compulsory traffic; no write-allocate, as STREAM counts).
struct Cost {
  double flops = 0; // of pairs within the support only
  double bytes = 0;
  double lane_flops = 0; // also of those that fill lanes and are cut off by the support; 0: the same
  // On a GPU, where each particle has its own list: all pairs of the list, and the list. `gathered` counts
  // the fields of a neighbour for each pair that reads them, as if no cache held any. 0: as flops and bytes.
  double gpu_flops = 0, gpu_bytes = 0, gathered_bytes = 0;
};

inline void report(benchmark::State& state, double items, const Cost& cost) {
  using benchmark::Counter;
  state.SetItemsProcessed(int64_t(double(state.iterations()) * items));
  state.counters["items"] = items;
  state.counters["flops_per_item"] = cost.flops;
  state.counters["bytes_per_item"] = cost.bytes;
  state.counters["lane_flops_per_item"] = cost.lane_flops > 0 ? cost.lane_flops : cost.flops;
  state.counters["gpu_flops_per_item"] = cost.gpu_flops > 0 ? cost.gpu_flops : cost.flops;
  state.counters["gpu_bytes_per_item"] = cost.gpu_bytes > 0 ? cost.gpu_bytes : cost.bytes;
  state.counters["gathered_bytes_per_item"] = cost.gathered_bytes > 0 ? cost.gathered_bytes : cost.bytes;
  state.counters["FLOP/s"] = Counter(items * cost.flops, Counter::kIsIterationInvariantRate);
  state.counters["B/s"] = Counter(items * cost.bytes, Counter::kIsIterationInvariantRate);
}

// The state of the size asked for last; made anew for another, let go before Kokkos ends.
template <class Made>
const Made& cached(int64_t size, Made (*make)(int64_t)) {
  static std::unique_ptr<Made> held;
  static int64_t size_held = -1;
  if (size_held == -1) Kokkos::push_finalize_hook([] { held.reset(); });
  if (size_held != size) {
    held.reset();
    held = std::make_unique<Made>(make(size));
    size_held = size;
  }
  return *held;
}

} // namespace swarf::bench
