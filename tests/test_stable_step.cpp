// Courant's condition on lattices whose step is known.
#include "support/hex_block.hpp"
#include "support/materials.hpp"
#include "support/particle_block.hpp"
#include <gtest/gtest.h>

namespace swarf::test {

const double wave_speed = std::sqrt((1e11 + 4.0 / 3 * 8e10) / 7800); // of elastic_steel

// h sqrt(mass factor) / c of the finest particle, and how far the farthest one has moved.
TEST(StableStep, OfTheFinestParticle) {
  ParticleBlock b = particle_block(6, 5, 4, Real(1e-3));
  build_lists(b);
  const auto h = host_copy(b.particles.smoothing_length);
  h(17) = Real(0.7e-3);
  Kokkos::deep_copy(b.particles.smoothing_length, h);
  const auto x = host_copy(b.particles.position);
  x(5, 1) += Real(3e-5), x(5, 2) -= Real(4e-5), x(9, 0) += Real(2e-5);
  Kokkos::deep_copy(b.particles.position, x);
  const StableStep step = stable_step(b.particles, b.neighbors, b.materials, 100);
  EXPECT_NEAR(double(step.dt) / (0.7e-3 * 10 / wave_speed), 1, round_off);
  EXPECT_EQ(step.limiter, 17);
  EXPECT_NEAR(double(step.max_displacement) / 5e-5, 1, 1e3 * round_off);
}

// Waves run the faster through the initial lattice the more it is sheared: for a shear of 5, with J = 1, at
// most 1 / (least stretch) times, a stretch whose square is (27 - sqrt(725)) / 2; at least half of that is
// asked.
TEST(StableStep, OfAShearedInitialLattice) {
  ParticleBlock b = particle_block(3, 3, 3, Real(1e-3));
  build_lists(b);
  const Real at_rest = stable_step(b.particles, b.neighbors, b.materials, 1).dt;
  b.particles.deformation_gradient = TensorField("deformation_gradient", b.particles.count);
  const auto F = host_copy(b.particles.deformation_gradient);
  const auto fill = [&](const Tensor3& to) {
    for (int i = 0; i < b.particles.count; ++i) store_tensor(F, i, to);
    Kokkos::deep_copy(b.particles.deformation_gradient, F);
    return double(stable_step(b.particles, b.neighbors, b.materials, 1).dt / at_rest);
  };
  EXPECT_NEAR(fill(identity3()), 1, round_off);
  EXPECT_NEAR(fill({0, -1, 0, 1, 0, 0, 0, 0, 1}), 1, round_off); // turned
  EXPECT_NEAR(fill({0.25, 0, 0, 0, 1, 0, 0, 0, 1}), 0.5, round_off);
  const double least = std::sqrt((27 - std::sqrt(725)) / 2), sheared = fill({1, 5, 0, 0, 1, 0, 0, 0, 1});
  EXPECT_LE(sheared, least * (1 + round_off));
  EXPECT_GE(sheared, least / 2);
}

// A brick's thickness / c; a deleted hex does not count.
TEST(StableStep, OfTheThinnestHex) {
  const Material mat = elastic_steel();
  const double planes[4] = {0, 2e-3, 2.5e-3, 4.5e-3};
  HexMesh m = make_hex_block({3, 1, 1}, mat, [&](int i, int j, int k) {
    return Point{planes[i], 3e-3 * j, 4e-3 * k};
  });
  Status status("status");
  hex_velocity_gradient(m, status);
  const MaterialTable table = make_material_table({mat});
  const StableStep thin = stable_step(m, table, 4);
  EXPECT_NEAR(double(thin.dt) / (0.5e-3 * 2 / wave_speed), 1, 1e2 * round_off);
  EXPECT_EQ(thin.limiter, 1);
  const auto active = host_copy(m.active);
  active(1) = 0;
  Kokkos::deep_copy(m.active, active);
  EXPECT_NEAR(double(stable_step(m, table, 4).dt) / (2e-3 * 2 / wave_speed), 1, 1e2 * round_off);
}

TEST(StableStep, OfNothingLimitsNothing) {
  EXPECT_EQ(stable_step(HexMesh{}, MaterialTable(), 1).limiter, -1);
}

} // namespace swarf::test
