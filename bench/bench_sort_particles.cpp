// No arithmetic: every field of the rows that move is gathered into a copy and copied back, so it is read
// twice and written twice. Cells of two sizes in turn, so that nearly all rows move; in a run few do.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_sort_particles(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  Particles particles = c.particles;
  double bytes = 0;
  for_each_field(particles, [&](const char*, const auto& field, auto facts) {
    if (facts.life == Life::history)
      bytes += double(field.size()) * sizeof(typename std::decay_t<decltype(field)>::value_type);
  });
  int cells = 16;
  for (auto _ : state) sort_particles(particles, {{0, 0, 0}, spacing * Real(cells) / 16}), cells = 27 - cells;
  report(state, c.count(), {0, 4 * bytes / c.count()});
}
BENCHMARK(bench_sort_particles)->Name("sort_particles")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
