#include "swarf/tool/signed_distance.hpp"

#include "support/box_tool.hpp"
#include "support/materials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace swarf {
namespace {

constexpr double a = 3e-4, b = 2e-4, c = 1e-4; // half sides of the box, m

std::vector<ToolDistance> query(const Tool& tool, const std::vector<Vector3>& points) {
  const int n = int(points.size());
  const View<Vector3*> x("x", n);
  const View<ToolDistance*> result("result", n);
  const auto host = Kokkos::create_mirror_view(x);
  for (int i = 0; i < n; ++i) host(i) = points[i];
  Kokkos::deep_copy(x, host);
  Kokkos::parallel_for(
      "query", Range(0, n), KOKKOS_LAMBDA(const int i) { result(i) = signed_distance(tool, x(i)); });
  const auto out = host_copy(result);
  return {out.data(), out.data() + n};
}

// Signed distance of a box: Hart, The Visual Computer 12 (1996) 527, and its gradient outside.
double box_distance(const Vector3& x) {
  const double q[3] = {std::abs(double(x.x)) - a, std::abs(double(x.y)) - b, std::abs(double(x.z)) - c};
  const double outside = std::hypot(std::max(q[0], 0.0), std::max(q[1], 0.0), std::max(q[2], 0.0));
  return outside + std::min(std::max({q[0], q[1], q[2]}), 0.0);
}

TEST(SignedDistance, OfABoxIsTheClosedForm) {
  const Tool tool = test::make_box_tool({a, b, c}, a);
  std::mt19937 generator(7);
  std::uniform_real_distribution<Real> uniform(Real(-1.9 * a), Real(1.9 * a));
  std::vector<Vector3> points(20000);
  for (Vector3& x : points) x = {uniform(generator), uniform(generator), uniform(generator)};
  const auto found = query(tool, points);
  int inside = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double exact = box_distance(points[i]);
    ASSERT_EQ(found[i].where, ToolDistance::Where::near);
    ASSERT_NEAR(found[i].distance, exact, 10 * test::round_off * a);
    // The normal points along the shortest way: one step of the distance along it leads to the surface.
    const Vector3 foot = points[i] - found[i].distance * found[i].normal;
    ASSERT_NEAR(norm(foot - found[i].point), 0, 10 * test::round_off * a);
    ASSERT_NEAR(norm(found[i].normal), 1, 10 * test::round_off);
    inside += exact < 0;
  }
  EXPECT_GT(inside, 500);
}

TEST(SignedDistance, OnFaceEdgeAndCornerHasAUnitNormal) {
  const Tool tool = test::make_box_tool({a, b, c}, a);
  const Real A = Real(a), B = Real(b), C = Real(c);
  const double half = std::sqrt(0.5), third = std::sqrt(1.0 / 3);
  const auto found = query(tool, {{A, 0, C / 3}, {A, B, C / 3}, {-A, -B, C}});
  const Vector3 expected[] = {
      {1, 0, 0}, {Real(half), Real(half), 0}, {Real(-third), Real(-third), Real(third)}};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(found[i].distance, 0, test::round_off * a);
    EXPECT_NEAR(norm(found[i].normal - expected[i]), 0, 1e3 * test::round_off) << i;
  }
}

TEST(SignedDistance, KnowsAllSevenFeaturesOfATriangle) {
  const Triangle t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::pair<Vector3, NearestOnTriangle>> cases = {
      {{Real(0.25), Real(0.25), 2}, {{Real(0.25), Real(0.25), 0}, 0}}, // face
      {{Real(0.5), -1, 1}, {{Real(0.5), 0, 0}, 1}},                    // edge 01
      {{1, 1, -1}, {{Real(0.5), Real(0.5), 0}, 2}},                    // edge 12
      {{-1, Real(0.25), 1}, {{0, Real(0.25), 0}, 3}},                  // edge 20
      {{-1, -1, 1}, {{0, 0, 0}, 4}},                                   // corners
      {{3, 0, 0}, {{1, 0, 0}, 5}},
      {{-1, 3, 0}, {{0, 1, 0}, 6}}};
  for (const auto& [x, expected] : cases) {
    const NearestOnTriangle found = nearest_on_triangle(t, x);
    EXPECT_EQ(found.feature, expected.feature);
    EXPECT_EQ(norm(found.point - expected.point), 0);
  }
}

TEST(SignedDistance, OutsideTheGridIsFarAndNothingOverflows) {
  const Tool tool = test::make_box_tool({a, b, c}, a);
  const Real huge = std::numeric_limits<Real>::max(), nan = std::numeric_limits<Real>::quiet_NaN();
  for (const ToolDistance& d : query(tool, {{1, 0, 0}, {-1, 0, 0}, {huge, 0, 0}, {0, -huge, 0}, {nan, 0, 0}}))
    EXPECT_EQ(d.where, ToolDistance::Where::outside);
}

TEST(SignedDistance, CellsWithoutFacetsSayOutsideOrDeepInside) {
  Tool tool = test::make_box_tool({a, b, c}, a);
  tool.cell_start = IndexField("cell_start", 2);
  EXPECT_EQ(query(tool, {{0, 0, 0}})[0].where, ToolDistance::Where::outside);
  const auto start = Kokkos::create_mirror_view(tool.cell_start);
  start(0) = 0, start(1) = 1;
  Kokkos::deep_copy(tool.cell_start, start);
  Kokkos::deep_copy(tool.cell_facet, Tool::deep_inside);
  EXPECT_EQ(query(tool, {{0, 0, 0}})[0].where, ToolDistance::Where::deep_inside);
}

TEST(ToolFrame, TurnsCounterClockwiseAndBack) {
  ToolPose pose;
  pose.position = {1, 2, 3}, pose.angle = Kokkos::numbers::pi_v<Real> / 2;
  const ToolFrame frame = make_frame(pose);
  const Vector3 world = direction_to_world(frame, {1, 0, 0}); // +x of the tool is +y of the world
  EXPECT_NEAR(norm(world - Vector3{0, 1, 0}), 0, test::round_off);
  const Vector3 local = to_tool(frame, {1, 7, 3});
  EXPECT_NEAR(norm(local - Vector3{5, 0, 0}), 0, 10 * test::round_off);
}

TEST(ToolFrame, SurfaceVelocityIsOneVectorOfFeedAndRotation) {
  ToolPose pose;
  pose.position = {1, 0, 0}, pose.velocity = {5, 6, 7}, pose.angular_velocity = 2;
  const Vector3 v = surface_velocity(pose, {1, 3, 4}); // omega x r = 2 e_z x 3 e_y = -6 e_x
  EXPECT_NEAR(norm(v - Vector3{-1, 6, 7}), 0, test::round_off);
}

TEST(Tooth, IsTheOneNearestInAngleAndFollowsTheHelix) {
  Tool tool;
  tool.teeth = 4, tool.twist = 1;
  EXPECT_EQ(tooth_of(tool, {Real(0.1), 1, 0}), 0); // a little before the edge, in the flute
  EXPECT_EQ(tooth_of(tool, {Real(-0.1), 1, 0}), 0);
  EXPECT_EQ(tooth_of(tool, {-1, 0, 0}), 1); // counter-clockwise
  EXPECT_EQ(tooth_of(tool, {0, -1, 0}), 2);
  EXPECT_EQ(tooth_of(tool, {1, 0, 0}), 3);
  const Real quarter = Kokkos::numbers::pi_v<Real> / 2; // the edge of tooth 0 has turned to -x here
  EXPECT_EQ(tooth_of(tool, {-1, 0, quarter}), 0);
  EXPECT_EQ(tooth_of(tool, {0, 1, quarter}), 3);
}

} // namespace
} // namespace swarf
