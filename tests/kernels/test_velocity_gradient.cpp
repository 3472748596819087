#include "support/particle_block.hpp"
#include "swarf/particles/pair.hpp"
#include <gtest/gtest.h>
#include <random>

namespace swarf::test {
namespace {

constexpr Real round_off = Kokkos::Experimental::epsilon_v<Real> * Real(1e3);

// v = L0 x on a disordered set with free surfaces: the corrected gradient is exact (Randles & Libersky 1996).
void set_linear_velocity(const Particles& p, const Tensor3& L0) {
  Kokkos::parallel_for(
      "set", Range(0, p.count),
      KOKKOS_LAMBDA(int i) { store_vector(p.velocity, i, multiply(L0, load_vector(p.position, i))); });
}

Real largest_error(const Particles& p, const Tensor3& L0) {
  Real worst = 0;
  const auto L = p.points.velocity_gradient;
  Kokkos::parallel_reduce(
      "error", Range(0, p.count),
      KOKKOS_LAMBDA(int i, Real& w) {
        const Real* reference = &L0.xx;
        for (int c = 0; c < 9; ++c) w = Kokkos::max(w, Kokkos::abs(L(i, c) - reference[c]));
      },
      Kokkos::Max<Real>(worst));
  return worst;
}

TEST(VelocityGradient, IsExactForALinearFieldOnADisorderedSet) {
  const Tensor3 L0{1, 2, -3, 0.5, -1, 4, 2, 0.25, 3};
  for (const double disorder : {0.1, 0.2}) {
    ParticleBlock b = particle_block(9, 8, 7, Real(2.5e-6), Real(disorder));
    build_lists(b);
    set_linear_velocity(b.particles, L0);
    velocity_gradient(b.particles, b.neighbors, b.method);
    EXPECT_LT(largest_error(b.particles, L0), round_off);
  }
}

// The stress passes from particles to hexes along a ramp of volumes that fall to nothing: those few parts in
// a thousand of a cell are neighbours like any other.
TEST(VelocityGradient, IsExactHoweverSmallTheVolumesOfTiedParticlesAre) {
  const Tensor3 L0{1, 2, -3, 0.5, -1, 4, 2, 0.25, 3};
  ParticleBlock b = particle_block(9, 8, 7, Real(2.5e-6), Real(0.1));
  const auto volume = host_copy(b.particles.volume);
  for (int i = 0; i < b.particles.count; ++i) volume(i) *= Real(2e-3);
  Kokkos::deep_copy(b.particles.volume, volume);
  std::swap(b.particles.count, b.particles.tied);
  build_lists(b);
  std::swap(b.particles.count, b.particles.tied); // all are set and looked at
  set_linear_velocity(b.particles, L0);
  std::swap(b.particles.count, b.particles.tied);
  velocity_gradient(b.particles, b.neighbors, b.method);
  std::swap(b.particles.count, b.particles.tied);
  EXPECT_LT(largest_error(b.particles, L0), round_off);
}

// Neighbours that hardly leave a plane: bounded, not exact.
TEST(VelocityGradient, OfASheetIsBounded) {
  const Tensor3 L0{1, 2, -3, 0.5, -1, 4, 2, 0.25, 3};
  ParticleBlock b = particle_block(9, 8, 1, Real(2.5e-6), Real(0.02));
  build_lists(b);
  set_linear_velocity(b.particles, L0);
  velocity_gradient(b.particles, b.neighbors, b.method);
  EXPECT_LT(largest_error(b.particles, L0), 10); // of components up to 4 1/s
}

TEST(VelocityGradient, WithoutCorrectionIsWrongAtAFreeSurface) {
  const Tensor3 L0{1, 0, 0, 0, 0, 0, 0, 0, 0};
  ParticleBlock b = particle_block(9, 8, 7, Real(2.5e-6));
  b.method.correction = false;
  build_lists(b);
  set_linear_velocity(b.particles, L0);
  velocity_gradient(b.particles, b.neighbors, b.method);
  EXPECT_GT(largest_error(b.particles, L0), 0.2);
}

TEST(VelocityGradient, OfALoneParticleIsZeroAndFinite) {
  ParticleBlock b = particle_block(1, 1, 1, Real(1));
  build_lists(b);
  set_linear_velocity(b.particles, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  velocity_gradient(b.particles, b.neighbors, b.method);
  EXPECT_EQ(largest_error(b.particles, {0, 0, 0, 0, 0, 0, 0, 0, 0}), 0);
}

struct Visits {
  long rows = 0, pairs = 0, vain = 0; // rows of lists; pairs within the support; rows far from all lanes
};

Visits count_visits(const ParticleBlock& b) {
  const Particles p = b.particles;
  const Neighbors n = b.neighbors;
  Visits found;
  Kokkos::parallel_reduce(
      "count_visits", Range(0, n.clusters),
      KOKKOS_LAMBDA(int c, long& rows, long& pairs, long& vain) {
        for_each_neighbor(n, c, [&](int j) {
          Real least = support_ratio + 1; // r / h
          for (int i = n.first(c); i < n.first(c) + n.size(c); ++i) {
            const Vector3 d = load_vector(p.position, i) - load_vector(p.position, j);
            const Real q = norm(d) * (p.inverse_support(i) + p.inverse_support(j));
            least = Kokkos::min(least, q), pairs += q < support_ratio;
          }
          ++rows, vain += least > Real(1.005) * support_ratio;
        });
      },
      found.rows, found.pairs, found.vain);
  return found;
}

// Lists hold what is within the skin, too: once looked at, it is left out, and nothing else; each time anew.
TEST(VelocityGradient, MarksTheRowsThatAnyLaneHasWithinItsSupport) {
  ParticleBlock b = particle_block(12, 11, 10, Real(2.5e-6), Real(0.2));
  build_lists(b);
  const auto unmarked = Kokkos::create_mirror(b.neighbors.marks);
  Kokkos::deep_copy(unmarked, b.neighbors.marks);
  const auto x = host_copy(b.particles.position);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> u(-1, 1);
  for (const Real step : {Real(0), Real(0.2), Real(0.2)}) {
    for (int i = 0; i < b.particles.count; ++i)
      for (int c = 0; c < 3; ++c) x(i, c) += step * b.neighbors.skin * u(random);
    Kokkos::deep_copy(b.particles.position, x);
    velocity_gradient(b.particles, b.neighbors, b.method);
    const Visits marked = count_visits(b);
    const auto marks = Kokkos::create_mirror(b.neighbors.marks); // what the next gradient begins with
    Kokkos::deep_copy(marks, b.neighbors.marks), Kokkos::deep_copy(b.neighbors.marks, unmarked);
    const Visits all = count_visits(b);
    Kokkos::deep_copy(b.neighbors.marks, marks);
    EXPECT_GT(all.vain, all.rows / 20);
    EXPECT_EQ(marked.vain, 0);
    EXPECT_EQ(marked.pairs, all.pairs);
    EXPECT_LT(marked.rows, all.rows - all.vain / 2);
  }
}

} // namespace
} // namespace swarf::test
