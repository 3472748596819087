#include "support/particle_block.hpp"
#include "swarf/smoothing_kernel.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace swarf::test {

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

// |K_i|^2, summed pair by pair on the host: what velocity_gradient bounds.
std::vector<Real> correction_norms(const Particles& p) {
  const auto x = host_copy(p.position);
  const auto V = host_copy(p.volume), h = host_copy(p.smoothing_length);
  std::vector<Real> norms;
  for (int i = 0; i < p.count; ++i) {
    Tensor3 A{};
    for (int j = 0; j < p.count; ++j) {
      const Vector3 r = load_vector(x, i) - load_vector(x, j);
      const Real h2 = h(i) * h(i), w = -V(j) * kernel_slope<Real>(norm(r) / h(i)) / (h2 * h2 * h(i));
      const Vector3 g = w * r;
      A = A + Tensor3{r.x * g.x, r.x * g.y, r.x * g.z, r.y * g.x, r.y * g.y,
                      r.y * g.z, r.z * g.x, r.z * g.y, r.z * g.z};
    }
    const Tensor3 K = inverse(A, determinant(A));
    const Real* k = &K.xx;
    Real norm2 = 0;
    for (int c = 0; c < 9; ++c) norm2 += k[c] * k[c];
    norms.push_back(norm2);
  }
  return norms;
}

// Disorder of 0.1 spacings keeps |K|^2 of every particle, corners of the block included, under the bound of
// 100 from which the kernel gives up exactness.
TEST(VelocityGradient, IsExactForALinearFieldOnADisorderedSet) {
  const Tensor3 L0{1, 2, -3, 0.5, -1, 4, 2, 0.25, 3};
  ParticleBlock b = particle_block(9, 8, 7, Real(2.5e-6), Real(0.1));
  build_lists(b);
  const std::vector<Real> norms = correction_norms(b.particles);
  ASSERT_LT(*std::max_element(norms.begin(), norms.end()), 100);
  set_linear_velocity(b.particles, L0);
  velocity_gradient(b.particles, b.neighbors, b.method);
  EXPECT_LT(largest_error(b.particles, L0), round_off);
}

// The documented limit of the method: where |K|^2 exceeds 100 the gradient is bounded, not exact. Everywhere
// else it stays exact. A disorder of 0.2 spacings takes one corner of this block there (|K|^2 = 116).
TEST(VelocityGradient, IsExactWhereTheNeighboursSpanSpace) {
  const Tensor3 L0{1, 2, -3, 0.5, -1, 4, 2, 0.25, 3};
  ParticleBlock b = particle_block(9, 8, 7, Real(2.5e-6), Real(0.2));
  build_lists(b);
  set_linear_velocity(b.particles, L0);
  velocity_gradient(b.particles, b.neighbors, b.method);
  const std::vector<Real> norms = correction_norms(b.particles);
  const auto x = host_copy(b.particles.position);
  const auto L = host_copy(b.particles.points.velocity_gradient);
  const int cells[3] = {9, 8, 7};
  int bounded = 0;
  for (int i = 0; i < b.particles.count; ++i) {
    Real error = 0;
    int faces = 0; // of the block that the particle's cell touches
    for (int c = 0; c < 9; ++c) error = std::max(error, std::abs(L(i, c) - (&L0.xx)[c]));
    for (int d = 0; d < 3; ++d) {
      const int cell = int(std::floor(x(i, d) / Real(2.5e-6)));
      faces += cell <= 0 || cell >= cells[d] - 1;
    }
    if (norms[std::size_t(i)] < 100) {
      EXPECT_LT(error, round_off);
    } else {
      ++bounded;
      EXPECT_EQ(faces, 3) << "|K|^2 = " << norms[std::size_t(i)];
      EXPECT_LT(error, 1); // of components up to 4 1/s; measured 0.48
    }
  }
  EXPECT_EQ(bounded, 1);
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

} // namespace swarf::test
