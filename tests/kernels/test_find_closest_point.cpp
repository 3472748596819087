// The deepest contact with a box, where distances are known.
#include "support/box_tool.hpp"
#include "swarf/kernels.hpp"
#include <gtest/gtest.h>

namespace swarf {
namespace {

ContactPoints points_above(const std::vector<double>& z, double gap) {
  ContactPoints p = test::make_contact_points(int(z.size()), 1);
  for (std::size_t i = 0; i < z.size(); ++i) test::set_row(p.position, int(i), {0, 0, Real(z[i])});
  Kokkos::deep_copy(p.gap, Real(gap));
  return p;
}

} // namespace

TEST(FindClosestPoint, IsThePenetrationOfTheContact) {
  const Tool tool = test::make_box_tool({1, 1, 1}, 1); // its upper face at z = 1
  const ClosestPoint at = find_closest_point(points_above({1.6, 1.15, 1.4, 1.15}, 0.25), tool, {});
  EXPECT_EQ(at.row, 1) << "of equal ones the first";
  EXPECT_NEAR(double(at.depth), 0.1, 1e-6);
  ToolPose higher;
  higher.position = {0, 0, Real(0.05)};
  EXPECT_NEAR(double(find_closest_point(points_above({1.15}, 0.25), tool, higher).depth), 0.15, 1e-6);
}

TEST(FindClosestPoint, CountsApartAsNegative) {
  const Tool tool = test::make_box_tool({1, 1, 1}, 1);
  EXPECT_NEAR(double(find_closest_point(points_above({1.6, 1.5}, 0.25), tool, {}).depth), -0.25, 1e-6);
}

TEST(FindClosestPoint, HasNoRowWhereNothingIsNear) {
  const Tool tool = test::make_box_tool({1, 1, 1}, 1);
  EXPECT_EQ(find_closest_point(points_above({50}, 0.25), tool, {}).row, -1);
  EXPECT_EQ(find_closest_point(ContactPoints{}, tool, {}).row, -1);
  ContactPoints inner = points_above({0.9}, 0.25);
  Kokkos::deep_copy(inner.area, Real(0)); // inside of its body
  EXPECT_EQ(find_closest_point(inner, tool, {}).row, -1);
}

} // namespace swarf
