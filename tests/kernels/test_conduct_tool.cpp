#include "support/materials.hpp"
#include "support/tool_bar.hpp"
#include "swarf/kernels.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace swarf {
namespace {

const double pi = std::acos(-1.0);

// An insulated bar of n cells: cos(pi x / L) decays as exp(-alpha (pi / L)^2 t). Error after a decay to 1 /
// e.
double decay_error(int levels) {
  const ToolHeat t = test::make_tool_bar(levels);
  const auto T = host_copy(t.temperature);
  const double rate = std::pow(pi / t.cells, 2), end = 1 / rate;
  for (int c = 0; c < t.cells; ++c) T(c) = Real(std::cos(pi * (c + 0.5) / t.cells));
  Kokkos::deep_copy(t.temperature, T);
  const int steps = int(std::ceil(end / (0.1 * double(stable_heat_step(t)))));
  for (int k = 0; k < steps; ++k) conduct_tool(t, Real(end / steps));
  Kokkos::deep_copy(T, t.temperature);
  double error = 0;
  for (int c = 0; c < t.cells; ++c)
    error = std::max(error, std::abs(double(T(c)) - std::exp(-1.0) * std::cos(pi * (c + 0.5) / t.cells)));
  return error / std::exp(-1.0);
}

TEST(ConductTool, SlabDecaysAsTheoryHasItToSecondOrder) {
  const double coarse = decay_error(3), fine = decay_error(5);
  EXPECT_LT(fine, 2e-3);
  EXPECT_NEAR(std::log2(coarse / fine) / 2, 2, sizeof(Real) == 8 ? 0.1 : 0.5);
}

TEST(ConductTool, HeatIsKeptToRoundOff) {
  const ToolHeat t = test::make_tool_bar(6);
  const auto T = host_copy(t.temperature);
  for (int c = 0; c < t.cells; ++c) T(c) = Real(300 + (c * 37) % 100);
  Kokkos::deep_copy(t.temperature, T);
  const double before = double(sum_heat(t).tool);
  for (int k = 0; k < 100; ++k) conduct_tool(t, stable_heat_step(t));
  EXPECT_NEAR(double(sum_heat(t).tool) / before, 1, test::round_off);
  Kokkos::deep_copy(T, t.temperature);
  for (int c = 0; c < t.cells; ++c)
    EXPECT_TRUE(T(c) >= 300 && T(c) <= 400) << c; // monotone at the stable step
}

// A held end stays, and what flows into it is booked: steady flow along the bar.
TEST(ConductTool, HeldCellsTakeHeatOut) {
  ToolHeat t = test::make_tool_bar(3);
  test::hold_cell(t, 0);
  Kokkos::deep_copy(t.temperature, Real(10));
  const auto T = host_copy(t.temperature);
  T(0) = 0;
  Kokkos::deep_copy(t.temperature, T);
  const HeatSums before = sum_heat(t);
  for (int k = 0; k < 2000; ++k) conduct_tool(t, stable_heat_step(t));
  const HeatSums after = sum_heat(t);
  EXPECT_NEAR(double(after.tool + after.out), double(before.tool), test::round_off * 1e3);
  EXPECT_NEAR(double(after.out), 70, 1e-3); // all of the seven free cells' heat, in the end
  EXPECT_EQ(host_copy(t.temperature)(0), 0);
}

} // namespace
} // namespace swarf
