// The machine's ceilings in the precision of the build: fused multiply-adds from registers, and the triad
// a = b + s c of STREAM (McCalpin 1995) on arrays far larger than the caches. All threads at once.
#include "bench/support/bench.hpp"

namespace swarf::bench {
namespace {

constexpr int chains = 16; // enough independent sums to hide the latency of two units
constexpr int links = 4096;

void peak_fma(benchmark::State& state) {
  const int threads = Kokkos::num_threads(), rows = 64 * threads;
  const ScalarField out("out", rows);
  for (auto _ : state) {
    Kokkos::parallel_for(
        "peak_fma", Range(0, rows), KOKKOS_LAMBDA(int row) {
          Pack sum[chains];
          const Pack factor(Real(0.999)), term(Real(1e-3) * Real(row + 1));
          for (int c = 0; c < chains; ++c) sum[c] = Pack(Real(c));
          for (int k = 0; k < links; ++k)
            for (int c = 0; c < chains; ++c) sum[c] = sum[c] * factor + term;
          Pack total = sum[0];
          for (int c = 1; c < chains; ++c) total = total + sum[c];
          out(row) = lane_of(total, 0);
        });
  }
  report(state, double(rows) * links, {2.0 * chains * pack_width, 0});
}
BENCHMARK(peak_fma)->UseRealTime();

void triad(benchmark::State& state) {
  const int rows = int(state.range(0));
  const ScalarField a("a", rows), b("b", rows), c("c", rows);
  Kokkos::deep_copy(b, Real(1)), Kokkos::deep_copy(c, Real(2));
  const Real s = 3;
  for (auto _ : state)
    Kokkos::parallel_for(
        "triad", Range(0, rows), KOKKOS_LAMBDA(int i) { a(i) = b(i) + s * c(i); });
  report(state, rows, {2, 3 * sizeof(Real)});
}
BENCHMARK(triad)->Arg(1 << 24)->UseRealTime();

} // namespace
} // namespace swarf::bench
