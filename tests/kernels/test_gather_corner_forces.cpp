#include "swarf/kernels.hpp"

#include "support/hex_block.hpp"
#include "support/materials.hpp"

#include <gtest/gtest.h>

namespace swarf {
namespace {

// A node's force is the sum over the hexes around it: 8 inside, 4 on a face, 2 on an edge, 1 at a corner; and
// it is set, not added to.
TEST(GatherCornerForces, SumsTheCornersAroundEachNode) {
  const test::Cells n{3, 3, 3};
  const HexMesh mesh = test::make_hex_block(n, test::elastic_solid(1, 1, 1), 1);
  auto corner_force = host_copy(mesh.corner_force);
  for (int e = 0; e < 27; ++e)
    for (int a = 0; a < 8; ++a) corner_force(e, a, 0) = 1, corner_force(e, a, 1) = 8 * e + a;
  Kokkos::deep_copy(mesh.corner_force, corner_force);
  test::set_rows(mesh.force, {7, 7, 7});
  gather_corner_forces(mesh);
  const auto force = host_copy(mesh.force);
  double total = 0;
  for (int k = 0; k <= 3; ++k)
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i <= 3; ++i) {
        const int node = test::block_node(n, i, j, k);
        const int expected = (i % 3 ? 2 : 1) * (j % 3 ? 2 : 1) * (k % 3 ? 2 : 1);
        EXPECT_EQ(force(node, 0), expected);
        EXPECT_EQ(force(node, 2), 0);
        total += force(node, 1);
      }
  EXPECT_EQ(force(0, 1), 0);                                     // corner 0 of hex 0
  EXPECT_EQ(force(test::block_node(n, 3, 3, 3), 1), 8 * 26 + 6); // corner 6 of the last hex
  EXPECT_EQ(total, 215 * 216 / 2);                               // every corner once
}

} // namespace
} // namespace swarf
