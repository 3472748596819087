#include "swarf/kernels.hpp"
#include "swarf/material/stress_update.hpp"

#include "support/hex_step.hpp"
#include "support/materials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace swarf {
namespace {

constexpr bool is_double = sizeof(Real) == 8;
constexpr double round_off = test::round_off;

// Patch test: a constant stress leaves no force on the nodes inside a distorted block.
TEST(HexForces, ConstantStressIsInEquilibriumInside) {
  const test::Cells n{4, 4, 4};
  const HexMesh mesh = test::make_distorted_block(n, test::elastic_solid(1, 1, 1), 1, 0.2);
  test::set_rows(mesh.points.stress, {3, -1, 2, 0.5, -0.9, 0.4});
  test::compute_forces(mesh, test::elastic_solid(1, 1, 1), {}, 1);
  const auto force = host_copy(mesh.force);
  double outside = 0;
  for (int k = 0; k <= 4; ++k)
    for (int j = 0; j <= 4; ++j)
      for (int i = 0; i <= 4; ++i)
        for (int d = 0; d < 3; ++d) {
          const double f = force(test::block_node(n, i, j, k), d);
          if (i % 4 && j % 4 && k % 4)
            ASSERT_NEAR(f, 0, round_off);
          else
            outside = std::max(outside, std::abs(f));
        }
  EXPECT_GT(outside, 1);
}

// Eigenvalues of a symmetric matrix by Jacobi's rotations, ascending.
std::vector<double> eigenvalues(std::vector<std::vector<double>> a) {
  const int n = int(a.size());
  for (int sweep = 0; sweep < 20; ++sweep)
    for (int p = 0; p < n; ++p)
      for (int q = p + 1; q < n; ++q) {
        if (std::abs(a[p][q]) < 1e-300) continue;
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(t * t + 1), s = t * c;
        for (int k = 0; k < n; ++k) {
          const double kp = a[k][p], kq = a[k][q];
          a[k][p] = c * kp - s * kq, a[k][q] = s * kp + c * kq;
        }
        for (int k = 0; k < n; ++k) {
          const double pk = a[p][k], qk = a[q][k];
          a[p][k] = c * pk - s * qk, a[q][k] = s * pk + c * qk;
        }
      }
  std::vector<double> values(n);
  for (int k = 0; k < n; ++k) values[k] = a[k][k];
  std::sort(values.begin(), values.end());
  return values;
}

// Stiffness of the unit cube, column by column: forces of a small velocity over a step of 1.
std::vector<double> cube_eigenvalues(const HexMethod& method) {
  const double E = 1, nu = 0.33, small = is_double ? 1e-7 : 1e-4;
  const Material mat = test::elastic_solid(Real(E / (3 * (1 - 2 * nu))), Real(E / (2 * (1 + nu))), 1);
  std::vector<std::vector<double>> K(24, std::vector<double>(24));
  for (int column = 0; column < 24; ++column) {
    const HexMesh mesh = test::make_hex_block({1, 1, 1}, mat, 1);
    auto v = host_copy(mesh.velocity);
    v(column / 3, column % 3) = Real(small);
    Kokkos::deep_copy(mesh.velocity, v);
    test::compute_forces(mesh, mat, method, 1);
    const auto force = host_copy(mesh.force);
    for (int row = 0; row < 24; ++row) K[row][column] = -force(row / 3, row % 3) / small;
  }
  return eigenvalues(K);
}

// E = 1, nu = 0.33, one point: 18 zeros, 5 x 0.375940 (the shear modulus), 1 x 1.470588 (1.5 K).
TEST(HexForces, EigenvaluesOfTheUnitCube) {
  const double tolerance = is_double ? 1e-6 : 1e-3;
  const std::vector<double> values = cube_eigenvalues({});
  for (int k = 0; k < 18; ++k) EXPECT_NEAR(values[k], 0, tolerance);
  for (int k = 18; k < 23; ++k) EXPECT_NEAR(values[k], 0.375940, tolerance);
  EXPECT_NEAR(values[23], 1.470588, tolerance);
}

// Stiffness control with kappa lifts the 12 hourglass modes, and only them, to kappa 4 mu V B:B, which is
// 1.5 kappa 4 mu on the unit cube; 6 rigid motions stay free.
TEST(HexForces, StiffnessControlLiftsTheHourglassModesOnly) {
  const double tolerance = is_double ? 1e-6 : 1e-3;
  HexMethod method;
  method.hourglass = HourglassControl::stiffness, method.hourglass_coefficient = Real(0.05);
  const std::vector<double> values = cube_eigenvalues(method);
  const double expected = 0.05 * 1.5 * 4 / (2 * 1.33); // mu = E / (2 (1 + nu)), E = 1
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(values[k], 0, tolerance);
  for (int k = 6; k < 18; ++k) EXPECT_NEAR(values[k], expected, tolerance);
  for (int k = 18; k < 23; ++k) EXPECT_NEAR(values[k], 0.375940, tolerance);
  EXPECT_NEAR(values[23], 1.470588, tolerance);
}

Real largest(const VectorField& field) {
  const auto host = host_copy(field);
  Real most = 0;
  for (std::size_t a = 0; a < host.extent(0); ++a)
    for (int d = 0; d < 3; ++d) most = std::max(most, std::abs(host(a, d)));
  return most;
}

// Both controls are silent on rigid motions and linear fields, on distorted hexes: with the stress removed no
// force is left. A mode is resisted.
TEST(HexForces, HourglassControlSeesHourglassModesOnly) {
  Material mat = test::elastic_solid(1, 1, 1);
  const MaterialTable table = test::make_material_table({mat});
  for (const HourglassControl control : {HourglassControl::viscous, HourglassControl::stiffness}) {
    HexMethod method;
    method.hourglass = control, method.hourglass_coefficient = Real(0.1);
    const HexMesh mesh = test::make_distorted_block({3, 3, 3}, mat, 1, 0.2);
    test::set_nodal(mesh.velocity, mesh.position, [](const test::Point& x) {
      return test::Point{3 + x[0] - 2 * x[1] + x[2], -2 + 4 * x[0] + x[1], 1 - 3 * x[1] + 2 * x[2]};
    });
    hex_velocity_gradient(mesh, test::make_status());
    hex_forces(mesh, table, method, Real(0.1));
    gather_corner_forces(mesh);
    EXPECT_LT(largest(mesh.force), 10 * round_off);
    test::set_nodal(mesh.velocity, mesh.position, [](const test::Point& x) {
      return test::Point{std::cos(M_PI * std::round(x[0])) * std::cos(M_PI * std::round(x[1])), 0, 0};
    });
    hex_velocity_gradient(mesh, test::make_status());
    hex_forces(mesh, table, method, Real(0.1));
    gather_corner_forces(mesh);
    EXPECT_GT(largest(mesh.force), 0.01);
    const auto work = host_copy(mesh.hourglass_work);
    for (int e = 0; e < mesh.points.count; ++e) EXPECT_GT(work(e), 0);
  }
}

// An hourglass stress that is small beside the yield stress, in a hex that flows at a steady rate, comes to
// that of a fluid with the viscosity sigma_y / (3 rate): the elastic generalised force of one relaxation time
// sigma_y / (3 G rate). (J2 flow: the deviator at right angles to the mean one relaxes at 3 G rate /
// sigma_y.)
TEST(HexForces, HourglassStressRelaxesInPlasticFlow) {
  Material mat = test::elastic_solid(2, 1, 1);
  mat.law = FlowLaw::linear_hardening, mat.linear_hardening.yield_stress = Real(1e-3);
  const double rate = 1, dt = 1e-6, q = 1e-3, stiffness = 0.7, relaxation_time = 1e-3 / 3;
  const Symmetric3 yielding{0, 0, 0, Real(1e-3 / std::sqrt(3.0)), 0, 0};
  HourglassStep step{true, Real(stiffness), identity3(), share_kept(mat, yielding, Real(rate * dt)),
                     Real(dt)};
  HexModes rates{}, force{};
  rates.mode[2] = {0, Real(q), 0};
  for (int k = 0; k < 20 * relaxation_time / dt; ++k) force = update_hourglass(force, rates, step).force;
  EXPECT_NEAR(force.mode[2].y / (stiffness * q * relaxation_time), 1, is_double ? 1e-8 : 1e-3);
  step.kept = share_kept(mat, yielding, 0);
  const HexModes before = force;
  force = update_hourglass(before, HexModes{}, step).force;
  EXPECT_EQ(force.mode[2].y, before.mode[2].y); // elastic: kept
}

// A copy that later launches do not change.
std::vector<Real> rows_of(const VectorField& field) {
  const auto host = host_copy(field);
  std::vector<Real> rows;
  for (std::size_t a = 0; a < host.extent(0); ++a)
    for (int d = 0; d < 3; ++d) rows.push_back(host(a, d));
  return rows;
}

// A stressed block with hourglass forces in it, turned through 360 degrees in 90 central-difference steps:
// the corner forces turn along and come back.
TEST(HexForces, StressAndHourglassForcesTurnWithTheBlock) {
  const Material mat = test::elastic_solid(2, 1, 1);
  HexMethod method;
  method.hourglass = HourglassControl::stiffness, method.hourglass_coefficient = Real(0.1);
  const HexMesh mesh = test::make_distorted_block({2, 2, 2}, mat, 1, 0.15);
  test::set_rows(mesh.points.stress, {0.3, -0.1, 0.2, 0.05, -0.09, 0.04});
  auto hourglass = host_copy(mesh.hourglass);
  for (int i = 0; i < 8 * 12; ++i) hourglass(i / 12, i / 3 % 4, i % 3) = Real(std::sin(i));
  Kokkos::deep_copy(mesh.hourglass, hourglass);
  test::compute_forces(mesh, mat, method, 1);
  const std::vector<Real> x0 = rows_of(mesh.position), force = rows_of(mesh.force);

  const int steps = 90;
  auto x = host_copy(mesh.position), v = host_copy(mesh.velocity);
  double error = 0;
  for (int k = 1; k <= steps; ++k) {
    const double angle = 2 * M_PI * k / steps, c = std::cos(angle), s = std::sin(angle);
    for (int a = 0; a < mesh.nodes; ++a) {
      const double x1 = x0[3 * a], y1 = x0[3 * a + 1];
      const double u[3] = {c * x1 - s * y1, s * x1 + c * y1, x0[3 * a + 2]};
      for (int d = 0; d < 3; ++d) v(a, d) = Real(u[d]) - x(a, d), x(a, d) = Real(u[d]);
    }
    Kokkos::deep_copy(mesh.position, x), Kokkos::deep_copy(mesh.velocity, v);
    test::compute_forces(mesh, mat, method, 1);
    const auto now = host_copy(mesh.force);
    for (int a = 0; a < mesh.nodes; ++a)
      error = std::max(error, std::abs(c * force[3 * a] - s * force[3 * a + 1] - now(a, 0)));
  }
  EXPECT_LT(error, is_double ? 1e-11 : 1e-3);
  const auto work = host_copy(mesh.hourglass_work), internal = host_copy(mesh.points.internal_work);
  for (int e = 0; e < 8; ++e) {
    EXPECT_NEAR(work(e), 0, is_double ? 1e-12 : 1e-3);
    EXPECT_NEAR(internal(e), 0, is_double ? 1e-12 : 1e-3);
  }
}

// Uniform compression of one cube: the pressure on a face is q of the formula, with the scaled density s rho
// and wave speed c / sqrt(s); the work is q |rate| V dt.
TEST(HexForces, BulkViscosityPushesBackWithScaledInertia) {
  const Material mat = test::elastic_solid(Real(1e11), Real(6e10), 8000);
  HexMethod method;
  method.viscosity_linear = Real(0.06), method.viscosity_quadratic = Real(1.2), method.mass_factor = 100;
  const HexMesh mesh = test::make_hex_block({1, 1, 1}, mat, 0.01);
  test::set_nodal(mesh.velocity, mesh.position, [](const test::Point& x) {
    return test::Point{-1e4 * x[0], 0, 0};
  });
  hex_velocity_gradient(mesh, test::make_status());
  hex_forces(mesh, test::make_material_table({mat}), method, Real(1e-8));
  gather_corner_forces(mesh);
  const double c = std::sqrt(1.8e11 / 8000) / 10, lr = 0.01 * 1e4;
  const double q = 8e5 * (1.44 * lr * lr + 0.06 * c * lr);
  const double tolerance = is_double ? 1e-10 : 1e-4;
  const auto force = host_copy(mesh.force);
  EXPECT_NEAR(force(1, 0) / (q * 1e-4 / 4), 1, tolerance); // a quarter of the face
  EXPECT_NEAR(force(0, 0) / (-q * 1e-4 / 4), 1, tolerance);
  EXPECT_NEAR(host_copy(mesh.viscous_work)(0) / (q * 1e4 * 1e-6 * 1e-8), 1, tolerance);
}

} // namespace
} // namespace swarf
