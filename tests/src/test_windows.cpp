// Windows of a pass: their geometry is that of the whole pass, their forces are joined with honest errors,
// and the program runs, keeps, continues and names them.
#include "src/geometry/shape.hpp"
#include "src/tool/geometry.hpp"
#include "src/windows/join_windows.hpp"
#include "src/windows/windows.hpp"
#include "tests/src/scene_decks.hpp"
#include <gtest/gtest.h>
#include <random>

using namespace swarf;
using namespace swarf::test;

namespace {

// The whole ring with its helix, and a slice of a sector; both from before the slot to past it.
Deck whole_ring() {
  Deck deck = paper_deck();
  deck.tool = paper_mill();
  deck.tool->start_angle = -2 * degree, deck.tool->position = {0, 0, 50 * um};
  deck.bodies[0].previous_tooth = true;
  deck.run.end_immersion = 187 * degree;
  return deck;
}

Deck sector() {
  Deck deck = empty_deck();
  deck.bodies = {ring("zone", "particles", 400 * um, 424 * um, 12 * um, {344, 3, 8}),
                 ring("bulk", "hexes", 424 * um, 472 * um, 12 * um, {172, 2, 6})};
  for (BodyDeck& body : deck.bodies) body.start_angle = -101 * degree, body.end_angle = 91 * degree;
  deck.bodies[0].previous_tooth = true, deck.bodies[0].tie = "bulk";
  deck.tool = paper_mill();
  deck.tool->helix = 0, deck.tool->start_angle = -2.5 * degree, deck.tool->length = 40 * um;
  deck.tool->position = {0, 0, -10 * um};
  deck.tool->feed_direction = {1, 0.1, 0};
  deck.run.end_immersion = 184 * degree;
  return deck;
}

WindowsDeck windows_of(double first, double last, double step) {
  WindowsDeck windows;
  windows.first = first * degree, windows.last = last * degree, windows.step = step * degree;
  return windows;
}

// The largest difference of the two surfaces over the window's arc, where the whole deck's is that of the
// pass before this one.
double surface_difference(const Deck& whole, const Window& window) {
  const ToolDeck& tool = *whole.tool;
  const InnerSurface of_whole = previous_tooth_surface(tool, {0, 0, 0}),
                     of_window = previous_tooth_surface(*window.deck.tool, {0, 0, 0});
  const BodyDeck& zone = window.deck.bodies[0];
  double most = 0;
  for (double angle = zone.start_angle; angle <= zone.end_angle; angle += 0.1 * degree)
    for (double z = 0; z <= zone.height; z += zone.height / 10) {
      const double lag = std::max(0.0, z - tool.position[2]) * std::tan(tool.helix) / (400 * um);
      const double immersion = pi / 2 - angle + lag;
      if (immersion > tool.start_angle + 179 * degree || immersion < tool.start_angle + 1 * degree) continue;
      most = std::max(most, std::abs(of_whole(angle, z) - of_window(angle, z)));
    }
  return most;
}

} // namespace

TEST(Windows, keep_the_surface_of_the_previous_tooth) {
  for (const Deck& whole : {whole_ring(), sector()})
    for (const Window& window : cut_windows(whole, windows_of(10, 170, 20)))
      EXPECT_LT(surface_difference(whole, window), 1e-15)
          << window.name; // of 400 um: a few units of round-off
}

TEST(Windows, keep_the_path_of_the_tool) {
  for (const Deck& whole : {whole_ring(), sector()})
    for (const Window& window : cut_windows(whole, windows_of(10, 170, 20))) {
      const ToolDeck &tool = *whole.tool, &its = *window.deck.tool;
      const double speed = tool.spindle_speed;
      const ToolPose pose = tool_pose(tool, (window.centre - tool.start_angle) / speed),
                     same = tool_pose(its, (window.centre - its.start_angle) / speed);
      EXPECT_NEAR(pose.position.x, same.position.x, 1e-17) << window.name;
      EXPECT_NEAR(pose.position.y, same.position.y, 1e-17);
      EXPECT_NEAR(std::remainder(double(pose.angle - same.angle), 2 * pi), 0, 1e-14);
      EXPECT_DOUBLE_EQ(end_time_of(window.deck), (window.to - its.start_angle) / speed);
      const double turned = std::atan2(tool.feed_direction[1], tool.feed_direction[0]);
      EXPECT_NEAR(window.uncut_chip, 10 * um * std::sin(window.centre + turned),
                  0.2 * um); // trochoid, f^2 / R
    }
}

TEST(Windows, cells_lie_where_those_of_the_whole_pass_do) {
  const Deck whole = sector();
  for (const Window& window : cut_windows(whole, windows_of(30, 150, 40)))
    for (int b = 0; b < 2; ++b) {
      const BodyDeck &body = window.deck.bodies[b], &uncut = whole.bodies[b];
      const double cell = 192 * degree / (*uncut.cells)[0],
                   from_start = (body.start_angle - uncut.start_angle) / cell;
      EXPECT_NEAR((body.end_angle - body.start_angle) / (*body.cells)[0], cell, 1e-12);
      EXPECT_NEAR(from_start, std::round(from_start), 1e-9);
      EXPECT_EQ((*body.cells)[1], (*uncut.cells)[1]);
      EXPECT_EQ((*body.cells)[2], (*uncut.cells)[2]);
    }
  // Where the lattices of the whole have no lines in common the spacing is kept but for a part of a cell.
  for (const Window& window : cut_windows(whole_ring(), windows_of(30, 150, 40)))
    for (int b = 0; b < 2; ++b) {
      const BodyDeck& body = window.deck.bodies[b];
      const double cell = 360 * degree / (b == 0 ? 717 : 344);
      EXPECT_NEAR((body.end_angle - body.start_angle) / (*body.cells)[0] / cell, 1, 0.02);
      EXPECT_DOUBLE_EQ(body.end_angle, window.deck.bodies[0].end_angle);
    }
}

TEST(Windows, hold_run_in_lag_and_what_lies_ahead) {
  const WindowsDeck windows = windows_of(90, 90, 10);
  for (const Deck& whole : {whole_ring(), sector()}) {
    const Window window = cut_windows(whole, windows).front();
    const double lag = 100 * um * std::tan(whole.tool->helix) / (400 * um), cell = 1.2 * degree;
    const double entry = window.from - windows.run_in - lag, end = window.to + windows.ahead;
    EXPECT_NEAR(window.to - window.from, windows.width, 1e-12);
    for (const BodyDeck& body :
         window.deck.bodies) { // seen from the ring's axis: the tool is within 5 um of it
      EXPECT_NEAR(pi / 2 - body.end_angle, entry, 0.8 * degree + cell);
      EXPECT_NEAR(pi / 2 - body.start_angle, end, 0.8 * degree + cell);
    }
    EXPECT_LT(window.deck.tool->start_angle, entry);
    EXPECT_GT(window.deck.tool->start_angle, entry - 3 * degree);
    const auto& faces =
        window.deck.bodies[1].faces; // the bulk goes on behind the window, and begins at its free end
    ASSERT_EQ(faces.size(), 1u);
    EXPECT_EQ(faces[0].face, "start");
    EXPECT_EQ(faces[0].kind, FaceKind::fixed);
  }
}

TEST(Windows, begin_as_the_whole_pass_where_that_is_near) {
  const Deck whole = sector();
  const Window window = cut_windows(whole, windows_of(5, 5, 10)).front();
  EXPECT_EQ(window.deck.tool->start_angle, whole.tool->start_angle);
  EXPECT_EQ(window.deck.tool->position, whole.tool->position);
  EXPECT_EQ(window.deck.bodies[0].end_angle, whole.bodies[0].end_angle);
  EXPECT_GT(window.deck.bodies[0].start_angle, whole.bodies[0].start_angle);
}

// No particle or node may lie inside the tool, whatever its rake: build_scene refuses that.
TEST(Windows, start_just_outside_of_the_material) {
  for (const double rake : {-20.0, 15.0})
    for (const double helix : {0.0, 25.2}) {
      Deck whole = whole_ring();
      whole.tool->rake = rake * degree, whole.tool->helix = helix * degree;
      whole.bodies[0].cells = {360, 6, 6}, whole.bodies[1].cells = {120, 3, 3};
      Deck deck = cut_windows(whole, windows_of(90, 90, 10)).front().deck;
      EXPECT_NO_THROW(build_scene(deck)) << rake << " " << helix;
      deck.tool->start_angle += 3 * degree;
      EXPECT_THROW(build_scene(deck), DeckError) << "is not near: " << rake << " " << helix;
    }
}

TEST(Windows, cost_a_fraction) {
  const Deck whole = whole_ring();
  double effort = 0;
  for (const Window& window : cut_windows(whole, windows_of(10, 170, 20))) effort += find_effort(window.deck);
  EXPECT_LT(effort, 0.1 * find_effort(whole));
}

namespace {

HistoryTable line_with_noise(double rise, const std::vector<double>& noise) {
  HistoryTable table;
  for (const char* name : {"time", "immersion", "force_x", "force_y", "force_z"})
    table.columns.push_back({name, "1"});
  table.values.resize(5);
  const std::size_t n = noise.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double place = (double(k) - 0.5) / double(n - 1); // of the interval that the sample is the mean of
    const double row[] = {1e-6 * double(k), 80 + 20 * double(k) / double(n - 1), 3 + rise * (place - 0.5),
                          4 + noise[k], 1};
    for (int c = 0; c < 5; ++c) table.values[std::size_t(c)].push_back(row[c]);
  }
  return table;
}

} // namespace

TEST(JoinWindows, a_rise_is_no_error) {
  const MeanForce force = measure_force(line_with_noise(2, std::vector<double>(1601, 0)), 80, 100);
  EXPECT_NEAR(force.mean[0], 3, 1e-12);
  EXPECT_NEAR(force.mean[1], 4, 1e-12);
  EXPECT_NEAR(force.mean[3], 5, 1e-12);
  for (const double error : force.error) EXPECT_NEAR(error, 0, 1e-12);
}

// The standard error of the mean of n independent values is sigma / sqrt(n); it is estimated from few blocks,
// the largest of three estimates: between 0.8 and 1.8 of it on the mean of many cases. Values that keep their
// sign over a sixteenth of the window are as many as there are such parts.
TEST(JoinWindows, error_of_noise_that_is_white_or_slow) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, 0.5);
  for (const int run : {1, 100}) {
    double sum = 0;
    const int cases = 200;
    for (int k = 0; k < cases; ++k) {
      std::vector<double> noise(1601);
      for (std::size_t i = 0; i < noise.size(); ++i)
        noise[i] = i > 0 && (i - 1) % std::size_t(run) != 0 ? noise[i - 1] : normal(random);
      sum += measure_force(line_with_noise(0, noise), 80, 100).error[1] / cases;
    }
    const double truth = 0.5 / std::sqrt(1600.0 / run);
    EXPECT_GT(sum, 0.8 * truth) << run;
    EXPECT_LT(sum, 1.8 * truth) << run;
  }
}

// Of windows with independent errors about a sine, over many cases; a sine itself has none.
TEST(JoinWindows, scatter_between_windows) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal(0, 0.3);
  std::vector<double> angle, force, exact;
  for (int k = 0; k < 2000; ++k) {
    angle.push_back(20 * k), exact.push_back(3 * std::sin((angle.back() + 10) * degree));
    force.push_back(exact.back() + normal(random));
  }
  EXPECT_NEAR(scatter_between(angle, exact), 0, 1e-9);
  EXPECT_NEAR(scatter_between(angle, force), 0.3, 0.03);
  EXPECT_TRUE(std::isnan(scatter_between({10, 30, 50, 70}, {1, 2, 3, 2})));
}

TEST(JoinWindows, too_few_samples) {
  const HistoryTable history = line_with_noise(0, std::vector<double>(4, 0));
  EXPECT_TRUE(std::isnan(measure_force(history, 80, 100).error[0]));
  EXPECT_THROW(measure_force(history, 101, 102), ResultsError);
}
