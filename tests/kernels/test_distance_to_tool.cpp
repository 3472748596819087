#include "support/box_tool.hpp"
#include "support/materials.hpp"
#include "swarf/kernels.hpp"
#include <gtest/gtest.h>

namespace swarf {
namespace {

TEST(DistanceToTool, OfABoxWithItsNormal) {
  const Tool box = test::make_box_tool({1, 2, 3}, 1);
  VectorField x("x", 3);
  test::set_row(x, 0, {Real(1.25), Real(0.1), Real(-0.2)}), test::set_row(x, 1, {0, Real(1.75), 0});
  test::set_row(x, 2, {100, 0, 0});
  const auto d = host_copy(distance_to_tool(box, x));
  EXPECT_NEAR(d(0, 0), 0.25, test::round_off);
  EXPECT_NEAR(d(0, 1), 1, test::round_off);
  EXPECT_NEAR(d(1, 0), -0.25, test::round_off);
  EXPECT_NEAR(d(1, 2), 1, test::round_off);
  EXPECT_EQ(d(2, 0), Kokkos::Experimental::infinity_v<Real>); // outside the grid
}

} // namespace
} // namespace swarf
