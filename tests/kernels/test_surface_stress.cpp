// Forces at surfaces are the adjoint of the gradients there.
#include "support/particle_block.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

constexpr Real round_off = Kokkos::Experimental::epsilon_v<Real>;

struct Balance {
  Vector3 force{0, 0, 0}, torque{0, 0, 0};
  Real magnitude = 0, arm_magnitude = 0, force_power = 0, stress_power = 0, added_power = 0;
};

// Random stress and velocity on a disordered block with free surfaces; in the initial frame also deformed.
Balance balance_of_forces(bool initial, const GhostPlanes& planes = {}) {
  ParticleBlock b = particle_block(9, 8, 7, Real(1e-3), Real(0.1));
  Particles& p = b.particles;
  p.surface_shift = View<Real* [4]>("surface_shift", p.count);
  p.edge_normal = VectorField("edge_normal", p.count);
  p.surface_term = TensorField("surface_term", p.count);
  const auto s = host_copy(p.points.stress);
  const auto v = host_copy(p.velocity);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<Real> u(-1, 1);
  for (int i = 0; i < p.count; ++i) {
    for (int c = 0; c < 6; ++c) s(i, c) = Real(1e9) * u(random);
    for (int c = 0; c < 3; ++c) v(i, c) = 10 * u(random);
  }
  Kokkos::deep_copy(p.points.stress, s), Kokkos::deep_copy(p.velocity, v);
  if (initial) p.deformation_gradient = TensorField("deformation_gradient", p.count);
  b.method.initial_frame = initial;
  build_lists(b, planes);
  if (initial) {
    set_rows(p.position, p.count, [&](const Vector3& x) {
      return x + Real(5e-5) * Vector3{u(random), u(random), u(random)};
    });
    update_ghosts(p, b.neighbors, planes);
    reference_gradient(p, b.neighbors);
  } else {
    velocity_gradient(p, b.neighbors, b.method);
  }
  const auto plain = host_copy(copy_of(p.points.velocity_gradient));
  correct_surface(p, b.neighbors, planes);
  const auto x = host_copy(p.position);
  const auto L = host_copy(p.points.velocity_gradient);
  const auto stress = host_copy(p.points.stress);
  const auto velocity = host_copy(p.velocity);
  surface_stress(p, b.neighbors, planes);
  prepare_pair_state(p, b.materials, b.method);
  update_ghost_state(p, b.neighbors, planes);
  particle_forces(p, b.neighbors, b.method, Real(1));
  const auto f = host_copy(p.force);
  const auto V = host_copy(p.volume);
  Balance sum;
  for (int i = 0; i < p.count; ++i) {
    const Vector3 f_i = load_vector(f, i), x_i = load_vector(x, i);
    sum.force = sum.force + f_i, sum.torque = sum.torque + cross(x_i, f_i);
    sum.magnitude += norm(f_i), sum.arm_magnitude += norm(x_i) * norm(f_i);
    sum.force_power += dot(f_i, load_vector(velocity, i));
    const Symmetric3 sigma = load_symmetric(stress, i);
    const Real J = initial ? determinant(load_tensor(p.deformation_gradient, i)) : Real(1);
    const Real own = J * contract(sigma, symmetric_part(load_tensor(L, i)));
    sum.stress_power += V(i) * own;
    sum.added_power += V(i) * (own - J * contract(sigma, symmetric_part(load_tensor(plain, i))));
  }
  return sum;
}

TEST(SurfaceStress, ForcesDoTheWorkOfTheStresses) {
  for (const bool initial : {false, true}) {
    const Balance sum = balance_of_forces(initial);
    EXPECT_GT(std::abs(sum.added_power), Real(1e-3) * std::abs(sum.stress_power));
    EXPECT_NEAR(sum.force_power, -sum.stress_power, 1e4 * round_off * std::abs(sum.stress_power));
  }
}

TEST(SurfaceStress, KeepsLinearAndAngularMomentum) {
  for (const bool initial : {false, true}) {
    const Balance sum = balance_of_forces(initial);
    EXPECT_LT(norm(sum.force), 100 * round_off * sum.magnitude);
    EXPECT_LT(norm(sum.torque), 100 * round_off * sum.arm_magnitude);
  }
}

// Ghosts bring what their rows bring, with vectors and stresses turned: in a slice that is periodic along z,
// and in half of what a mirror at x = 0 and one at z = 0 make whole.
TEST(SurfaceStress, ForcesDoTheWorkOfTheStressesBesideGhosts) {
  const Transform back{{-1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}},
      down{{1, 0, 0, 0, 1, 0, 0, 0, -1}, {0, 0, 0}};
  const GhostPlanes slice = {{{0, 0, 1}, 0, {identity3(), {0, 0, Real(7e-3)}}, true, true},
                             {{0, 0, -1}, Real(-7e-3), {identity3(), {0, 0, Real(-7e-3)}}, true, true}};
  const GhostPlanes mirrors = {{{1, 0, 0}, 0, back, false, true}, {{0, 0, 1}, 0, down, false, true}};
  for (const GhostPlanes& planes : {slice, mirrors})
    for (const bool initial : {false, true}) {
      const Balance sum = balance_of_forces(initial, planes);
      EXPECT_GT(std::abs(sum.added_power), Real(1e-3) * std::abs(sum.stress_power));
      EXPECT_NEAR(sum.force_power, -sum.stress_power, 1e4 * round_off * std::abs(sum.stress_power));
    }
}

} // namespace
} // namespace swarf::test
