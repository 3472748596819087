// The patches of the tool's surface: they cover it, fit together, and are found again.
#include "src/tool/surface.hpp"
#include "swarf/kernels.hpp"
#include "swarf/tool/signed_distance.hpp"
#include "tests/src/scene_decks.hpp"
#include "tests/support/temporary_folder.hpp"
#include <gtest/gtest.h>
#include <map>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double finest = 5 * um;

// The work comes to the point of the tool that is given.
struct Case {
  FacetSurface surface;
  ToolDeck deck;
  Eigen::Vector3d work;
};

Case mill() {
  ToolDeck deck = paper_mill();
  return {make_end_mill(deck), deck, {0, 400 * um, 50 * um}};
}
Case wedge() {
  ToolDeck deck(ToolKind::wedge);
  deck.rake = 15 * degree, deck.clearance = 2 * degree, deck.edge_radius = 20 * um;
  deck.width = 60 * um, deck.height = 300 * um;
  return {make_wedge(deck), deck, {0, 0, 0}};
}
Case stl(const TemporaryFolder& folder) {
  Case c = wedge();
  write_stl(c.surface, folder / "wedge.stl");
  c.surface = read_stl(folder / "wedge.stl", 1), c.deck.kind = ToolKind::stl;
  return c;
}

ToolSurface patches_of(const Case& c) {
  return build_tool_surface(c.surface,
                            {finest, [&](const Eigen::Vector3d& x) { return (x - c.work).norm(); }});
}

using Corner = std::array<float, 3>; // of a float's precision: corners are the same points

template <class Corners>
Corner corner_of(const Corners& all, int p, int k) {
  return {float(all(p, k, 0)), float(all(p, k, 1)), float(all(p, k, 2))};
}

void look_at(const Case& c) {
  const ToolSurface s = patches_of(c);
  const auto corner = host_copy(s.corner);
  const auto area = host_copy(s.area);
  double whole = 0, sum = 0, longest = 0;
  for (const auto& f : c.surface.facets) {
    const auto at = [&](int k) { return Eigen::Map<const Eigen::Vector3d>(c.surface.vertices[f[k]].data()); };
    whole += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
  }
  std::map<std::pair<Corner, Corner>, int> edges;
  for (int p = 0; p < s.patches; ++p) {
    sum += double(area(p));
    Eigen::Vector3d x[3];
    for (int k = 0; k < 3; ++k)
      x[k] = {double(corner(p, k, 0)), double(corner(p, k, 1)), double(corner(p, k, 2))};
    const Eigen::Vector3d middle = (x[0] + x[1] + x[2]) / 3;
    for (int k = 0; k < 3; ++k) {
      ++edges[{corner_of(corner, p, k), corner_of(corner, p, (k + 1) % 3)}];
      if ((middle - c.work).norm() < 4 * finest) longest = std::max(longest, (x[(k + 1) % 3] - x[k]).norm());
    }
  }
  EXPECT_GT(s.patches, int(c.surface.facets.size()));
  EXPECT_NEAR(sum / whole, 1, 1e-9);
  EXPECT_LE(longest, 2 * finest * (1 + 1e-9)) << "near the work";
  for (const auto& [edge, count] : edges) { // no corner lies within a neighbour's edge
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

// What the contact does: the nearest facet, and the patch there.
void find_all(const Case& c) {
  const ToolSurface s = patches_of(c);
  const Tool tool = build_tool(c.surface, c.deck, 2 * finest);
  const auto corner = host_copy(s.corner);
  const View<int*> found("found", s.patches);
  Kokkos::parallel_for(
      "find_patches", Range(0, s.patches), KOKKOS_LAMBDA(int p) {
        Vector3 x{0, 0, 0};
        for (int k = 0; k < 3; ++k)
          x = x + Real(1.0 / 3) * Vector3{s.corner(p, k, 0), s.corner(p, k, 1), s.corner(p, k, 2)};
        const ToolDistance at = signed_distance(tool, x);
        const Triangle t = load_facet(tool, at.facet);
        found(p) = find_patch(s, at.facet, barycentric(t.a, t.b, t.c, at.point));
      });
  const auto host = host_copy(found);
  int wrong = 0;
  for (int p = 0; p < s.patches; ++p) wrong += host(p) != p ? 1 : 0;
  EXPECT_EQ(wrong, 0) << "of " << s.patches;
}

} // namespace

TEST(ToolPatches, CoverTheSurfaceAndFitTogether) {
  const TemporaryFolder folder;
  for (const Case& c : {mill(), wedge(), stl(folder)}) look_at(c);
}

TEST(ToolPatches, AreFoundByTheContact) {
  const TemporaryFolder folder;
  for (const Case& c : {mill(), wedge(), stl(folder)}) find_all(c);
}

// 1 N s on the smallest patch of the edge, near the work: the sum is kept, and spread over half a circle of a
// spacing's radius at least.
TEST(ToolPatches, SpreadAPointOverItsFace) {
  for (const Case& c : {mill(), wedge()}) {
    const ToolSurface s = patches_of(c);
    const auto area = host_copy(s.area);
    const auto corner = host_copy(s.corner);
    int smallest = -1;
    for (int p = 0; p < s.patches; ++p) {
      Eigen::Vector3d middle(0, 0, 0);
      for (int k = 0; k < 3; ++k)
        middle +=
            Eigen::Vector3d{double(corner(p, k, 0)), double(corner(p, k, 1)), double(corner(p, k, 2))} / 3;
      const bool near = (middle - c.work).norm() < 6 * finest;
      if (near && (smallest < 0 || area(p) < area(smallest))) smallest = p;
    }
    ASSERT_GE(smallest, 0);
    const auto sums = host_copy(s.sums);
    sums(smallest, sum_impulse) = 1;
    Kokkos::deep_copy(s.sums, sums);
    Tool tool;
    tool.surface = s;
    const auto shown = host_copy(show_tool_surface(tool, 1));
    const double circle = 3.14159 * finest * finest;
    double sum = 0, most = 0;
    for (int p = 0; p < s.patches; ++p)
      sum += double(shown(p, shown_pressure) * area(p)),
          most = std::max(most, double(shown(p, shown_pressure)));
    EXPECT_NEAR(sum, 1, 1e-9);
    EXPECT_LT(most, 2 / circle) << "of " << 1 / double(area(smallest)) << " on the patch alone";
  }
}
