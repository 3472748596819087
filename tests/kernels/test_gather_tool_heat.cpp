#include "support/box_tool.hpp"
#include "support/tool_bar.hpp"
#include "swarf/kernels.hpp"
#include <gtest/gtest.h>
#include <random>

namespace swarf {
namespace {

ContactPoints bring(int points, int cells) {
  ContactPoints p = test::make_contact_points(points, 1);
  p.heat_to_tool = ScalarField("heat_to_tool", std::size_t(points));
  p.tool_cell = IndexField("tool_cell", std::size_t(points));
  const auto heat = host_copy(p.heat_to_tool);
  const auto cell = host_copy(p.tool_cell);
  std::mt19937 random(3);
  std::uniform_real_distribution<Real> uniform(-1, 2);
  for (int i = 0; i < points; ++i)
    heat(i) = i % 3 ? uniform(random) : Real(0), cell(i) = int(random() % unsigned(cells));
  Kokkos::deep_copy(p.heat_to_tool, heat), Kokkos::deep_copy(p.tool_cell, cell);
  return p;
}

// Each cell gets the sum of its points in the order of their rows, bit by bit; and nothing a second time.
TEST(GatherToolHeat, SumsPointsInOrder) {
  const int points = 5000;
  const ToolHeat t = test::make_tool_bar(4, points);
  const ContactPoints p = bring(points, t.cells);
  const auto heat = host_copy(p.heat_to_tool);
  const auto cell = host_copy(p.tool_cell);
  std::vector<Real> expected(std::size_t(t.cells), 0);
  for (int i = 0; i < points; ++i) expected[std::size_t(cell(i))] += heat(i);
  for (int time = 0; time < 2; ++time) {
    gather_tool_heat(p, t);
    const auto T = host_copy(t.temperature);
    for (int c = 0; c < t.cells; ++c) EXPECT_EQ(T(c), expected[std::size_t(c)]) << c;
  }
}

TEST(GatherToolHeat, HeldCellsStayAndBookIt) {
  ToolHeat t = test::make_tool_bar(2, 100);
  test::hold_cell(t, 1);
  const ContactPoints p = bring(100, t.cells);
  const auto heat = host_copy(p.heat_to_tool);
  const auto cell = host_copy(p.tool_cell);
  Real expected = 0;
  for (int i = 0; i < 100; ++i) expected += cell(i) == 1 ? heat(i) : Real(0);
  gather_tool_heat(p, t);
  EXPECT_EQ(host_copy(t.temperature)(1), 0);
  EXPECT_EQ(host_copy(t.out)(1), expected);
}

} // namespace
} // namespace swarf
