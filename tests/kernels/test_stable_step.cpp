// Courant's condition on lattices whose step is known.
#include "support/hex_block.hpp"
#include "support/materials.hpp"
#include "support/particle_block.hpp"
#include "swarf/hexes/hex8.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

const double wave_modulus = 1e11 + 4.0 / 3 * 8e10,
             wave_speed = std::sqrt(wave_modulus / 7800); // of elastic_steel

HexMethod bare_hexes(Real mass_factor) {
  HexMethod method;
  method.mass_factor = mass_factor;
  return method;
}

// Of waves, or 2 h sqrt(mass factor) / (1.61 alpha c) of the finest particle where its viscosity asks less;
// and how far the two farthest ones have moved together.
TEST(StableStep, OfTheFinestParticle) {
  ParticleBlock b = particle_block(6, 5, 4, Real(1e-3));
  build_lists(b);
  const auto inverse_support = host_copy(b.particles.inverse_support);
  inverse_support(17) = Real(0.5 / 0.7e-3);
  Kokkos::deep_copy(b.particles.inverse_support, inverse_support);
  const auto x = host_copy(b.particles.position);
  x(5, 1) += Real(3e-5), x(5, 2) -= Real(4e-5), x(9, 0) += Real(2e-5), x(30, 0) -= Real(1e-5);
  Kokkos::deep_copy(b.particles.position, x);
  b.method.mass_factor = 100;
  b.method.viscosity_linear = 5;
  const StableStep step = stable_step(b.particles, b.neighbors, b.materials, {b.method, 1});
  EXPECT_NEAR(double(step.dt) / (2 / (1.61 * 5) * 0.7e-3 * 10 / wave_speed), 1, round_off);
  EXPECT_EQ(step.limiter, 17);
  const Real shorter = Real(0.9) * step.dt;
  EXPECT_EQ(stable_step(b.particles, b.neighbors, b.materials, {b.method, shorter}).dt, shorter);
  EXPECT_NEAR(double(step.approach) / 7e-5, 1, 1e3 * round_off);
  x(9, 0) += Real(3e-5);
  Kokkos::deep_copy(b.particles.position, x);
  const StableStep both = stable_step(b.particles, b.neighbors, b.materials, {b.method, 1});
  EXPECT_NEAR(double(both.approach) / 10e-5, 1, 1e3 * round_off);
}

// Waves run the faster through the initial lattice the more it is sheared: for a shear of 5, with J = 1, at
// most 1 / (least stretch) times, a stretch whose square is (27 - sqrt(725)) / 2; at least half of that is
// asked.
TEST(StableStep, OfAShearedInitialLattice) {
  ParticleBlock b = particle_block(3, 3, 3, Real(1e-3));
  build_lists(b);
  const Real at_rest = Real(1.2e-3 / wave_speed);
  b.particles.deformation_gradient = TensorField("deformation_gradient", b.particles.count);
  const auto F = host_copy(b.particles.deformation_gradient);
  const auto fill = [&](const Tensor3& to) {
    for (int i = 0; i < b.particles.count; ++i) store_tensor(F, i, to);
    Kokkos::deep_copy(b.particles.deformation_gradient, F);
    return double(stable_step(b.particles, b.neighbors, b.materials, {b.method, at_rest}).dt / at_rest);
  };
  EXPECT_NEAR(fill(identity3()), 1, round_off);
  EXPECT_NEAR(fill({0, -1, 0, 1, 0, 0, 0, 0, 1}), 1, round_off); // turned
  EXPECT_NEAR(fill({0.25, 0, 0, 0, 1, 0, 0, 0, 1}), 0.5, round_off);
  const double least = std::sqrt((27 - std::sqrt(725)) / 2), sheared = fill({1, 5, 0, 0, 1, 0, 0, 0, 1});
  EXPECT_LE(sheared, least * (1 + round_off));
  EXPECT_GE(sheared, least / 2);
}

// Over its waves' crossing of an edge l: 2 / sqrt(12 K / M), by which a free cube breathes.
const double free_cube = 1 / std::sqrt(3 * 1e11 / wave_modulus);

// 2 / w of a brick, w2 = (4 / rho) (2 G / l1^2 + lambda (1 / l1^2 + 1 / l2^2 + 1 / l3^2)), l1 its thickness;
// a deleted hex does not count.
TEST(StableStep, OfTheThinnestHex) {
  const Material mat = elastic_steel();
  const double planes[4] = {0, 2e-3, 2.5e-3, 4.5e-3};
  HexMesh m = make_hex_block({3, 1, 1}, mat, [&](int i, int j, int k) {
    return Point{planes[i], 3e-3 * j, 4e-3 * k};
  });
  Status status("status");
  hex_velocity_gradient(m, status);
  const MaterialTable table = make_material_table({mat});
  const StableStep thin = stable_step(m, table, bare_hexes(4));
  const auto expected = [](double l1, double l2, double l3) {
    const double lambda = wave_modulus - 2 * 8e10, thin2 = 1 / (l1 * l1);
    const double w2 = 4 / 7800. * (2 * 8e10 * thin2 + lambda * (thin2 + 1 / (l2 * l2) + 1 / (l3 * l3)));
    return 2 / std::sqrt(w2);
  };
  EXPECT_NEAR(double(thin.dt) / (2 * expected(0.5e-3, 3e-3, 4e-3)), 1, 1e2 * round_off);
  EXPECT_EQ(thin.limiter, 1);
  const auto active = host_copy(m.active);
  active(1) = 0;
  Kokkos::deep_copy(m.active, active);
  EXPECT_NEAR(double(stable_step(m, table, bare_hexes(4)).dt) / (2 * expected(2e-3, 3e-3, 4e-3)), 1,
              1e2 * round_off);
  Kokkos::deep_copy(m.active, 0);
  EXPECT_EQ(stable_step(m, table, bare_hexes(4)).limiter, -1);
}

// A cube of 2 mm that shrinks at a rate of 0.3 c / l: (2 / w) (sqrt(1 + xi^2) - xi) (Belytschko, Liu & Moran
// 2000, 6.2.6), of the mode in which it breathes: x'' = -(12 / rho l^2) (K x + slope of q x').
TEST(StableStep, LeavesTheBulkViscosityItsShare) {
  const double l = 2e-3, rate = -0.3 * wave_speed / l, linear = 0.06, quadratic = 1.2;
  HexMesh m = make_hex_block({1, 1, 1}, elastic_steel(), [&](int i, int j, int k) {
    return Point{l * i, l * j, l * k};
  });
  const auto v = host_copy(m.velocity), x = host_copy(m.position);
  for (int a = 0; a < m.nodes; ++a) v(a, 1) = Real(rate) * x(a, 1);
  Kokkos::deep_copy(m.velocity, v);
  Status status("status");
  hex_velocity_gradient(m, status);
  const MaterialTable table = make_material_table({elastic_steel()});
  HexMethod method = bare_hexes(1);
  const auto share = [&](double b1, double b2) {
    method.viscosity_linear = Real(b1), method.viscosity_quadratic = Real(b2);
    return double(stable_step(m, table, method).dt) / (l / wave_speed);
  };
  const auto expected = [](double slope) { // of q over rho c l
    const double xi = 3 * slope * free_cube;
    return free_cube * (std::sqrt(1 + xi * xi) - xi);
  };
  EXPECT_NEAR(share(2, 0) / expected(2), 1, 1e2 * round_off);
  const HexInertia inertia{7800, Real(wave_speed)};
  const auto q = [&](double at) {
    return double(bulk_viscosity(inertia, Real(linear), Real(quadratic), Real(l), Real(at)));
  };
  const double slope = (q(1.01 * rate) - q(0.99 * rate)) / (0.02 * std::abs(rate)); // exact: q is quadratic
  EXPECT_NEAR(share(linear, quadratic) / expected(slope / (7800 * wave_speed * l)), 1, 1e4 * round_off);
  for (int a = 0; a < m.nodes; ++a) v(a, 1) *= -1;
  Kokkos::deep_copy(m.velocity, v);
  hex_velocity_gradient(m, status);
  EXPECT_NEAR(share(linear, quadratic) / expected(linear), 1, 1e2 * round_off);
}

// Nodes of a cube that move against all their neighbours: power 64 k s^2 of the hourglass forces on a mass
// rho V, from the forces themselves. Viscous: 2 / damping; stiff: 2 / frequency.
TEST(StableStep, LeavesTheHourglassControlItsShare) {
  const double l = 2e-3, mass = 7800 * l * l * l / 8; // of a node of a free cube
  HexMesh m = make_hex_block({1, 1, 1}, elastic_steel(), [&](int i, int j, int k) {
    return Point{l * i, l * j, l * k};
  });
  const auto v = host_copy(m.velocity), x = host_copy(m.position);
  for (int a = 0; a < m.nodes; ++a)
    v(a, 0) = (x(a, 0) > l / 2) == ((x(a, 1) > l / 2) == (x(a, 2) > l / 2)) ? 1 : -1;
  Kokkos::deep_copy(m.velocity, v);
  Status status("status");
  hex_velocity_gradient(m, status);
  const MaterialTable table = make_material_table({elastic_steel()});
  for (const bool stiff : {false, true}) {
    HexMethod method = bare_hexes(1);
    method.hourglass = stiff ? HourglassControl::stiffness : HourglassControl::viscous;
    method.hourglass_coefficient = 1;
    const Real dt = Real(1e-9); // s: what a stiffness adds to its force
    Kokkos::deep_copy(m.hourglass, Real(0));
    hex_forces(m, table, method, dt);
    const double force = std::abs(double(host_copy(m.corner_force)(0, 0, 0)));
    const double expected = stiff ? 2 * std::sqrt(mass * double(dt) / force) : 2 * mass / force;
    EXPECT_NEAR(double(stable_step(m, table, method).dt) / expected, 1, 1e3 * round_off) << stiff;
    EXPECT_LT(expected, free_cube * l / wave_speed) << stiff;
    method.hourglass_coefficient = Real(0.1); // the shipped default limits nothing
    EXPECT_NEAR(double(stable_step(m, table, method).dt) / (free_cube * l / wave_speed), 1, 1e2 * round_off)
        << stiff;
  }
}

TEST(StableStep, OfNothingLimitsNothing) {
  EXPECT_EQ(stable_step(HexMesh{}, MaterialTable(), {}).limiter, -1);
}

} // namespace
} // namespace swarf::test
