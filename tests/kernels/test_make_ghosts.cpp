#include "support/particle_block.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

GhostPlanes periodic(int axis, Real length) {
  const Vector3 n{Real(axis == 0), Real(axis == 1), Real(axis == 2)};
  return {{n, 0, {identity3(), length * n}, true, true},
          {Real(-1) * n, -length, {identity3(), (-length) * n}, true, true}};
}

// Constant stress in a slice, periodic along z: planes of constant x and y far from the surface feel no
// force, and no particle feels one along z.
TEST(MakeGhosts, PeriodicSliceUnderConstantStressFeelsNoForceAlongItsAxis) {
  const Real s = Real(1e-3);
  ParticleBlock b = particle_block(7, 7, 4, s);
  const auto stress = host_copy(b.particles.points.stress);
  for (int i = 0; i < b.particles.count; ++i)
    for (int c = 0; c < 6; ++c) stress(i, c) = Real(1e8) * Real(c + 1);
  Kokkos::deep_copy(b.particles.points.stress, stress);
  const GhostPlanes planes = periodic(2, 4 * s);
  build_lists(b, planes);
  b.method.correction = false; // K of a free surface would mix normal and shear stress
  velocity_gradient(b.particles, b.neighbors, b.method);
  prepare_pair_state(b.particles, b.materials, b.method);
  update_ghost_state(b.particles, b.neighbors, planes);
  particle_forces(b.particles, b.neighbors, b.method, Real(1));
  const auto f = host_copy(b.particles.force), x = host_copy(b.particles.position);
  const Real scale = Real(1e8) * s * s;
  for (int i = 0; i < b.particles.count; ++i) {
    if (std::abs(x(i, 0) - 3.5 * s) < 0.1 * s && std::abs(x(i, 1) - 3.5 * s) < 0.1 * s) {
      EXPECT_LT(norm(load_vector(f, i)), scale * 1e3 * Kokkos::Experimental::epsilon_v<Real>);
    }
  }
}

// v_z = 0 on a mirror plane: the ghost's velocity is the mirrored one, so a field odd in z is continued.
TEST(MakeGhosts, MirrorContinuesAnOddField) {
  const Real s = Real(1e-3);
  ParticleBlock b = particle_block(7, 7, 7, s);
  const Transform mirror{{1, 0, 0, 0, 1, 0, 0, 0, -1}, {0, 0, 0}};
  const GhostPlanes planes = {{{0, 0, 1}, 0, mirror, false, true}, {{0, 0, 1}, 0, mirror, false, false}};
  const auto v = host_copy(b.particles.velocity), x = host_copy(b.particles.position);
  for (int i = 0; i < b.particles.count; ++i) v(i, 2) = 5 * x(i, 2);
  Kokkos::deep_copy(b.particles.velocity, v);
  b.method.correction = false;
  build_lists(b, planes);
  EXPECT_EQ(b.neighbors.ghosts, 7 * 7 * 3);
  EXPECT_LE(int(b.particles.pair_stress.extent(0)),
            b.particles.total + b.neighbors.ghosts / 8); // no more room
  velocity_gradient(b.particles, b.neighbors, b.method);
  const auto L = host_copy(b.particles.points.velocity_gradient);
  const auto place = host_copy(b.particles.position);
  const auto at = [&](Real z) {
    for (int i = 0; i < b.particles.count; ++i)
      if (std::abs(place(i, 0) - 3.5 * s) < 0.1 * s && std::abs(place(i, 1) - 3.5 * s) < 0.1 * s &&
          std::abs(place(i, 2) - z) < 0.1 * s)
        return i;
    return -1;
  };
  EXPECT_NEAR(L(at(Real(0.5) * s), 8), L(at(Real(3.5) * s), 8),
              1e-4); // the surface sees what the middle sees
}

// The ghosts of a disordered periodic block carry the momentum balance.
TEST(MakeGhosts, PeriodicForcesConserveMomentum) {
  const Real s = Real(1e-3);
  ParticleBlock b = particle_block(6, 6, 6, s, Real(0.1));
  GhostPlanes planes;
  for (int axis = 0; axis < 3; ++axis)
    for (const GhostPlane& p : periodic(axis, 6 * s)) planes.push_back(p);
  const auto stress = host_copy(b.particles.points.stress);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<Real> u(-1, 1);
  for (int i = 0; i < b.particles.count; ++i)
    for (int c = 0; c < 6; ++c) stress(i, c) = Real(1e9) * u(random);
  Kokkos::deep_copy(b.particles.points.stress, stress);
  const Status status("status");
  Kokkos::deep_copy(status, no_fault);
  wrap_periodic(b.particles, planes, status);
  build_lists(b, planes);
  velocity_gradient(b.particles, b.neighbors, b.method);
  prepare_pair_state(b.particles, b.materials, b.method);
  update_ghost_state(b.particles, b.neighbors, planes);
  particle_forces(b.particles, b.neighbors, b.method, Real(1));
  const auto f = host_copy(b.particles.force);
  Vector3 sum{0, 0, 0};
  Real magnitude = 0;
  for (int i = 0; i < b.particles.count; ++i)
    sum = sum + load_vector(f, i), magnitude += norm(load_vector(f, i));
  EXPECT_LT(norm(sum), 100 * magnitude * Kokkos::Experimental::epsilon_v<Real>);
  EXPECT_EQ(host_copy(status)(), no_fault);
}

// A quarter of a ring: what leaves through x = 0 comes back through y = 0, turned by -90 degrees.
const GhostPlane quarter{{1, 0, 0}, 0, {{0, 1, 0, -1, 0, 0, 0, 0, 1}, {0, 0, 0}}, true, true};

TEST(WrapPeriodic, TurnsAllThatHasADirection) {
  ParticleBlock b = particle_block(2, 1, 1, Real(1e-3));
  Particles& p = b.particles;
  const Vector3 out{Real(-1e-4), Real(5e-3), 0}, v{1, 2, 3};
  const VectorField directed[] = {p.velocity,      p.force,          p.friction_force,
                                  p.contact_force, p.hourglass_rate, p.hourglass_displacement};
  for (const VectorField& field : directed) set_rows(field, 2, [&](const Vector3&) { return v; });
  set_rows(p.position, 1, [&](const Vector3&) { return out; });
  const Status status("status");
  Kokkos::deep_copy(status, no_fault);
  wrap_periodic(p, {quarter}, status);
  EXPECT_EQ(host_copy(status)(), no_fault);
  EXPECT_EQ(norm(load_vector(host_copy(p.position), 0) - Vector3{Real(5e-3), Real(1e-4), 0}), 0);
  for (int k = 0; k < 6; ++k) {
    const auto rows = host_copy(directed[k]);
    EXPECT_EQ(norm(load_vector(rows, 0) - Vector3{2, -1, 3}), 0) << k;
    EXPECT_EQ(norm(load_vector(rows, 1) - v), 0) << k;
  }
}

// By identity: rows are sorted before the status is read.
TEST(WrapPeriodic, NamesAParticleThatIsLost) {
  ParticleBlock b = particle_block(2, 1, 1, Real(1e-3));
  Kokkos::deep_copy(b.particles.identity, 7);
  set_rows(b.particles.position, 1, [](const Vector3&) { return Vector3{Real(-1e-4), Real(-5e-3), 0}; });
  const Status status("status");
  Kokkos::deep_copy(status, no_fault);
  wrap_periodic(b.particles, {quarter}, status);
  EXPECT_EQ(host_copy(status)() >> 32, unsigned(Fault::particle_lost));
  EXPECT_EQ(unsigned(host_copy(status)()), 7u);
}

} // namespace
} // namespace swarf::test
