// The tool's cells of heat: their volume, and conduction between them where the surface cuts them.
#include "src/tool/cells.hpp"
#include "swarf/kernels.hpp"
#include "tests/src/scene_decks.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace swarf {
namespace {

constexpr double side = 1e-3, width = 0.1e-3, alpha = 46 / (15000.0 * 203);

MaterialDeck carbide() {
  MaterialDeck m(Law::rigid);
  m.name = "carbide", m.density = 15000, m.specific_heat = 203, m.conductivity = 46;
  return m;
}

double volume_of(const FacetSurface& surface) {
  double six = 0;
  for (const auto& f : surface.facets) {
    const Triple &a = surface.vertices[f[0]], &b = surface.vertices[f[1]], &c = surface.vertices[f[2]];
    six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return six / 6;
}

// Of equal cells, wherever the work comes.
ToolHeat cells_of(const FacetSurface& surface, double edge, std::optional<std::array<double, 2>> slice) {
  ToolDeck deck;
  deck.temperature = 300;
  HeatPlan plan;
  plan.material = carbide(), plan.finest = edge, plan.reach = 4 * edge, plan.slice = slice;
  plan.distance_to_work = [](const Point&) { return 0.0; };
  return build_tool_heat(build_tool(surface, deck, 2 * edge), surface, deck, plan);
}

double volume_of(const ToolHeat& heat) { return test::sum(heat.capacity, heat.cells) / (15000.0 * 203); }

// A right-angled wedge with equal legs, turned so that all its faces cut the cells.
constexpr double turned = 0.35;
FacetSurface right_wedge() {
  FacetSurface s;
  for (const double z : {-width, width})
    for (const auto& [u, v] : {std::pair(0.0, 0.0), std::pair(side, 0.0), std::pair(0.0, side)})
      s.vertices.push_back(
          {u * std::cos(turned) - v * std::sin(turned), u * std::sin(turned) + v * std::cos(turned), z});
  s.facets = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  return s;
}

// Insulated faces: cos(pi u / L) - cos(pi v / L) is even about both legs and about the long face u + v = L,
// and decays with alpha (pi / L)^2.
double mode(double u, double v) { return std::cos(test::pi * u / side) - std::cos(test::pi * v / side); }

struct Error {
  double mean, largest; // over the amplitude that is left
};

Error decay(double edge) {
  const ToolHeat heat = cells_of(right_wedge(), edge, {{-width / 2, width / 2}});
  const auto centre = host_copy(heat.centre);
  const auto exact = [&](int c, double factor) {
    const double x = double(centre(c, 0)), y = double(centre(c, 1));
    const double u = x * std::cos(turned) + y * std::sin(turned),
                 v = y * std::cos(turned) - x * std::sin(turned);
    return factor * mode(u, v);
  };
  const auto T = host_copy(heat.temperature);
  for (int c = 0; c < heat.cells; ++c) T(c) = Real(exact(c, 1));
  Kokkos::deep_copy(heat.temperature, T);
  const double rate = alpha * std::pow(test::pi / side, 2), end = 1 / rate;
  const int steps = int(std::ceil(end / (0.25 * double(stable_heat_step(heat)))));
  for (int k = 0; k < steps; ++k) conduct_tool(heat, Real(end / steps));
  const auto now = host_copy(heat.temperature), C = host_copy(heat.capacity);
  Error error{0, 0};
  double whole = 0;
  for (int c = 0; c < heat.cells; ++c) {
    const double e = std::abs(double(now(c)) - exact(c, std::exp(-1.0))) / (2 * std::exp(-1.0));
    error.mean += double(C(c)) * e, whole += double(C(c)), error.largest = std::max(error.largest, e);
  }
  error.mean /= whole;
  return error;
}

// Exact where the surface is plane in each part of a cell; in parts with an edge the error is of second
// order.
TEST(ToolCells, HoldTheToolsVolume) {
  const FacetSurface wedge = right_wedge();
  EXPECT_NEAR(volume_of(cells_of(wedge, side / 20, {{-width / 2, width / 2}})) / (volume_of(wedge) / 2), 1,
              2e-3);
  EXPECT_NEAR(volume_of(cells_of(wedge, width / 2, std::nullopt)) / volume_of(wedge), 1, 5e-3);
  ToolDeck mill = test::paper_mill();
  const FacetSurface surface = make_end_mill(mill);
  EXPECT_NEAR(volume_of(cells_of(surface, 10e-6, std::nullopt)) / volume_of(surface), 1, 5e-3);
}

TEST(ToolCells, SharesOfABoxCutByAPlaneAreExact) {
  const Point cube(1, 1, 1);
  EXPECT_DOUBLE_EQ(share_of_box(0, Point(0.6, 0.8, 0), cube), 0.5);
  EXPECT_NEAR(share_of_box(-0.3, Point(1, 0, 0), cube), 0.8, 1e-12);
  EXPECT_NEAR(share_of_box(0.5 / std::sqrt(3.0), Point(1, 1, 1) / std::sqrt(3.0), cube), 1.0 / 6,
              1e-12); // a corner's tetrahedron
  EXPECT_NEAR(share_of_box(0.25 * std::sqrt(2.0), Point(1, 1, 0) / std::sqrt(2.0), Point(1, 1, 0)), 0.125,
              1e-12);
  double sum = 0; // against points, over directions
  for (const Point& n : {Point(0.36, 0.48, 0.8), Point(-0.8, 0.36, 0.48), Point(0.48, 0.8, -0.36)})
    for (const double d : {-0.4, -0.1, 0.3}) {
      int inside = 0;
      const int m = 60;
      for (int p = 0; p < m * m * m; ++p) {
        const Point x((p % m + 0.5) / m - 0.5, (p / m % m + 0.5) / m - 0.5, (p / m / m + 0.5) / m - 0.5);
        inside += d + n.dot(x) <= 0;
      }
      EXPECT_NEAR(share_of_box(d, n, cube), double(inside) / (m * m * m), 2e-3);
      sum += share_of_box(d, n, cube) + share_of_box(-d, -n, cube);
    }
  EXPECT_NEAR(sum, 9, 1e-12);
}

TEST(ToolCells, HeatDecaysInACutWedgeAsTheoryHasIt) {
  const Error coarse = decay(side / 16), middle = decay(side / 32), fine = decay(side / 64);
  std::printf("mean error %.3g %.3g %.3g, largest %.3g %.3g %.3g\n", coarse.mean, middle.mean, fine.mean,
              coarse.largest, middle.largest, fine.largest);
  EXPECT_LT(fine.mean, 0.005);
  EXPECT_GT(std::log2(coarse.mean / fine.mean) / 2, 1);
}

TEST(ToolCells, KeepTheirHeatToRoundOff) {
  const ToolHeat heat = cells_of(right_wedge(), side / 16, std::nullopt);
  const auto T = host_copy(heat.temperature);
  for (int c = 0; c < heat.cells; ++c) T(c) = Real(300 + (c * 37) % 100);
  Kokkos::deep_copy(heat.temperature, T);
  const double before = double(sum_heat(heat).tool);
  for (int k = 0; k < 50; ++k) conduct_tool(heat, stable_heat_step(heat));
  EXPECT_NEAR(double(sum_heat(heat).tool) / before, 1, sizeof(Real) == 8 ? 1e-12 : 1e-4);
}

// Everywhere on the surface a cell is found, and it is one whose centre lies near.
TEST(ToolCells, EveryPlaceOnTheSurfaceHasACell) {
  const FacetSurface surface = make_end_mill(test::paper_mill());
  const ToolHeat heat = cells_of(surface, 10e-6, std::nullopt);
  const auto depth = host_copy(heat.depth);
  for (const Triple& v : surface.vertices) {
    const int cell = find_tool_cell(heat, {Real(v[0]), Real(v[1]), Real(v[2])});
    ASSERT_GE(cell, 0);
    ASSERT_LT(cell, heat.cells);
    EXPECT_GT(depth(cell), 0);
  }
}

} // namespace
} // namespace swarf
