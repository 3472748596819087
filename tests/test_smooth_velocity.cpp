#include "support/particle_block.hpp"
#include <gtest/gtest.h>

namespace swarf::test {

constexpr Real round_off = Kokkos::Experimental::epsilon_v<Real>;

// One face that holds in z whom bit 0 names.
ConstraintTable hold_in_z() {
  ConstraintTable table("constraints", 1);
  const auto host = Kokkos::create_mirror_view(table);
  host(0) = Constraint{.all = false, .normal = {0, 0, 1}, .velocity = {0, 0, 5}};
  Kokkos::deep_copy(table, host);
  return table;
}

ParticleBlock moving_block(Real disorder, Real noise) {
  ParticleBlock b = particle_block(9, 8, 7, Real(1e-3), disorder);
  Particles& p = b.particles;
  p.drift_velocity = VectorField("drift_velocity", p.count);
  const auto v = host_copy(p.velocity);
  const auto rho_Z = host_copy(p.impedance);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<Real> u(-1, 1);
  for (int i = 0; i < p.count; ++i) {
    v(i, 0) = 3, v(i, 1) = -2, v(i, 2) = 1;
    for (int c = 0; c < 3; ++c) v(i, c) += noise * u(random);
    rho_Z(i, 1) = Real(7800);
  }
  Kokkos::deep_copy(p.velocity, v), Kokkos::deep_copy(p.impedance, rho_Z);
  build_lists(b);
  return b;
}

TEST(SmoothVelocity, LeavesATranslationAlone) {
  ParticleBlock b = moving_block(Real(0.2), 0);
  smooth_velocity(b.particles, b.neighbors, hold_in_z(), Real(0.5));
  const auto v = host_copy(b.particles.velocity), drift = host_copy(b.particles.drift_velocity);
  for (int i = 0; i < b.particles.count; ++i)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drift(i, c), v(i, c), 10 * round_off);
}

// Monaghan (1989): the sum of m v stays, differences between neighbours shrink.
TEST(SmoothVelocity, KeepsTheMomentumAndCalmsNoise) {
  ParticleBlock b = moving_block(Real(0.2), 1);
  const auto volume = host_copy(b.particles.volume), mass = host_copy(b.particles.points.mass);
  const auto rho_Z = host_copy(b.particles.impedance);
  for (int i = 0; i < b.particles.count; ++i) // two materials
    if (i % 3 == 0) rho_Z(i, 1) *= 2, mass(i) *= 2;
  Kokkos::deep_copy(b.particles.impedance, rho_Z), Kokkos::deep_copy(b.particles.points.mass, mass);
  smooth_velocity(b.particles, b.neighbors, hold_in_z(), Real(0.5));
  const auto v = host_copy(b.particles.velocity), drift = host_copy(b.particles.drift_velocity);
  Vector3 change{0, 0, 0};
  Real momentum = 0, noise = 0, calmed = 0;
  for (int i = 0; i < b.particles.count; ++i) {
    const Vector3 before = load_vector(v, i), after = load_vector(drift, i), mean{3, -2, 1};
    change = change + mass(i) * (after - before), momentum += mass(i) * norm(before);
    noise += dot(before - mean, before - mean), calmed += dot(after - mean, after - mean);
  }
  EXPECT_LT(norm(change), 100 * round_off * momentum);
  EXPECT_LT(calmed, Real(0.6) * noise);
}

TEST(SmoothVelocity, LeavesHeldParticlesToTheirFace) {
  ParticleBlock b = moving_block(0, 1);
  Kokkos::deep_copy(b.particles.constraints, 1u);
  smooth_velocity(b.particles, b.neighbors, hold_in_z(), Real(0.5));
  const auto drift = host_copy(b.particles.drift_velocity);
  for (int i = 0; i < b.particles.count; ++i) EXPECT_EQ(drift(i, 2), 5);
}

} // namespace swarf::test
