#include "support/particle_block.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

// A block stretched by 1 % along each axis: density falls by 1.01^3, at free surfaces too.
TEST(SumDensity, FollowsAUniformStretch) {
  ParticleBlock b = particle_block(8, 8, 8, Real(1e-3));
  b.particles.reference_summation = ScalarField("reference", b.particles.count);
  build_lists(b);
  prepare_pair_state(b.particles, b.materials, b.method);
  sum_density(b.particles, b.neighbors, b.materials);
  const auto x = host_copy(b.particles.position);
  for (int i = 0; i < b.particles.count; ++i)
    for (int c = 0; c < 3; ++c) x(i, c) *= Real(1.01);
  Kokkos::deep_copy(b.particles.position, x);
  sum_density(b.particles, b.neighbors, b.materials);
  const auto density = host_copy(b.particles.points.density);
  // Away from the surface the summed kernel follows the volume to the lattice's own error.
  const auto place = host_copy(b.particles.position);
  for (int i = 0; i < b.particles.count; ++i) {
    bool inside = true;
    for (int c = 0; c < 3; ++c) inside = inside && place(i, c) > 2.9e-3 && place(i, c) < 5.2e-3;
    if (inside) {
      EXPECT_NEAR(density(i) / 7800, 1 / std::pow(1.01, 3), 2e-3);
    }
  }
}

TEST(SumDensity, OfTheInitialLatticeIsTheMaterials) {
  ParticleBlock b = particle_block(5, 4, 6, Real(2e-6));
  b.particles.reference_summation = ScalarField("reference", b.particles.count);
  build_lists(b);
  prepare_pair_state(b.particles, b.materials, b.method);
  sum_density(b.particles, b.neighbors, b.materials);
  const auto density = host_copy(b.particles.points.density);
  for (int i = 0; i < b.particles.count; ++i) EXPECT_EQ(density(i), Real(7800));
}

} // namespace
} // namespace swarf::test
