// Elastic point: midpoint gradient, rotation and dilution 200, trial stress 125, von Mises 19, energy and the
// rest 30: 374. A plastic one: softening 8 and about four Newton iterations of 22, return and heat 44:
// another 140. Reals: stress 6, density, plastic strain and its rate, temperature, damage, two works in and
// out; velocity_gradient 9, mass in.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

// Percent of the points flow, in every call anew; the others turn and strain elastically.
void set_plastic(const MaterialPoints& p, int percent) {
  Kokkos::parallel_for(
      "bench_plastic", Range(0, p.count), KOKKOS_LAMBDA(int i) {
        const Noise noise{unsigned(i)};
        const bool flows = Real(50) * (Real(1) + noise(12)) < Real(percent);
        const Real rate = flows ? Real(1e5) : Real(1e2);
        store_tensor(p.velocity_gradient, i,
                     Tensor3{rate * noise(13), rate, rate * noise(14), Real(0), Real(0), rate, rate, Real(0),
                             Real(-1) * rate * noise(13)});
        p.equivalent_plastic_strain(i) = flows ? Real(0.3) : Real(0);
        if (flows) store_symmetric(p.stress, i, Symmetric3{0, 0, 0, Real(4e8), Real(4e8), Real(4e8)});
      });
}

void bench_update_stress(benchmark::State& state, int percent) {
  const ParticleCube& c = particle_cube(state.range(0));
  set_state(c); // the kernel changes it
  Kokkos::deep_copy(c.particles.points.density, test::ti64().density);
  set_plastic(c.particles.points, percent);
  for (auto _ : state) update_stress(c.particles.points, c.materials, time_step, c.status);
  if (test::read_status(c.status) != no_fault) state.SkipWithError("update_stress reports a fault");
  report(state, c.count(), {374 + 1.4 * percent, 36.0 * sizeof(Real) + sizeof(int)});
}
BENCHMARK_CAPTURE(bench_update_stress, elastic, 0)->Name("update_stress")->Apply(all_sizes);
BENCHMARK_CAPTURE(bench_update_stress, plastic, 20)->Name("update_stress, 20 % plastic")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
