#include "swarf/kernels.hpp"

#include "support/box_tool.hpp"
#include "support/hex_block.hpp"
#include "support/materials.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace swarf {
namespace {

constexpr int hexes = 6;

// Unit cubes in a row along x, centres at 0.5 .. 5.5.
HexMesh make_row() { return test::make_hex_block({hexes, 1, 1}, test::elastic_solid(2, 1, 1), 1); }

ScalarField limit(double value) {
  const ScalarField field("limit", hexes);
  Kokkos::deep_copy(field, Real(value));
  return field;
}

std::vector<int> chosen(const HexMesh& mesh, const ConversionLimits& limits, const ToolPose& pose = {}) {
  const auto flags = host_copy(choose_hexes(mesh, limits, pose));
  return {flags.data(), flags.data() + hexes};
}

// A box with its face at x = -1 + what it has moved; it lies over the row's y and z.
TEST(ChooseHexes, NearToTheToolWhereItIsNow) {
  const HexMesh mesh = make_row();
  ConversionLimits limits{limit(2.6), limit(0), test::make_box_tool({4, 4, 4}, 4)};
  ToolPose pose;
  pose.position = {-5, 0.5, 0.5};
  EXPECT_EQ(chosen(mesh, limits, pose), (std::vector<int>{1, 1, 0, 0, 0, 0})); // 1.5 and 2.5 away
  pose.position.x += Real(1);
  EXPECT_EQ(chosen(mesh, limits, pose), (std::vector<int>{1, 1, 1, 0, 0, 0}));
  const auto distance = host_copy(limits.distance);
  distance(1) = 0; // never
  Kokkos::deep_copy(limits.distance, distance);
  EXPECT_EQ(chosen(mesh, limits, pose), (std::vector<int>{1, 0, 1, 0, 0, 0}));
  limits.tool.facets = 0; // there is none
  EXPECT_EQ(chosen(mesh, limits, pose), std::vector<int>(hexes, 0));
}

TEST(ChooseHexes, StrainedAsMuchAsTheLimitAndActive) {
  const HexMesh mesh = make_row();
  const ConversionLimits limits{limit(0), limit(0.5), Tool{}};
  const auto strain = host_copy(mesh.points.equivalent_plastic_strain);
  strain(1) = Real(0.5), strain(2) = Real(0.49), strain(3) = Real(0.8), strain(4) = Real(0.8);
  Kokkos::deep_copy(mesh.points.equivalent_plastic_strain, strain);
  const auto active = host_copy(mesh.active);
  active(3) = hex_deleted;
  Kokkos::deep_copy(mesh.active, active);
  EXPECT_EQ(chosen(mesh, limits), (std::vector<int>{0, 1, 0, 0, 1, 0}));
}

} // namespace
} // namespace swarf
