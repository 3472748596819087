// Items are points that have touched, about one to a patch: far more than touch a tool. Five sums. Reals:
// sums of the point in twice, out once; of the patch in and out. Indices: patch twice, first, source.
#include "bench/support/hot_tool.hpp"

namespace swarf::bench {
namespace {

struct RubbedTool {
  ToolSurface surface;
  ContactPoints points;
};

RubbedTool make_rubbed_tool(int64_t size) {
  const int count = int(size);
  RubbedTool t{{}, test::make_contact_points(count, 1)};
  t.surface.patches = count;
  t.surface.sums = View<Real* [surface_sums]>("sums", size);
  t.surface.first = IndexField("first", size + 1), t.surface.source = IndexField("source", size);
  t.points.on_tool = View<Real* [surface_sums]>("on_tool", size);
  t.points.tool_patch = IndexField("tool_patch", size);
  return t;
}

void rub(const RubbedTool& t) {
  const ContactPoints p = t.points;
  Kokkos::parallel_for(
      "bench_rub", Range(0, p.count), KOKKOS_LAMBDA(int i) {
        for (int q = 0; q < surface_sums; ++q) p.on_tool(i, q) = 1;
        p.tool_patch(i) = int(i * 7919L % p.count);
      });
}

void bench_gather_tool_surface(benchmark::State& state) {
  const RubbedTool& t = cached(state.range(0), make_rubbed_tool);
  for (auto _ : state) {
    state.PauseTiming();
    rub(t);
    Kokkos::fence(); // the clock must not count what makes the sums
    state.ResumeTiming();
    gather_tool_surface(t.points, t.surface);
  }
  report(state, t.points.count, {surface_sums, 25.0 * sizeof(Real) + 6 * sizeof(int)});
}
BENCHMARK(bench_gather_tool_surface)->Name("gather_tool_surface")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
