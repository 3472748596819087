// A cube of particles as the kernels meet it in a cut: disordered lattice, sheared, stressed, sorted, with
// its lists. h = 1.2 spacings, skin 0.1 of the support: 56 neighbours inside.
#pragma once
#include "bench/support/bench.hpp"
#include "bench/support/noise.hpp"
#include "swarf/particles/pair.hpp"
#include "tests/support/materials.hpp"
#include "tests/support/particle_block.hpp"
#include "tests/support/status.hpp"

namespace swarf::bench {

inline constexpr Real spacing = Real(2.5e-6);   // m
inline constexpr Real shear_rate = Real(1e5);   // 1/s
inline constexpr Real stress_level = Real(3e8); // Pa, elastic
inline constexpr Real time_step = Real(2e-10);  // s, about Courant 0.5 without mass scaling
inline constexpr Real warm_up = Real(300);      // K, over the cube

// What every pair sum does first (pair.hpp): x_ij 3, 1/h_ij 1, r^2 5, q 2, slope of the kernel 7, powers of
// 1/h 4.
inline constexpr double geometry_flops = 22;

struct ParticleCube : test::ParticleBlock {
  Status status;
  double pairs = 0;  // within the support, per particle
  double near = 0;   // within the cutoff, per particle: the list of a particle alone
  double listed = 0; // entries of the lists times lanes, per particle
  double marked = 0; // those of them that lanes compute, per particle
  double list_bytes = 0;

  double count() const { return particles.count; }
  // A pair sum: flops of a pair, flops of a particle, Reals of a particle that are read or written, Reals of
  // a neighbour; how often the pass walks the list; flops of each entry, marked or not.
  Cost pair_cost(double pair, double own, double reals, double of_neighbor, int walks = 1,
                 double entry = 0) const {
    const double own_list = walks * near * sizeof(int), own_bytes = reals * sizeof(Real) + own_list;
    const double read = (entry > 0 ? near : pairs) * of_neighbor * sizeof(Real);
    return {pairs * (entry + pair) + own,
            reals * sizeof(Real) + walks * list_bytes,
            listed * entry + marked * pair + own,
            near * entry + pairs * pair + own,
            own_bytes,
            own_bytes + read};
  }
};

inline void set_state(const ParticleCube& c) {
  const Particles p = c.particles;
  Kokkos::parallel_for(
      "bench_state", Range(0, p.count), KOKKOS_LAMBDA(int i) {
        const Noise noise{unsigned(i)};
        const Vector3 x = load_vector(p.position, i);
        const Real swing = Real(0.01) * shear_rate * spacing;
        store_vector(p.velocity, i,
                     Vector3{shear_rate * x.y + swing * noise(0), swing * noise(1), swing * noise(2)});
        store_symmetric(p.points.stress, i,
                        stress_level * Symmetric3{noise(3), noise(4), noise(5), Real(0.5) * noise(6),
                                                  Real(0.5) * noise(7), Real(0.5) * noise(8)});
        p.points.temperature(i) = Real(298.15) + warm_up * (Real(1) + noise(9));
        p.contact_gap(i) = Real(0.5) * spacing, p.contact_area(i) = spacing * spacing;
      });
}

inline void count_pairs(ParticleCube& c) {
  const Particles p = c.particles;
  const Neighbors n = c.neighbors;
  long pairs = 0, near = 0;
  Kokkos::parallel_reduce(
      "bench_pairs", Range(0, n.clusters),
      KOKKOS_LAMBDA(int cluster, long& inside, long& close) {
        for (int i = n.first(cluster); i < n.first(cluster) + n.size(cluster); ++i)
          for (long k = n.start(cluster); k < n.start(cluster + 1); ++k) {
            const int j = n.neighbor(k);
            const Vector3 x = load_vector(p.position, i) - load_vector(p.position, j);
            const Real reach = support_ratio * p.smoothing_length(i);
            if (i != j && dot(x, x) < reach * reach) ++inside;
            if (dot(x, x) < n.cutoff * n.cutoff) ++close;
          }
      },
      pairs, near);
  const double entries = double(
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, Kokkos::subview(n.start, n.clusters))());
  long marked = 0;
  Kokkos::parallel_reduce(
      "bench_marks", Range(0, n.clusters),
      KOKKOS_LAMBDA(int cluster, long& sum) { for_each_neighbor(n, cluster, [&](int) { ++sum; }); }, marked);
  c.marked = double(marked) * pack_width / c.count();
  c.pairs = double(pairs) / c.count(), c.near = double(near) / c.count();
  c.listed = entries * pack_width / c.count();
  c.list_bytes = entries * sizeof(int) / c.count();
}

inline ParticleCube make_particle_cube(int64_t size) {
  const int edge = cube_edge(size);
  ParticleCube c{test::particle_block(edge, edge, edge, spacing, Real(0.05)), test::make_status()};
  Particles& p = c.particles;
  Material mat = test::ti64();
  mat.conductivity = Real(7.2);
  Kokkos::deep_copy(c.materials, mat);
  Kokkos::deep_copy(p.points.density, mat.density);
  Kokkos::deep_copy(p.points.mass, mat.density * spacing * spacing * spacing);
  p.heat = ScalarField("heat", p.count), p.heat_state = View<Real* [2]>("heat_state", p.count);
  p.heat_shape = SymmetricField("heat_shape", p.count);
  p.hourglass_displacement = VectorField("hourglass_displacement", p.count);
  p.hourglass_rate = VectorField("hourglass_rate", p.count);
  p.pressure_state = View<Real* [4]>("pressure_state", p.count);
  c.method.viscosity_linear = Real(0.3), c.method.viscosity_quadratic = 1;
  test::build_lists(c);
  set_state(c);
  velocity_gradient(p, c.neighbors, c.method);
  prepare_pair_state(p, c.materials, c.method);
  count_pairs(c);
  return c;
}

inline const ParticleCube& particle_cube(int64_t size) { return cached(size, make_particle_cube); }

} // namespace swarf::bench
