#include "support/particle_block.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

constexpr Real round_off = Kokkos::Experimental::epsilon_v<Real>;

// A disordered block with random stress, velocity and temperature-free material: the worst case for the sums.
ParticleBlock stressed_block(Real disorder = Real(0.2)) {
  ParticleBlock b = particle_block(9, 8, 7, Real(1e-3), disorder);
  b.method.viscosity_linear = 1, b.method.viscosity_quadratic = 2;
  const auto s = host_copy(b.particles.points.stress);
  const auto v = host_copy(b.particles.velocity);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<Real> u(-1, 1);
  for (int i = 0; i < b.particles.count; ++i) {
    for (int c = 0; c < 6; ++c) s(i, c) = Real(1e9) * u(random);
    for (int c = 0; c < 3; ++c) v(i, c) = 10 * u(random);
  }
  Kokkos::deep_copy(b.particles.points.stress, s);
  Kokkos::deep_copy(b.particles.velocity, v);
  build_lists(b);
  return b;
}

void compute_forces(ParticleBlock& b) {
  velocity_gradient(b.particles, b.neighbors, b.method);
  prepare_pair_state(b.particles, b.materials, b.method);
  particle_forces(b.particles, b.neighbors, b.method, Real(1));
}

struct Balance {
  Vector3 force{0, 0, 0}, torque{0, 0, 0};
  Real magnitude = 0, arm_magnitude = 0, force_power = 0, stress_power = 0, viscous_power = 0;
};

Balance balance_of(const ParticleBlock& b) {
  const Particles& p = b.particles;
  const auto x = host_copy(p.position), v = host_copy(p.velocity), f = host_copy(p.force);
  const auto s = host_copy(p.points.stress);
  const auto L = host_copy(p.points.velocity_gradient);
  const auto V = host_copy(p.volume), viscous = host_copy(p.viscous_work);
  Balance sum;
  for (int i = 0; i < p.count; ++i) {
    const Vector3 f_i = load_vector(f, i), x_i = load_vector(x, i);
    sum.force = sum.force + f_i;
    sum.torque = sum.torque + cross(x_i, f_i);
    sum.magnitude += norm(f_i), sum.arm_magnitude += norm(x_i) * norm(f_i);
    sum.force_power += dot(f_i, load_vector(v, i));
    sum.stress_power += V(i) * contract(load_symmetric(s, i), symmetric_part(load_tensor(L, i)));
    sum.viscous_power += viscous(i);
  }
  return sum;
}

TEST(ParticleForces, ConserveLinearMomentumToRoundOff) {
  ParticleBlock b = stressed_block();
  compute_forces(b);
  const Balance sum = balance_of(b);
  EXPECT_LT(norm(sum.force), 100 * round_off * sum.magnitude);
}

// Between the velocity gradient, which marks who is within the support, and the forces the support grows or
// shrinks with the volume: by 1 % of it here. (In float the round-off hides pairs that one side misses.)
TEST(ParticleForces, ConserveLinearMomentumWhileSmoothingLengthsEvolve) {
  ParticleBlock b = stressed_block();
  velocity_gradient(b.particles, b.neighbors, b.method);
  const auto density = host_copy(b.particles.points.density);
  for (int i = 0; i < b.particles.count; ++i) density(i) *= i % 2 ? Real(0.99) : Real(1.01);
  Kokkos::deep_copy(b.particles.points.density, density);
  evolve_smoothing_length(b.particles);
  prepare_pair_state(b.particles, b.materials, b.method);
  particle_forces(b.particles, b.neighbors, b.method, Real(1));
  const Balance sum = balance_of(b);
  EXPECT_LT(norm(sum.force), 100 * round_off * sum.magnitude);
}

// The corrected form is the adjoint of the velocity gradient, so that a rigid rotation does no work: no
// torque. That needs a gradient that is exact for rotations: with a disorder of 0.2 the bound of the
// correction (test_velocity_gradient) acts on corners of the block, with 0.1 nowhere.
TEST(ParticleForces, ConserveAngularMomentumToRoundOff) {
  ParticleBlock b = stressed_block(Real(0.1));
  b.method.viscosity_linear = b.method.viscosity_quadratic = 0;
  compute_forces(b);
  const Balance sum = balance_of(b);
  EXPECT_LT(norm(sum.torque), 100 * round_off * sum.arm_magnitude);
}

TEST(ParticleForces, DoTheWorkOfTheStresses) {
  ParticleBlock b = stressed_block();
  compute_forces(b);
  const Balance sum = balance_of(b);
  EXPECT_GT(sum.viscous_power, 0);
  EXPECT_NEAR(sum.force_power, -sum.stress_power - sum.viscous_power,
              1e3 * round_off * (std::abs(sum.stress_power) + sum.viscous_power));
}

// Constant stress on a periodic lattice: no force anywhere. sigma . n on a free face: the face's traction.
TEST(ParticleForces, OfAConstantStressVanishInsideALattice) {
  ParticleBlock b = particle_block(9, 9, 9, Real(1e-3));
  const auto s = host_copy(b.particles.points.stress);
  for (int i = 0; i < b.particles.count; ++i) s(i, 0) = Real(1e9), s(i, 3) = Real(2e8);
  Kokkos::deep_copy(b.particles.points.stress, s);
  build_lists(b);
  compute_forces(b);
  const auto x = host_copy(b.particles.position), f = host_copy(b.particles.force);
  const Real face = Real(1e9) * Real(1e-6);
  for (int i = 0; i < b.particles.count; ++i) {
    bool inside = true;
    for (int c = 0; c < 3; ++c) inside = inside && x(i, c) > 4e-3 && x(i, c) < 5e-3;
    if (inside) {
      EXPECT_LT(norm(load_vector(f, i)), 1e3 * round_off * face);
    }
  }
}

// The viscosity does not resist steady shear, but a shear of the same size that alternates from row to row.
TEST(ParticleForces, ViscosityLeavesALinearFieldAlone) {
  const auto power = [](bool alternates) {
    ParticleBlock b = particle_block(9, 9, 9, Real(1e-3));
    b.method.viscosity_linear = 1, b.method.viscosity_quadratic = 2;
    build_lists(b);
    const auto x = host_copy(b.particles.position), v = host_copy(b.particles.velocity);
    for (int i = 0; i < b.particles.count; ++i)
      v(i, 0) = alternates ? std::lround(double(x(i, 1)) * 1e3 - 0.5) % 2 : 1000 * x(i, 1);
    Kokkos::deep_copy(b.particles.velocity, v);
    compute_forces(b);
    return balance_of(b).viscous_power;
  };
  const double resisted = power(true);
  EXPECT_GT(resisted, 1e3);
  EXPECT_LT(std::abs(power(false)), 10 * round_off * resisted);
}

} // namespace
} // namespace swarf::test
