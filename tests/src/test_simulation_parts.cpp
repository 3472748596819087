// The parts of a run beside its step, by themselves.
#include "src/simulation/parts.hpp"
#include <gtest/gtest.h>
#include <limits>

using namespace swarf;

// Steps of 0.3 s under a stable step of 1 s: three fit, and no time is lost.
TEST(Pace, is_as_rare_as_the_stable_step_allows) {
  Pace pace;
  double done = 0;
  int times = 0;
  for (int step = 0; step < 100; ++step) {
    pace.add(0.3);
    if (pace.by_next(0.3) <= 1.0) continue;
    EXPECT_LE(pace.waited, 1.0);
    done += pace.take(), ++times;
  }
  EXPECT_EQ(times, 33);
  EXPECT_NEAR(done + pace.waited, 30, 1e-12); // no time is lost
}

TEST(FreezePlan, looks_again_when_tool_or_points_may_have_gone_their_way) {
  FreezePlan plan;
  const auto due_after = [&](double elapsed, double tool, double points, FreezePlan::ToolAndPoints way) {
    plan.plan(elapsed, {tool, points}, way);
    return plan.due;
  };
  const double never = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(due_after(0.9, 2, 1, {2, 1}));
  EXPECT_TRUE(due_after(1, 2, 0, {2, 1}));      // the tool has
  EXPECT_TRUE(due_after(1, 0, 1, {2, 1}));      // a point has
  EXPECT_FALSE(due_after(9, 2, 0, {never, 1})); // no tool
  plan.due = true, plan.looked(3);
  EXPECT_FALSE(plan.due);
  EXPECT_EQ(plan.looked_at, 3);
}

TEST(ConversionPlan, looks_again_by_strain_always_and_by_distance_after_a_way) {
  ConversionPlan plan;
  plan.looked(1);
  plan.plan(1.4, false, 2, 1);
  EXPECT_FALSE(plan.due);
  plan.plan(1.5, false, 2, 1);
  EXPECT_TRUE(plan.due);
  plan.plan(1, true, 0, 1);
  EXPECT_TRUE(plan.due);
}

// A body of 7 J that a tool gives 5 J, of which 3 J become heat by plastic work and 1 J by friction, and 0.5
// J are lost when hexes become particles: nothing is left over. Half a joule out of nothing is.
TEST(EnergyLedger, closes_where_nothing_is_made) {
  EnergyLedger books;
  books.particles.kinetic = 4, books.hexes.kinetic = 3;
  books.begin();
  EXPECT_EQ(books.initial, 7);
  books.take_tool_work(2), books.take_tool_work(3);
  books.particles.kinetic = 2, books.hexes.kinetic = 1;
  books.particles.internal = 6, books.particles.plastic = 3;
  books.hexes.internal = Real(1.5), books.particles.friction = 1;
  books.lost_in_conversion = 0.5;
  HistorySample s;
  books.fill(s);
  EXPECT_EQ(s.external, 5);
  EXPECT_EQ(s.elastic, 4.5);
  EXPECT_EQ(s.residual, 0);
  books.hexes.kinetic += Real(0.5), books.fill(s);
  EXPECT_EQ(s.residual, 0.5);
  books.particles.external = -1, books.fill(s); // what leaves at held faces counts, too
  EXPECT_EQ(s.residual, 1.5);
}
