// What the patches of the tool's surface feel in a cut is what the history has.
#include "src/simulation/simulation.hpp"
#include "tests/support/small_deck.hpp"
#include "tests/support/temporary_folder.hpp"
#include <cmath>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;

// What friction has done since the start is on the patches; the force that they feel is no less than that on
// the tool.
TEST(ToolPatches, KeepTheBooksOfACut) {
  const TemporaryFolder folder;
  Simulation s(read_deck(folder.write("deck.toml", small_deck)));
  s.start();
  double impulse = 0, friction = 0, force = 0;
  const auto area = host_copy(s.scene().tool.surface.area);
  double last = 0;
  while (s.time() < 14e-6) {
    s.step();
    if (s.steps_to_check() > 0) continue;
    s.check();
    const HistorySample sample = s.take_sample();
    force += std::hypot(sample.force[0], sample.force[1]) * (sample.time - last);
    const ToolFields f = s.take_tool_fields();
    for (std::size_t p = 0; p < f.contact_pressure.size(); ++p) {
      const double share = double(area(int(p))) * (sample.time - last);
      impulse += double(f.contact_pressure[p]) * share, friction += double(f.friction_power[p]) * share;
    }
    last = sample.time;
    if (sample.frictional > 0) {
      EXPECT_NEAR(friction / sample.frictional, 1, 1e-5); // frames are of float
    }
  }
  EXPECT_GT(force, 0);
  EXPECT_GE(impulse, 0.85 * force); // the normal part of it, under Coulomb's 0.5: 1 / sqrt(1.25) = 0.89
}
