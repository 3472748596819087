// A quarter of all particles follow hosts of their own: of such a pair the momentum 18, its change 30, for
// two. Reals, for two: velocity 3 in and out, force 3, mass, external_work in and out. And the constraint
// bits.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_hold_faces(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const Particles& p = c.particles;
  const Motion motion{p.count,       p.position,      p.velocity,    p.force,
                      p.points.mass, p.external_work, p.constraints, p.points.equivalent_plastic_strain};
  const ConstraintTable table("constraints", 1);
  const int groups = p.count / 4;
  const HeldRows rows{groups,
                      IndexField("host", groups),
                      IndexField("start", groups + 1),
                      IndexField("held", groups),
                      IndexField("face", groups),
                      IndexField("row", p.count)};
  Kokkos::parallel_for(
      "bench_rows", Range(0, p.count), KOKKOS_LAMBDA(int i) {
        rows.row(i) = i;
        if (i <= groups) rows.start(i) = i;
        if (i < groups) rows.host(i) = 4 * i, rows.held(i) = 4 * i + 1;
      });
  for (auto _ : state) hold_faces(rows, motion, table, {Real(1), Real(0)});
  report(state, groups, {78, 24.0 * sizeof(Real) + 2 * sizeof(unsigned) + 6 * sizeof(int)});
}
BENCHMARK(bench_hold_faces)->Name("hold_faces")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
