// Temperatures that are handed on, and what idling makes of them: a slab, insulated on both faces, in which
// the cosine over its thickness L decays with alpha (pi / L)^2 (Carslaw & Jaeger 1959, ch. 3).
#include "src/output/tool_heat_file.hpp"
#include "src/tool/cells.hpp"
#include "swarf/kernels.hpp"
#include "tests/support/temporary_folder.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace swarf;

namespace {

constexpr double side = 160e-6, edge = 5e-6, alpha = 46 / (15000.0 * 203), mean = 400, amplitude = 100;

// A cube of equal cells.
ToolHeat make_slab(double thickness) {
  FacetSurface box;
  for (int v = 0; v < 8; ++v)
    box.vertices.push_back({v & 1 ? thickness : 0, v & 2 ? side : 0, v & 4 ? side / 8 : 0});
  box.facets = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  ToolDeck deck;
  deck.temperature = 300;
  HeatPlan plan;
  plan.material.density = 15000, plan.material.specific_heat = 203, plan.material.conductivity = 46;
  plan.finest = edge, plan.reach = 4 * edge;
  plan.distance_to_work = [](const Eigen::Vector3d&) { return 0.0; };
  return build_tool_heat(build_tool(box, deck, 2 * edge), box, deck, plan);
}

void set_cosine(const ToolHeat& heat) {
  const auto T = host_copy(heat.temperature);
  const auto centre = host_copy(heat.centre);
  for (int c = 0; c < heat.cells; ++c)
    T(c) = Real(mean + amplitude * std::cos(std::numbers::pi * double(centre(c, 0)) / side));
  Kokkos::deep_copy(heat.temperature, T);
}

std::string fault_of(const std::filesystem::path& file, const std::string& tool, const ToolHeat& heat) {
  return message_of<ResultsError>([&] { read_tool_heat(file, tool, heat); });
}

} // namespace

TEST(ToolIdles, AsASlabWithTheTemperaturesOfTheRunBefore) {
  const TemporaryFolder folder;
  const ToolHeat before = make_slab(side), after = make_slab(side);
  set_cosine(before);
  write_tool_heat(folder / "tool_heat.h5", "a slab", before);
  read_tool_heat(folder / "tool_heat.h5", "a slab", after);
  const auto kept = host_copy(before.temperature), read = host_copy(after.temperature);
  for (int c = 0; c < before.cells; ++c) ASSERT_EQ(kept(c), read(c));

  const double stored = double(sum_heat(after).tool), time = 100e-6;
  idle_tool(after, time, double(stable_heat_step(after)));
  EXPECT_NEAR(double(sum_heat(after).tool) / stored, 1, sizeof(Real) == 8 ? 1e-12 : 1e-5);
  const double left = amplitude * std::exp(-alpha * std::pow(std::numbers::pi / side, 2) * time);
  EXPECT_LT(left, 0.6 * amplitude);
  const auto T = host_copy(after.temperature);
  const auto centre = host_copy(after.centre);
  double worst = 0;
  for (int c = 0; c < after.cells; ++c) {
    const double exact = mean + left * std::cos(std::numbers::pi * double(centre(c, 0)) / side);
    worst = std::max(worst, std::abs(double(T(c)) - exact) / left);
  }
  EXPECT_LT(worst, 0.002); // 32 cells over L: second order, (pi / 32)^2 / 12 * alpha (pi / L)^2 t = 5e-4
}

TEST(ToolIdles, RefusesWhatIsOfAnotherTool) {
  const TemporaryFolder folder;
  const ToolHeat heat = make_slab(side), other = make_slab(1.5 * side);
  write_tool_heat(folder / "tool_heat.h5", "a slab", heat);
  EXPECT_EQ(fault_of(folder / "tool_heat.h5", "a slab", heat), "");
  EXPECT_NE(fault_of(folder / "nothing.h5", "a slab", heat).find("is not there, so tool.temperature_from"),
            std::string::npos);
  EXPECT_NE(fault_of(folder / "tool_heat.h5", "a wedge", heat).find("another tool or material"),
            std::string::npos);
  EXPECT_NE(fault_of(folder / "tool_heat.h5", "a slab", other).find("laid out otherwise"), std::string::npos);
}
