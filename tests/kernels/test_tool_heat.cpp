// The pure functions of heat between work and tool.
#include "support/materials.hpp"
#include "support/tool_bar.hpp"
#include <gtest/gtest.h>

namespace swarf {
namespace {

// Steady: the interface takes the mean of both temperatures, weighted by the conductances, and what is made
// there goes each way by them.
TEST(ToolHeat, FlowsThroughResistancesInSeries) {
  const HeatContact at{500, 300, 2, 3, 1e30};
  EXPECT_NEAR(heat_into_tool(at, 0, 0.1), 0.1 * 200 / 5, test::round_off * 10);
  EXPECT_NEAR(heat_into_tool(at, 10, 0), 10 * 2.0 / 5, test::round_off * 10);
  EXPECT_NEAR(heat_into_tool(at, 10, 0.1), 4 + 4, test::round_off * 10);
}

// With no resistance at all the work ends at the tool's temperature, however long the step.
TEST(ToolHeat, DoesNotOvershoot) {
  for (const Real dt : {Real(1), Real(1000)}) {
    const HeatContact at{500, 300, 0, Real(1e-6), 2};
    const Real q = heat_into_tool(at, 7, dt);
    EXPECT_NEAR((500 + (7 - q) / 2 - 300) / 200, 0, 1e-4);
  }
}

TEST(ToolHeat, TreeFindsTheCellOfAPoint) {
  const ToolHeat t = test::make_tool_bar(5);
  for (int c = 0; c < t.cells; ++c)
    for (const Real z : {Real(-1e3), Real(0), Real(9)}) {
      EXPECT_EQ(find_tool_cell(t, {Real(c) + Real(0.01), Real(0.5), z}), c);
      EXPECT_EQ(find_tool_cell(t, {Real(c) + Real(0.99), Real(0.5), z}), c);
    }
  EXPECT_EQ(find_tool_cell(t, {-5, Real(0.5), 0}), 0); // beyond: the nearest at the rim
  EXPECT_EQ(find_tool_cell(t, {1000, Real(0.5), 0}), t.cells - 1);
}

} // namespace
} // namespace swarf
