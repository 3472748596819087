#include "support/box_tool.hpp"
#include "support/materials.hpp"
#include "swarf/kernels.hpp"
#include <gtest/gtest.h>
#include <random>

namespace swarf {
namespace {

constexpr int points = 5000, patches = 40;

ToolSurface make_surface() {
  ToolSurface s;
  s.patches = patches;
  s.sums = View<Real* [surface_sums]>("sums", patches);
  s.first = IndexField("first", patches + 1), s.source = IndexField("source", points);
  return s;
}

ContactPoints bring() {
  ContactPoints p = test::make_contact_points(points, 1);
  p.on_tool = View<Real* [surface_sums]>("on_tool", points);
  p.tool_patch = IndexField("tool_patch", points);
  const auto sums = host_copy(p.on_tool);
  const auto patch = host_copy(p.tool_patch);
  std::mt19937 random(5);
  std::uniform_real_distribution<Real> uniform(0, 1);
  for (int i = 0; i < points; ++i) {
    patch(i) = int(random() % unsigned(patches - 1)); // none on the last
    for (int q = 0; q < surface_sums; ++q) sums(i, q) = i % 3 ? uniform(random) : Real(0);
    if (i % 3 == 1) sums(i, sum_impulse) = 0; // has parted: leaves its friction only
  }
  Kokkos::deep_copy(p.on_tool, sums), Kokkos::deep_copy(p.tool_patch, patch);
  return p;
}

// Each patch gets the sums of its points in the order of their rows, bit by bit; and nothing a second time.
TEST(GatherToolSurface, SumsPointsInOrder) {
  const ToolSurface s = make_surface();
  const ContactPoints p = bring();
  const auto brought = host_copy(p.on_tool);
  const auto patch = host_copy(p.tool_patch);
  Real expected[patches][surface_sums] = {};
  for (int i = 0; i < points; ++i)
    for (int q = 0; q < surface_sums; ++q) expected[patch(i)][q] += brought(i, q);
  for (int time = 0; time < 2; ++time) {
    gather_tool_surface(p, s);
    const auto sums = host_copy(s.sums);
    for (int k = 0; k < patches; ++k)
      for (int q = 0; q < surface_sums; ++q) EXPECT_EQ(sums(k, q), expected[k][q]) << k << " " << q;
  }
}

// Halving the longest edge ab, then the longer half's: where a point of known coordinates belongs is clear.
TEST(FindPatch, DescendsToTheHalfOfTheNearerCorner) {
  ToolSurface s;
  s.tree = IndexField("tree", 5), s.halved = IndexField("halved", 5);
  const int tree[] = {1, -1, 3, -2, -3}, halved[] = {0, 0, 1, 0, 0};
  const auto t = host_copy(s.tree), h = host_copy(s.halved);
  for (int n = 0; n < 5; ++n) t(n) = tree[n], h(n) = halved[n];
  Kokkos::deep_copy(s.tree, t), Kokkos::deep_copy(s.halved, h);
  // Halves (a, m, c) and (m, b, c); the latter at bc: (b, k, m) and (k, c, m).
  EXPECT_EQ(find_patch(s, 0, {Real(0.5), Real(0.4), Real(0.1)}), 0);
  EXPECT_EQ(find_patch(s, 0, {Real(0.3), Real(0.55), Real(0.15)}), 1);
  EXPECT_EQ(find_patch(s, 0, {Real(0.1), Real(0.3), Real(0.6)}), 2);
}

TEST(FindPatch, BarycentricCoordinatesGiveThePointBack) {
  const Vector3 a{1, 2, 3}, b{4, 2, 1}, c{0, 5, 2};
  const Vector3 w = barycentric(a, b, c, Real(0.2) * a + Real(0.5) * b + Real(0.3) * c);
  EXPECT_NEAR(w.x, 0.2, test::round_off);
  EXPECT_NEAR(w.y, 0.5, test::round_off);
  EXPECT_NEAR(w.z, 0.3, test::round_off);
}

} // namespace
} // namespace swarf
