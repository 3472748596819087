// A particle on one face: capacity and resistances 6, the flow 5, the temperature 2: 13. Reals: temperature
// in and out, mass, gap, area, face_heat in and out; bits and material: two indices. Of the cube the
// particles of one side are on a face; the others are read for their bits only.
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {
namespace {

void bench_heat_faces(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  Particles p = c.particles;
  p.heated_faces = View<unsigned*>("heated_faces", std::size_t(p.count));
  p.face_heat = ScalarField("face_heat", std::size_t(p.count));
  const HeatedFaces faces("heated_faces", 1);
  Kokkos::deep_copy(faces, HeatedFace{Real(1e-6), Real(298.15)});
  const int every = int(std::cbrt(c.count()));
  Kokkos::parallel_for(
      "bench_bits", Range(0, p.count), KOKKOS_LAMBDA(int i) { p.heated_faces(i) = i % every == 0; });
  const Real dt = Real(1e-18); // the temperatures of the cube stay
  for (auto _ : state) heat_faces(p, faces, c.materials, dt);
  const double on_face = 1.0 / every;
  report(state, c.count(), {13 * on_face, (4 + 3 * on_face) * sizeof(Real) + 2 * sizeof(int)});
}
BENCHMARK(bench_heat_faces)->Name("heat_faces")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
