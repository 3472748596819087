#include "swarf/kernels.hpp"

#include "support/hex_block.hpp"
#include "support/materials.hpp"
#include "support/status.hpp"

#include <gtest/gtest.h>

namespace swarf {
namespace {

const Material solid = test::elastic_solid(Real(1e11), Real(5e10), 8000);

// Patch test: a linear field has the same gradient in each distorted hex, to round-off.
TEST(HexVelocityGradient, IsExactForALinearFieldOnADistortedBlock) {
  const double edge = 1e-5, gradient[9] = {3e3, -2e4, 1e4, 7e3, -1e3, 4e4, -3e4, 1.5e4, 8e3};
  const HexMesh mesh = test::make_distorted_block({4, 3, 5}, solid, edge, 0.2);
  test::set_nodal(mesh.velocity, mesh.position, [&](const test::Point& x) {
    test::Point v{5, -7, 11};
    for (int i = 0; i < 9; ++i) v[i / 3] += gradient[i] * x[i % 3];
    return v;
  });
  const Status status = test::make_status();
  hex_velocity_gradient(mesh, status);
  EXPECT_EQ(test::read_status(status), no_fault);
  const auto L = host_copy(mesh.points.velocity_gradient);
  const double tolerance = sizeof(Real) == 8 ? 1e-9 * 4e4 : 0.1 * 4e4; // v is rounded at 11 m/s
  for (int e = 0; e < mesh.points.count; ++e)
    for (int i = 0; i < 9; ++i) ASSERT_NEAR(L(e, i), gradient[i], tolerance) << e << " " << i;
}

// The faces that two hexes share cancel, so the volumes of a block with plane sides add up to its own.
TEST(HexVelocityGradient, VolumesAddUp) {
  const HexMesh mesh = test::make_hex_block({3, 3, 3}, solid, [](int i, int j, int k) {
    const bool inside = i % 3 && j % 3 && k % 3;
    return test::Point{i + 0.3 * inside, j - 0.2 * inside * (i == 1), k + 0.1 * inside * (j == 2)};
  });
  hex_velocity_gradient(mesh, test::make_status());
  const auto volume = host_copy(mesh.volume);
  double sum = 0;
  for (int e = 0; e < 27; ++e) sum += volume(e);
  EXPECT_NEAR(sum, 27, 27 * test::round_off);
  EXPECT_GT(std::abs(volume(0) - 1), 0.01);
}

TEST(HexVelocityGradient, ReportsAnInvertedHexAndSkipsDeletedOnes) {
  const HexMesh mesh = test::make_hex_block({3, 1, 1}, solid, [](int i, int j, int k) {
    const double x = i == 3 ? 0.5 : i; // the last hex, and only this, is turned inside out
    return test::Point{x, double(j), double(k)};
  });
  Status status = test::make_status();
  hex_velocity_gradient(mesh, status);
  EXPECT_EQ(test::read_status(status), test::fault_at(Fault::inverted_hex, 2));

  auto active = host_copy(mesh.active);
  active(2) = 0;
  Kokkos::deep_copy(mesh.active, active);
  status = test::make_status();
  hex_velocity_gradient(mesh, status);
  EXPECT_EQ(test::read_status(status), no_fault);
}

} // namespace
} // namespace swarf
