// A tool whose temperatures one run hands to the next: what it starts with, and what is refused.
#include "src/files/results.hpp"
#include "src/output/history.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/small_deck.hpp"
#include "tests/support/temporary_folder.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;
namespace fs = std::filesystem;

namespace {

Edits conducting(const std::string& tool_keys, const std::string& conductivity = "46") {
  const std::string carbide = fmt::format(
      "[material.wc]\nlaw = \"rigid\"\ndensity = \"15000 kg/m3\"\nspecific_heat = \"203 J/kg/K\"\n"
      "conductivity = \"{} W/m/K\"\n[[body]]\nname = \"cut zone\"",
      conductivity);
  return {{"[[body]]\nname = \"cut zone\"", carbide},
          {"[tool]\n", "[tool]\nmaterial = \"wc\"\n" + tool_keys}};
}

Ended run(const TemporaryFolder& folder, const std::string& name, const Edits& edits) {
  return run_program(run_arguments(folder.write(name + ".toml", edit_small_deck(edits)), folder / name));
}

std::string from(const fs::path& results) {
  return fmt::format("temperature_from = \"{}\"\n", results.string());
}

} // namespace

TEST(ToolHandedOn, StartsWarmAndWearsOn) {
  const TemporaryFolder folder;
  const std::string wear = "heat_time = \"100 us\"\nwear_A = \"1e-14 1/Pa\"\nwear_B = \"1000 K\"\n";
  const Ended cold = run(folder, "first", conducting(wear));
  ASSERT_EQ(cold.status, 0) << cold.output;
  ASSERT_TRUE(fs::exists(folder / "first" / "tool_heat.h5"));
  const Ended warm =
      run(folder, "second", conducting(wear + from(folder / "first") + "idle_time = \"10 us\"\n"));
  ASSERT_EQ(warm.status, 0) << warm.output;
  const HistoryTable before = read_history(folder / "first" / "history.csv"),
                     after = read_history(folder / "second" / "history.csv");
  const double start = before.at("tool_max_temperature").front(),
               hot = before.at("tool_max_temperature").back(),
               idled = after.at("tool_max_temperature").front();
  EXPECT_GT(hot, start + 10);
  EXPECT_GT(idled, start + 0.1) << "some of it is left";
  EXPECT_LT(idled, hot - 1) << "it has spread";
  EXPECT_GT(after.at("tool_max_temperature").back(), hot) << "the second tooth is hotter than the first";
  EXPECT_EQ(after.at("tool_heat").front(), 0);
  EXPECT_LT(std::abs(after.at("heat_residual").back()), 0.01 * after.at("plastic_heat").back());
  const std::string summary = read_text(folder / "second" / "summary.json");
  EXPECT_NE(summary.find("\"largest_depth\""), std::string::npos) << summary;
}

TEST(ToolHandedOn, RefusesWhatDoesNotFit) {
  const TemporaryFolder folder;
  const auto expect = [&](const Ended& end, const std::string& words) {
    EXPECT_EQ(end.status, 1) << end.output;
    EXPECT_NE(end.output.find(words), std::string::npos) << end.output;
  };
  ASSERT_EQ(run(folder, "first", conducting("")).status, 0);
  expect(run(folder, "nowhere", conducting(from(folder / "other"))),
         "is not there, so tool.temperature_from");
  expect(run(folder, "material", conducting(from(folder / "first"), "40")), "another tool or material");
  Edits other_edge = conducting(from(folder / "first"));
  other_edge.push_back({"edge_radius = \"6 um\"", "edge_radius = \"5 um\""});
  expect(run(folder, "edge", other_edge), "another tool or material");
  expect(run(folder, "longer", conducting("heat_time = \"1 ms\"\n" + from(folder / "first"))),
         "laid out otherwise");
  expect(run(folder, "idle", conducting("idle_time = \"1e6 s\"\n" + from(folder / "first"))),
         "tool.idle_time: makes");
}
