#include "swarf/kernels.hpp"

#include "support/hex_step.hpp"
#include "support/materials.hpp"

#include <gtest/gtest.h>

namespace swarf {
namespace {

const Material solid = test::elastic_solid(2, 1, 1);

// Three hexes in a row under stress; hex 1 has failed, hex 2 is strained.
HexMesh make_row() {
  const HexMesh mesh = test::make_hex_block({3, 1, 1}, solid, 1);
  test::set_rows(mesh.points.stress, {3, -1, 2, 0.5, -0.9, 0.4});
  test::set_rows(mesh.velocity, {1, 2, 3});
  auto damage = host_copy(mesh.points.damage);
  auto strain = host_copy(mesh.points.equivalent_plastic_strain);
  damage(1) = 1, strain(2) = Real(0.8);
  Kokkos::deep_copy(mesh.points.damage, damage);
  Kokkos::deep_copy(mesh.points.equivalent_plastic_strain, strain);
  return mesh;
}

std::array<int, 3> active_of(const HexMesh& mesh) {
  const auto active = host_copy(mesh.active);
  return {active(0), active(1), active(2)};
}

TEST(DeleteHexes, DeletesByDamageOrByStrainOnlyWhatTheMethodAsksFor) {
  HexMethod method;
  HexMesh mesh = make_row();
  delete_hexes(mesh, method);
  EXPECT_EQ(active_of(mesh), (std::array<int, 3>{1, 1, 1}));
  method.delete_at_strain = Real(0.9);
  delete_hexes(mesh, method);
  EXPECT_EQ(active_of(mesh), (std::array<int, 3>{1, 1, 1}));
  method.delete_at_strain = Real(0.8);
  delete_hexes(mesh, method);
  EXPECT_EQ(active_of(mesh), (std::array<int, 3>{1, 1, 0}));
  method.delete_failed = true;
  delete_hexes(mesh, method);
  EXPECT_EQ(active_of(mesh), (std::array<int, 3>{1, 0, 0}));
}

// The deleted hex pulls no more, whatever its nodes do, and its mass stays at them; its neighbours carry on.
TEST(DeleteHexes, ADeletedHexLeavesNoForceAndKeepsItsMass) {
  HexMethod method;
  method.hourglass_coefficient = Real(0.1), method.delete_failed = true;
  const HexMesh mesh = make_row();
  double mass_before = 0, mass_after = 0;
  const auto mass = host_copy(mesh.mass);
  for (int a = 0; a < mesh.nodes; ++a) mass_before += mass(a);
  test::compute_forces(mesh, solid, method, Real(0.1));
  delete_hexes(mesh, method);
  test::set_nodal(mesh.velocity, mesh.position, [](const test::Point& x) {
    return test::Point{x[1] * x[2], x[0] * x[0], x[0] * x[1]};
  });
  for (int k = 0; k < 3; ++k) test::step_hexes(mesh, solid, method, {}, Real(0.01));
  const auto corner_force = host_copy(mesh.corner_force);
  double others = 0;
  for (int a = 0; a < 8; ++a)
    for (int d = 0; d < 3; ++d) {
      EXPECT_EQ(corner_force(1, a, d), 0);
      others += std::abs(corner_force(0, a, d)) + std::abs(corner_force(2, a, d));
    }
  EXPECT_GT(others, 1);
  const auto stress = host_copy(mesh.points.stress);
  for (int d = 0; d < 6; ++d) EXPECT_EQ(stress(1, d), 0);
  for (int a = 0; a < mesh.nodes; ++a) mass_after += mass(a);
  EXPECT_EQ(mass_before, mass_after);
  EXPECT_EQ(host_copy(mesh.active)(1), 0);
}

} // namespace
} // namespace swarf
