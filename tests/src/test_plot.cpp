#include "src/output/history.hpp"
#include "src/plots/display.hpp"
#include "src/plots/plot.hpp"
#include "support/pixels.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace fs = std::filesystem;
using namespace swarf;
using ::testing::HasSubstr;

namespace {

// A milling force with noise: planar resultant 2.5 N sin(phi), about 4 kHz of noise at 3 us per degree.
ResultsFolder write_history(const fs::path& folder, bool spindle) {
  const ResultsFolder results = create_results(folder);
  HistoryFile file(results.history(), 2);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.35);
  double work = 0;
  for (int i = 0; i <= 3000; ++i) {
    HistorySample s;
    const double phi = 0.06 * i * M_PI / 180, force = 2.5 * std::sin(phi);
    s.time = 1e-6 * i, s.immersion = spindle ? 0.06 * i : 0;
    s.force = {-force * std::cos(phi) + noise(random), force * std::sin(phi) + noise(random),
               0.3 * force + noise(random)};
    work += force * 0.42 * 1e-6;
    s.external = work, s.plastic = 0.7 * work, s.frictional = 0.2 * work, s.elastic = 0.03 * work;
    s.kinetic = 1e-8, s.viscous = 0.04 * work, s.residual = -0.004 * work;
    file.append(s);
  }
  return results;
}

} // namespace

TEST(Plot, forces_show_each_component_over_the_immersion) {
  if (const std::string why_not = open_display(); !why_not.empty()) GTEST_SKIP() << why_not;
  const TemporaryFolder folder;
  const auto results = write_history(folder / "run", true);
  const fs::path png = std::getenv("SWARF_KEEP_PICTURES")
                           ? fs::path(std::getenv("SWARF_KEEP_PICTURES")) / "forces.png"
                           : folder / "forces.png";
  plot_forces(results, png, {{"measured", 10.5}, {"simulated SPH-FE", 10.1}, {"mechanistic", 9.4}}, 2e4);
  const Pixels pixels(png);
  // A curve 3 pixels thick across most of 1600 pixels, for each colour of the legend.
  EXPECT_GT(pixels.count(0, 114, 178), 3000);
  EXPECT_GT(pixels.count(213, 94, 0), 3000);
  EXPECT_GT(pixels.count(0, 158, 115), 3000);
  EXPECT_GT(pixels.count(255, 255, 255), 1000000); // white paper
}

TEST(Plot, energies_over_time) {
  if (const std::string why_not = open_display(); !why_not.empty()) GTEST_SKIP() << why_not;
  const TemporaryFolder folder;
  const auto results = write_history(folder / "run", false);
  const fs::path png = std::getenv("SWARF_KEEP_PICTURES")
                           ? fs::path(std::getenv("SWARF_KEEP_PICTURES")) / "energies.png"
                           : folder / "energies.png";
  plot_energies(results, png);
  EXPECT_GT(Pixels(png).count(213, 94, 0), 3000);
}

TEST(Plot, too_short_a_run_is_an_error) {
  if (const std::string why_not = open_display(); !why_not.empty()) GTEST_SKIP() << why_not;
  const TemporaryFolder folder;
  const auto results = create_results(folder / "run");
  { HistoryFile file(results.history(), 2); }
  EXPECT_THAT(message_of<ResultsError>([&] { plot_forces(results, folder / "f.png", {}, 0); }),
              HasSubstr("has 0 samples, a curve needs two"));
}
