// Blocks of hexes that move: the kernels of the hexes and of time together.
#include "support/hex_step.hpp"
#include "support/materials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace swarf {
namespace {

constexpr bool is_double = sizeof(Real) == 8;

double kinetic_energy(const HexMesh& mesh) {
  const auto v = host_copy(mesh.velocity);
  const auto mass = host_copy(mesh.mass);
  double sum = 0;
  for (int a = 0; a < mesh.nodes; ++a)
    for (int d = 0; d < 3; ++d) sum += 0.5 * mass(a) * v(a, d) * v(a, d);
  return sum;
}
double total(const ScalarField& field) {
  const auto host = host_copy(field);
  double sum = 0;
  for (std::size_t e = 0; e < host.extent(0); ++e) sum += host(e);
  return sum;
}

struct EnergyBalance {
  double residual, hourglass, least_hourglass, kinetic; // of the kinetic energy at the start
};
EnergyBalance measure_energies(HourglassControl control, Real dt) {
  const Material mat = test::elastic_solid(2, 1, 1);
  HexMethod method;
  method.hourglass = control, method.hourglass_coefficient = Real(0.05);
  const HexMesh mesh = test::make_distorted_block({3, 3, 3}, mat, 1, 0.1);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1e-3, 1e-3);
  test::set_nodal(mesh.velocity, mesh.position, [&](const test::Point&) {
    return test::Point{uniform(random), uniform(random), uniform(random)};
  });
  test::compute_forces(mesh, mat, method, 0);
  const double start = kinetic_energy(mesh);
  EnergyBalance b{0, 0, 0, 0};
  for (int k = 0; k < int(40 / dt); ++k) {
    test::step_hexes(mesh, mat, method, {}, dt);
    b.kinetic = kinetic_energy(mesh) / start, b.hourglass = total(mesh.hourglass_work) / start;
    b.least_hourglass = std::min(b.least_hourglass, b.hourglass);
    const double sum = b.kinetic + b.hourglass + total(mesh.points.internal_work) / start;
    b.residual = std::max(b.residual, std::abs(sum - 1));
  }
  return b;
}

// A free block in random motion, hourglass modes among it: what leaves the kinetic and the strain energy is
// found in hourglass_work, which is never negative. The residual is that of the central differences, second
// order.
TEST(HexMotion, HourglassWorkBalancesTheEnergy) {
  for (const HourglassControl control : {HourglassControl::viscous, HourglassControl::stiffness}) {
    const EnergyBalance b = measure_energies(control, Real(0.1));
    const EnergyBalance half = measure_energies(control, Real(0.05));
    std::printf("free block: energy residual %.2g, at half the step %.2g, hourglass work %.2g\n", b.residual,
                half.residual, b.hourglass);
    EXPECT_GE(b.least_hourglass, 0);
    EXPECT_GT(b.hourglass, 0.05);
    EXPECT_LT(b.kinetic, 0.9);
    EXPECT_LT(b.residual, 0.02);
    EXPECT_LT(half.residual, 0.3 * b.residual);
  }
}

// A free block falls: the mean acceleration is g to round-off, whatever the stresses do inside; with mass
// scaling too.
TEST(HexMotion, FreeBlockFallsWithG) {
  const Material mat = test::elastic_solid(Real(1e11), Real(5e10), 8000);
  for (const Real factor : {Real(1), Real(100)}) {
    HexMethod method;
    method.hourglass_coefficient = Real(0.05), method.mass_factor = factor;
    const HexMesh mesh = test::make_distorted_block({3, 2, 4}, mat, 0.01, 0.2);
    test::set_nodal(mesh.velocity, mesh.position, [](const test::Point& x) {
      return test::Point{100 * x[1] * x[2], 10 * x[0], 50 * x[0] * x[0]};
    });
    const auto mass = host_copy(mesh.mass);
    auto momentum = [&] {
      const auto v = host_copy(mesh.velocity);
      double sum = 0;
      for (int a = 0; a < mesh.nodes; ++a) sum += mass(a) * v(a, 2);
      return sum;
    };
    const double before = momentum();
    const Real dt = Real(2e-7) * std::sqrt(factor), g = Real(9.81e4);
    for (int k = 0; k < 20; ++k) test::step_hexes(mesh, mat, method, {{0, 0, -g}}, dt);
    const double block = total(mesh.points.mass); // lumping keeps it
    EXPECT_NEAR((momentum() - before) / (-g * 20 * dt * block), 1, is_double ? 1e-12 : 1e-4);
  }
}

// A bar of length 2 cm, E = 3e11 Pa, nu = 0, 7800 kg/m3, c = 6201.7 m/s, one end fixed, moves with 10 m/s:
// the free end turns back after L / c = 3.2249 us at v0 L / c = 3.2249e-5 m (d'Alembert).
TEST(HexMotion, BarWaveTurnsBackAtTheRightTimeAndPlace) {
  const Material mat = test::elastic_solid(Real(1e11), Real(1.5e11), 7800);
  const int cells = 200;
  const double edge = 0.02 / cells, c = std::sqrt(3e11 / 7800);
  const HexMesh mesh = test::make_hex_block({cells, 1, 1}, mat, edge);
  test::set_rows(mesh.velocity, {10, 0, 0});
  const test::Surroundings fixed; // row 0 of the constraints holds all components at 0
  Kokkos::deep_copy(fixed.constraints, Constraint{});
  auto bits = host_copy(mesh.constraints);
  const test::Cells n{cells, 1, 1};
  for (int jk = 0; jk < 4; ++jk) bits(test::block_node(n, 0, jk % 2, jk / 2)) = 1;
  Kokkos::deep_copy(mesh.constraints, bits);
  HexMethod method;
  method.hourglass_coefficient = Real(0.05), method.viscosity_linear = Real(0.06);
  const int end = test::block_node(n, cells, 0, 0);
  const Real dt = Real(0.5 * edge / c);
  double peak = 0, when = 0;
  for (int k = 0; k < 3 * cells; ++k) {
    test::step_hexes(mesh, mat, method, fixed, dt);
    const double u = host_copy(mesh.position)(end, 0) - 0.02;
    if (u > peak) peak = u, when = (k + 1) * dt;
  }
  // A position takes equal increments v dt, each rounded the same way by up to half a unit of its last place.
  const double last_place = std::numeric_limits<Real>::epsilon() / 64, rounding = last_place / 2 / (10 * dt);
  EXPECT_NEAR(peak / 3.2249e-5, 1, 0.01 + rounding);
  EXPECT_NEAR(when / 3.2249e-6, 1, 0.02);
  std::printf("bar wave: peak %.5g m at %.5g s\n", peak, when);
}

} // namespace
} // namespace swarf
