#include "support/hex_block.hpp"
#include "support/materials.hpp"
#include "support/particle_block.hpp"
#include "support/tool_bar.hpp"
#include "swarf/kernels.hpp"
#include <gtest/gtest.h>

namespace swarf {
namespace {

const Material mat = test::ti64();

// m c (T - reference) of all rows, active or not, the tied among them; the share of the plastic work that
// heats.
TEST(SumHeat, OfParticles) {
  Particles p;
  p.count = 3, p.stored = p.total = p.points.count = 3001;
  test::allocate(p, p.stored);
  p.heat_to_tool = ScalarField("heat_to_tool", std::size_t(p.stored));
  Kokkos::deep_copy(p.points.mass, Real(2)), Kokkos::deep_copy(p.points.temperature, Real(310));
  Kokkos::deep_copy(p.points.plastic_work, Real(4)), Kokkos::deep_copy(p.heat_to_tool, Real(0.5));
  const HeatSums s = sum_heat(p, test::make_material_table({mat}), 300);
  EXPECT_NEAR(double(s.work) / (3001 * 2 * 526.3 * 10), 1, test::round_off);
  EXPECT_NEAR(double(s.plastic) / (3001 * 0.9 * 4), 1, test::round_off);
  EXPECT_NEAR(double(s.tool) / 1500.5, 1, test::round_off);
}

TEST(SumHeat, OfHexesWithWhatTheContactHasBrought) {
  HexMesh m = test::make_hex_block({3, 2, 2}, mat, 0.1);
  m.contact_heat = ScalarField("contact_heat", std::size_t(m.nodes));
  Kokkos::deep_copy(m.points.temperature, Real(305)), Kokkos::deep_copy(m.contact_heat, Real(7));
  const HeatSums s = sum_heat(m, test::make_material_table({mat}), 300);
  EXPECT_NEAR(double(s.work) / (12 * 1e-3 * 4430 * 526.3 * 5 + 36 * 7), 1, test::round_off);
  EXPECT_EQ(s.tool, 0);
}

TEST(SumHeat, OfTheTool) {
  ToolHeat t = test::make_tool_bar(3);
  t.start_temperature = 20;
  test::hold_cell(t, 2);
  Kokkos::deep_copy(t.temperature, Real(23)), Kokkos::deep_copy(t.out, Real(1.5));
  const HeatSums s = sum_heat(t);
  EXPECT_NEAR(double(s.tool), 7 * 3, test::round_off * 21);
  EXPECT_NEAR(double(s.out), 8 * 1.5, test::round_off * 12);
}

} // namespace
} // namespace swarf
