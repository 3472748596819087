// run.accuracy: the choice from a chart, its settings in a deck, and the refusal of what the chart cannot
// give.
#include "src/accuracy/accuracy.hpp"
#include "src/geometry/shape.hpp"
#include "src/windows/windows.hpp"
#include "tests/src/scene_decks.hpp"
#include "tests/support/run_program.hpp"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;
using testing::HasSubstr;

namespace {

// A chart whose numbers are easy to follow: inertia of 1e4 times the mass at half a metre a second.
std::string point(const std::string& label, double rows, double level, const std::string& more = "") {
  return fmt::format(
      "{{ label = \"{}\", runs = 1, chip_rows = {:.6f}, slice_rows = 4, wave_over_speed = {:.9f}, "
      "courant = 0.5, bulk = true, sleep_rows = 0.0, particles = {{ viscosity_linear = 0.2 }}, run_in = 1.0, "
      "measured = 1.0, error = 0.01, standard_error = 0.02, {} step = 0.6, "
      "seconds_per_particle_step = 1e-6{} }},\n",
      label, rows, 60.0, level > 0 ? fmt::format("level = {:.6f},", level) : "", more);
}

// Nine windows, measured as the shipped pass has them.
std::string windows_point(double rows, double error, double standard_error) {
  return fmt::format(
      "{{ chip_rows = {:.6f}, count = 9, run_in = 5.0, width = 6.0, ahead = 7.0, error = {:.6f}, "
      "standard_error = {:.6f} }},\n",
      rows, error, standard_error);
}

std::vector<AccuracyChart> chart(const std::string& points, const std::string& tool = "wedge") {
  return read_accuracy_charts(
      fmt::format("[{}]\ntitle = \"a cut\"\ndeck = \"cut.toml\"\nwhere = \"at the end\"\nuncertainty = 0.04\n"
                  "edge_over_chip = 0.5\nrake = 15.0\ndepth = 1.0\npoints = [\n{}]\n",
                  tool, points));
}

std::vector<AccuracyChart> some_charts() {
  return chart(point("coarse", 4, 0.2) + point("middle", 6, 0.08) + point("fine", 8, 0.06) +
               point("finest", 16, 0.03) + point("lucky", 4, 0)); // that has run at one spacing only
}

// A periodic slice, 8 particles across the chip, tied to hexes.
Deck wedge_deck() {
  Deck deck = empty_deck();
  deck.bodies = {block("zone", "particles", {0, -40 * um, 0}, {320 * um, 80 * um, 20 * um}, 5 * um),
                 block("bulk", "hexes", {0, -200 * um, 0}, {320 * um, 160 * um, 20 * um}, 10 * um)};
  for (BodyDeck& b : deck.bodies)
    b.faces = {{"z_min", FaceKind::periodic, {}}, {"z_max", FaceKind::periodic, {}}};
  deck.bodies[1].faces.push_back({"y_min", FaceKind::fixed, {}});
  deck.bodies[0].tie = "bulk";
  deck.tool.emplace();
  deck.tool->kind = ToolKind::wedge, deck.tool->edge_radius = 20 * um, deck.tool->rake = 15 * degree;
  deck.tool->clearance = 2 * degree, deck.tool->width = 60 * um, deck.tool->height = 300 * um;
  deck.tool->position = {-25 * um, 0, 10 * um}, deck.tool->velocity = {0.5, 0, 0};
  deck.run.end_time = 0.2e-3, deck.run.courant = 0.3, deck.run.mass_factor = 100;
  deck.output.force_scale = 50;
  deck.run.accuracy = 8.0, deck.run.accuracy_line = 12;
  return deck;
}

Deck read_input(const std::string& name) { return read_deck(SWARF_SOURCE_DIR "/inputs/" + name); }

std::string refusal(const Deck& deck, const std::vector<AccuracyChart>& charts = some_charts()) {
  return message_of<DeckError>([&] { planned_deck(deck, plan_accuracy(deck, charts)); });
}

} // namespace

TEST(Accuracy, takes_the_cheapest_that_keeps_it) {
  const auto charts = some_charts();
  Deck deck = wedge_deck();
  const auto picked = [&](double asked) {
    deck.run.accuracy = asked;
    const AccuracyPlan plan = plan_accuracy(deck, charts);
    return plan.picked < 0 ? "none" : plan.choices[plan.picked].point->label;
  };
  EXPECT_EQ(picked(30), "coarse");
  EXPECT_EQ(picked(8), "middle");
  EXPECT_EQ(picked(7.9), "fine");
  EXPECT_EQ(picked(4), "finest");
  EXPECT_EQ(picked(3.5), "none"); // its error is less, but the reference is known to 4 %
}

TEST(Accuracy, predicts_the_cost_from_particles_and_steps) {
  const auto charts = some_charts();
  const AccuracyPlan plan = plan_accuracy(wedge_deck(), charts);
  ASSERT_EQ(plan.choices.size(), 4u);
  // 64 x 16 x 4 particles; a step of 0.6 spacings of the scaled wave, which is 60 times as fast as the tool.
  const Choice& fine = plan.choices[2];
  EXPECT_EQ(fine.point->label, "fine");
  const double steps = 0.2e-3 / (0.6 * 5 * um / (60 * 0.5));
  EXPECT_NEAR(fine.core_seconds / (4096 * steps * 1e-6), 1, 2e-3); // the mass factor has three digits
  // The slice is four spacings: particles grow with the square, steps with the first power.
  EXPECT_NEAR(plan.choices[3].core_seconds / fine.core_seconds, 8, 1e-6);
}

TEST(Accuracy, puts_the_settings_into_the_deck) {
  const auto charts = some_charts();
  Deck deck = wedge_deck();
  deck.run.accuracy = 4;
  deck.particles.smoothing_length = SmoothingLength::evolving, deck.particles.skin = 0.2;
  const Deck with = planned_deck(deck, plan_accuracy(deck, charts));
  const BodyDeck &zone = with.bodies[0], &bulk = with.bodies[1];
  EXPECT_DOUBLE_EQ(*zone.spacing, 2.5 * um); // 40 um / 16
  EXPECT_DOUBLE_EQ(*bulk.spacing, 5 * um);
  EXPECT_DOUBLE_EQ(zone.size[2], 10 * um); // 4 spacings
  EXPECT_DOUBLE_EQ(bulk.size[2], 10 * um);
  for (int d : {0, 1}) EXPECT_EQ(zone.size[d], deck.bodies[0].size[d]);
  EXPECT_EQ(find_cells(with, zone), (Triple{128, 32, 4}));
  EXPECT_DOUBLE_EQ(with.tool->width, 30 * um);
  EXPECT_DOUBLE_EQ(with.tool->position[2], 5 * um);
  EXPECT_DOUBLE_EQ(with.output.force_scale, 100);                   // of the same width
  const double wave = std::sqrt(110e9 * 0.67 / 1.33 / 0.34 / 4430); // of the material: K + 4 G / 3
  EXPECT_NEAR(with.run.mass_factor / std::pow(wave / 30, 2), 1, 5e-3);
  EXPECT_EQ(with.run.courant, 0.5);
  EXPECT_FALSE(with.sleep.distance);
  EXPECT_EQ(with.particles.viscosity_linear, 0.2);
  EXPECT_EQ(with.particles.smoothing_length, SmoothingLength::fixed); // the chart's
  EXPECT_EQ(with.particles.skin, 0.2);                                // the deck's
  EXPECT_EQ(*with.run.end_time, *deck.run.end_time);
  EXPECT_FALSE(with.run.accuracy);
  ASSERT_TRUE(with.picked);
  EXPECT_THAT(with.picked->why, HasSubstr("\"finest\""));
  EXPECT_THAT(with.picked->why, HasSubstr("\"fine\", takes 0.12 of its time and errs by up to 6.0 %"));
  EXPECT_THAT(with.picked->changes, testing::Contains(HasSubstr("spacing = \"2.5e-06 m\", was \"5e-06 m\"")));
  EXPECT_THAT(resolved_deck(with), HasSubstr("# accuracy = \"4 %\": \"finest\""));
}

TEST(Accuracy, keeps_the_inertia_of_a_faster_cut) {
  const auto charts = some_charts();
  Deck deck = wedge_deck();
  const double slow = planned_deck(deck, plan_accuracy(deck, charts)).run.mass_factor;
  deck.tool->velocity = {1, 0, 0};
  EXPECT_NEAR(planned_deck(deck, plan_accuracy(deck, charts)).run.mass_factor / slow, 0.25, 2e-3);
  deck.tool->velocity = {200, 0, 0};
  EXPECT_THAT(refusal(deck), HasSubstr("the tool moves at 200 m/s: at most"));
}

TEST(Accuracy, leaves_a_depth_that_is_not_periodic) {
  const auto charts = some_charts();
  Deck deck = wedge_deck();
  deck.run.accuracy = 4;
  for (BodyDeck& b : deck.bodies) b.faces.clear();
  const Deck with = planned_deck(deck, plan_accuracy(deck, charts));
  EXPECT_EQ(with.bodies[0].size, deck.bodies[0].size);
  EXPECT_EQ(find_cells(with, with.bodies[0]), (Triple{128, 32, 8}));
  EXPECT_EQ(with.tool->width, deck.tool->width);
  EXPECT_EQ(with.output.force_scale, deck.output.force_scale);
}

TEST(Accuracy, lets_freeze_what_froze) {
  std::string text = point("asleep", 16, 0.06);
  text.replace(text.find("sleep_rows = 0.0"), 16, "sleep_rows = 24.0");
  const auto charts = chart(text);
  const Deck deck = wedge_deck();
  EXPECT_DOUBLE_EQ(*planned_deck(deck, plan_accuracy(deck, charts)).sleep.distance, 60 * um);
}

TEST(Accuracy, leaves_the_hexes_out_where_the_particles_are_deep_enough) {
  std::string text = point("shallow", 8, 0.06);
  text.replace(text.find("bulk = true"), 11, "bulk = false");
  const auto charts = chart(text);
  Deck deck = wedge_deck();
  const Deck with = planned_deck(deck, plan_accuracy(deck, charts));
  ASSERT_EQ(with.bodies.size(), 1u);
  EXPECT_EQ(with.bodies[0].tie, "");
  EXPECT_EQ(with.bodies[0].faces.back(), (FaceDeck{"y_min", FaceKind::fixed, {}}));
  EXPECT_THAT(with.picked->changes, testing::Contains(HasSubstr("[body \"bulk\"] left out")));
  deck.bodies[1].convert_distance = 60 * um;
  EXPECT_THAT(refusal(deck, charts), HasSubstr("are to become particles"));
  deck.bodies[1].convert_distance.reset();
  deck.bodies[0].origin[1] = -20 * um, deck.bodies[0].size[1] = 60 * um;
  EXPECT_THAT(refusal(deck, charts), HasSubstr("were 40 um deep for this uncut chip; here they are 20 um"));
}

TEST(Accuracy, refuses_what_the_chart_cannot_give) {
  Deck deck = wedge_deck();
  deck.run.accuracy = 3;
  const std::string text = refusal(deck);
  EXPECT_THAT(text, HasSubstr("test.toml:12: run.accuracy: 3 % cannot be promised: expected at least 4.0 %"));
  EXPECT_THAT(
      text,
      HasSubstr("the nearest is \"finest\", 16 particles across the uncut chip: error +1.0 % +- 2.0 %"));
  EXPECT_THAT(text, HasSubstr("the reference itself is known to 4.0 %"));
  EXPECT_THAT(text, HasSubstr("Write accuracy = \"4.0 %\", or remove the key"));
  EXPECT_EQ(text.find("The mean of"), text.npos);
}

TEST(Accuracy, promises_no_mean_of_three_from_one_run) {
  std::string three = point("3 x fine", 8, 0.05);
  three.replace(three.find("runs = 1"), 8, "runs = 3");
  Deck deck = wedge_deck();
  deck.run.accuracy = 5;
  EXPECT_THAT(
      refusal(deck, chart(point("fine", 8, 0.06) + three)),
      HasSubstr("The mean of 3 runs, at the uncut chip and a third of a spacing more and less, would be "
                "within 5.0 % with 8 particles across the chip, but no single run is."));
}

TEST(Accuracy, refuses_decks_that_the_chart_says_nothing_about) {
  Deck deck = wedge_deck();
  deck.bodies[0].tie.clear();
  EXPECT_THAT(refusal(deck), HasSubstr("body.tie is missing"));
  deck = wedge_deck(), deck.bodies[1].shape = BodyShape::cylinder;
  EXPECT_THAT(refusal(deck), HasSubstr("body \"bulk\" is a cylinder"));
  deck = wedge_deck(), deck.bodies[0].fill = Fill::hexes;
  EXPECT_THAT(refusal(deck), HasSubstr("is of particles, and this deck has none"));
  deck = wedge_deck(), deck.tool->position[1] = 50 * um;
  EXPECT_THAT(refusal(deck), HasSubstr("tool.position below the work's top"));
  deck = wedge_deck(), deck.tool->kind = ToolKind::wall;
  EXPECT_THAT(refusal(deck), HasSubstr("a tool of kind \"wall\""));
  deck = wedge_deck(), deck.tool.reset();
  EXPECT_THAT(refusal(deck), HasSubstr("this deck has no tool"));
}

TEST(Accuracy, the_shipped_chart_reads_and_has_choices) {
  for (const std::string tool : {"wedge", "end_mill"}) {
    const auto found =
        std::find_if(accuracy_charts().begin(), accuracy_charts().end(),
                     [&](const AccuracyChart& c) { return c.tool == value_of_word<ToolKind>(tool); });
    ASSERT_NE(found, accuracy_charts().end()) << tool;
    Deck deck = read_deck(SWARF_SOURCE_DIR "/" + found->deck);
    deck.run.accuracy = 1;
    const AccuracyPlan plan = plan_accuracy(deck);
    EXPECT_GE(plan.choices.size(), 2u) << tool; // spacings at least
    EXPECT_EQ(found->windows.empty(), tool == "wedge");
  }
}

// Bodies meet, slices hold the kernel's support, the tool is outside.
TEST(Accuracy, committed_decks_take_every_choice) {
  for (const std::string name : {"micro_milling_quick.toml", "orthogonal_cutting.toml"}) {
    Deck deck = read_input(name);
    deck.run.accuracy = 100;
    const AccuracyPlan plan = plan_accuracy(deck);
    for (const Choice& choice : plan.choices) {
      SCOPED_TRACE(name + ": " + choice.point->label);
      if (find_cells(choice.deck, choice.deck.bodies[0])[0] > 150) continue; // takes long
      const Scene scene = build_scene(choice.deck);
      EXPECT_NEAR(plan.cut.chip / scene.spacing / choice.point->chip_rows, 1, 0.05);
    }
  }
}

TEST(Accuracy, the_charts_own_settings_change_nothing_in_its_deck) {
  for (const AccuracyChart& chart : accuracy_charts()) {
    const Deck deck = read_deck(SWARF_SOURCE_DIR "/" + chart.deck);
    const Cut cut = find_cut(deck);
    int same = 0;
    for (const ChartPoint& p : chart.points)
      if (p.runs == 1 && std::abs(p.chip_rows * cut.spacing / cut.chip - 1) < 1e-4)
        same += list_changes(deck, put_settings(deck, cut, p)).empty();
    EXPECT_GE(same, 1) << chart.deck; // the base of the sweep
  }
}

// Windows add their own error, and take a share of the time.
TEST(Accuracy, takes_windows_where_the_deck_has_them_and_the_error_allows) {
  const auto charts =
      chart(point("rough", 2, 0.2) + point("coarse", 2.5, 0.2) + point("fine", 6, 0.06) + "]\nwindows = [\n" +
                windows_point(2.5, -0.1, 0.04) + windows_point(5, -0.03, 0.02),
            "end_mill");
  Deck deck = read_input("micro_milling_pass.toml");
  const WindowsDeck nine = *deck.windows;
  const auto picked = [&](double asked) {
    deck.run.accuracy = asked;
    const AccuracyPlan plan = plan_accuracy(deck, charts);
    if (plan.picked < 0) return std::string("none");
    const Choice& choice = plan.choices[plan.picked];
    EXPECT_EQ(planned_deck(deck, plan).windows, choice.windows ? deck.windows : std::nullopt);
    return choice.point->label + (choice.windows ? " in windows" : "");
  };
  EXPECT_EQ(picked(34.5), "coarse in windows"); // 20 % + 10 % + 4 %
  EXPECT_EQ(picked(33), "rough"); // fewer particles across the chip than were measured: as a whole only
  EXPECT_EQ(picked(11.5), "fine in windows");
  EXPECT_EQ(picked(10), "fine");
  EXPECT_EQ(picked(5), "none");
  deck.windows->run_in = 4 * degree; // less than was measured
  EXPECT_EQ(picked(11.5), "fine");
  deck.windows = nine, deck.windows->first = 30 * degree; // fewer
  EXPECT_EQ(picked(11.5), "fine");
  deck.windows->line = 0; // of the command line: the pass is not to run as a whole
  EXPECT_THAT(refusal(deck, charts), HasSubstr("windows like these were not measured"));
  deck.windows = nine, deck.windows->line = 0;
  EXPECT_EQ(picked(33), "fine in windows");
  deck.windows.reset();
  EXPECT_EQ(picked(11.5), "fine");
}

TEST(Accuracy, says_what_windows_add_and_what_they_take) {
  const auto charts =
      chart(point("fine", 6, 0.06) + "]\nwindows = [\n" + windows_point(5, -0.03, 0.02), "end_mill");
  Deck deck = read_input("micro_milling_pass.toml");
  deck.run.accuracy = 11.5;
  const AccuracyPlan plan = plan_accuracy(deck, charts);
  ASSERT_EQ(plan.choices.size(), 2u);
  const double share = plan.choices[0].core_seconds / plan.choices[1].core_seconds;
  EXPECT_GT(share, 0.05); // nine windows turn some 20 of 190 deg each, in a tenth of the cells
  EXPECT_LT(share, 0.15);
  const Deck with = planned_deck(deck, plan);
  EXPECT_THAT(with.picked->why, HasSubstr("in windows, whose mean differs from the whole pass by -3.0 % +- "
                                          "2.0 % with 5 particles"));
  for (const Window& window : cut_windows(with, *with.windows)) // a window's process knows of no accuracy
    EXPECT_EQ(resolved_deck(window.deck).find("# accuracy"), std::string::npos);
}

// The whole scene has no periodic slice: its depth stays, and the cells become cubes of the chart's spacing.
TEST(Accuracy, the_papers_scene_keeps_its_sizes) {
  Deck deck = read_input("micro_milling.toml");
  deck.run.accuracy = 100;
  const AccuracyPlan plan = plan_accuracy(deck);
  const Choice& choice = plan.choices.front();
  for (std::size_t b = 0; b < choice.deck.bodies.size(); ++b) {
    EXPECT_EQ(choice.deck.bodies[b].height, deck.bodies[b].height);
    EXPECT_EQ(choice.deck.bodies[b].outer_radius, deck.bodies[b].outer_radius);
  }
  const double finer = choice.point->chip_rows * plan.cut.spacing / plan.cut.chip;
  EXPECT_NEAR((*choice.deck.bodies[0].cells)[1], 47 * finer, 0.5 + 1e-9);
}

struct AccuracyOfRuns : testing::Test {
  TemporaryFolder folder;
  std::string with_accuracy(const std::string& text) const {
    std::string deck = read_bytes(SWARF_SOURCE_DIR "/inputs/micro_milling_quick.toml");
    deck.replace(deck.find("[run]\n"), 6, "[run]\n" + text + "\n");
    return folder.write("deck.toml", deck);
  }
};

TEST_F(AccuracyOfRuns, are_refused_before_anything_is_written) {
  const std::string deck = with_accuracy("accuracy = \"0.01 %\"");
  const Ended run = run_program(run_arguments(deck, folder / "results"));
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.output, HasSubstr("deck.toml:"));
  EXPECT_THAT(run.output, HasSubstr("run.accuracy: 0.01 % cannot be promised"));
  EXPECT_FALSE(std::filesystem::exists(folder / "results"));
  const Ended check = run_program({"check", deck, "--threads", "1"});
  EXPECT_EQ(check.status, 1);
  EXPECT_THAT(check.output, HasSubstr("choices for accuracy = \"0.01 %\""));
  EXPECT_THAT(check.output, HasSubstr("cannot be promised"));
}

TEST_F(AccuracyOfRuns, say_what_was_set_and_resume_with_it) {
  const std::string deck = with_accuracy("accuracy = \"100 %\"");
  const auto results = folder / "results";
  auto arguments = run_arguments(deck, results);
  arguments.insert(arguments.end(), {"--stop-after", "20"});
  const Ended run = run_program(arguments);
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("accuracy 100 %: \""));
  EXPECT_THAT(run.output, HasSubstr("cells = ["));
  EXPECT_THAT(read_bytes(results / "deck.toml"), HasSubstr("# accuracy = \"100 %\": \""));
  EXPECT_THAT(read_bytes(results / "summary.json"), HasSubstr("\"asked_percent\": 100"));
  EXPECT_FALSE(read_deck((results / "deck.toml").string()).run.accuracy); // that is a deck of its own
  arguments = run_arguments(deck, results, true);
  arguments.insert(arguments.end(), {"--stop-after", "40"});
  EXPECT_EQ(run_program(arguments).status, 0);
}
