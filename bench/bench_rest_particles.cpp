// All awake, one cell of action. No field moves, but each is gathered into a copy and copied back, as when
// sorting; distance 14 and damping 4.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_rest_particles(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  Particles particles = c.particles;
  double bytes = 0;
  const auto count = [&](const char*, auto& field) {
    bytes += double(field.size()) * sizeof(typename std::decay_t<decltype(field)>::value_type);
  };
  particles.for_each_field(count), particles.for_each_pair_field(count);
  const VectorField action("action", 1);
  Sleep sleep;
  sleep.distance = 10 * Real(cube_edge(state.range(0))) * spacing, sleep.ramp = Real(0.5) * sleep.distance;
  for (auto _ : state) rest_particles(particles, Tie{}, action, sleep);
  report(state, c.count(), {18, 4 * bytes / c.count()});
}
BENCHMARK(bench_rest_particles)->Name("rest_particles")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
