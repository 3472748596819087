// The mechanistic model against values computed by hand, brute force and itself, and the fits against forces
// whose coefficients are known.
#include "src/files/results.hpp"
#include "src/mechanistic/identify.hpp"
#include "support/temporary_folder.hpp"
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <numbers>
#include <random>

using namespace swarf;
using ::testing::HasSubstr;

namespace {

constexpr double degree = std::numbers::pi / 180, um = 1e-6;

Deck paper() { return read_deck(SWARF_SOURCE_DIR "/inputs/micro_milling.toml"); }

MechanisticDeck slot() {
  MechanisticDeck model;
  model.exit = std::numbers::pi, model.depth = 100 * um;
  return model;
}

// K_tc, K_rc in N/mm2, K_te, K_re in N/mm.
MechanisticDeck with(double tc, double rc, double te, double re) {
  MechanisticDeck model = slot();
  model.K_tc = tc * 1e6, model.K_rc = rc * 1e6, model.K_te = te * 1e3, model.K_re = re * 1e3;
  return model;
}

double value_at(const HistoryTable& table, const std::string& column, double immersion) {
  const auto& angle = table.at("immersion");
  for (std::size_t i = 0; i < angle.size(); ++i)
    if (std::abs(angle[i] - immersion) < 1e-6) return table.at(column)[i];
  ADD_FAILURE() << "no row at " << immersion;
  return 0;
}

// The chip at an angle, from the tip's path since a turn ago, sampled: distance of the nearest earlier point
// of the surface on the ray from the spindle. Independent of MillEdge but for the geometry of the deck.
double chip_by_sampling(const ToolDeck& tool, int tooth, double angle) {
  const double pitch = 2 * std::numbers::pi / tool.flutes, per_angle = tool.feed_per_tooth / pitch;
  const double R = 0.5 * tool.diameter;
  const auto tip = [&](int k, double immersion, double& x, double& y) { // immersion of tooth 0
    const double mill = immersion - k * pitch, out = immersion + tool.runout_angle;
    x = per_angle * immersion + R * std::sin(mill) + tool.runout * std::sin(out);
    y = R * std::cos(mill) + tool.runout * std::cos(out);
  };
  // The immersion at which this tooth's tip is at the angle about the spindle.
  double now = angle + tooth * pitch;
  for (int pass = 0; pass < 40; ++pass) {
    double x, y;
    tip(tooth, now, x, y);
    now -= std::remainder(std::atan2(x - per_angle * now, y) - angle, 2 * std::numbers::pi);
  }
  double x, y;
  tip(tooth, now, x, y);
  const double centre = per_angle * now, radius = std::hypot(x - centre, y);
  double reach = 0;
  for (int before = 1; before <= tool.flutes; ++before) {
    const int k = ((tooth - before) % tool.flutes + tool.flutes) % tool.flutes;
    const double about = now - before * pitch;
    double last_cross = 0, last_reach = 0;
    const int steps = 80001; // two feeds are 0.05 rad at the edge
    for (int i = 0; i < steps; ++i) {
      const double then = about + (i - steps / 2) * 2e-6;
      tip(k, then, x, y);
      const double dx = x - centre, cross = dx * std::cos(angle) - y * std::sin(angle);
      const double along = dx * std::sin(angle) + y * std::cos(angle);
      if (i > 0 && (cross > 0) != (last_cross > 0) && along > 0)
        reach = std::max(reach, last_reach + (along - last_reach) * last_cross / (last_cross - cross));
      last_cross = cross, last_reach = along;
    }
  }
  return std::max(0.0, radius - reach);
}

} // namespace

TEST(Mechanistic, the_cut_of_the_paper_is_as_computed_by_hand) {
  const MillCut cut = find_cut(paper(), slot());
  EXPECT_NEAR(cut.lag() / degree, 6.74, 0.005);
  EXPECT_NEAR(cut.feed_speed() * 6e4, 200, 1e-9); // mm/min
  MillCut flat = cut;
  flat.helix = 0;
  const MillEdge edge(flat);
  EXPECT_NEAR(edge.look(0, 0, 10 * degree).chip / um, 1.842, 0.0005);
  EXPECT_NEAR(edge.look(0, 0, 30 * degree).chip / um, 5.058, 0.0005);
  EXPECT_NEAR(edge.look(0, 0, 90 * degree).chip / um, 10.000, 0.0005);
}

TEST(Mechanistic, planar_force_at_90_degrees_is_as_computed_by_hand) {
  EXPECT_NEAR(value_at(run_model(paper(), with(1633, 152, 22.2, 41.0)), "force_planar", 90), 5.73, 0.005);
  EXPECT_NEAR(value_at(run_model(paper(), with(2236, 795, 24, 43)), "force_planar", 90), 6.88, 0.005);
}

TEST(Mechanistic, chip_is_that_of_the_sampled_trochoids_with_runout) {
  Deck deck = paper();
  deck.tool->helix = 0, deck.tool->runout = 2 * um, deck.tool->runout_angle = 35 * degree;
  MechanisticDeck model = slot();
  const MillCut cut = find_cut(deck, model);
  const MillEdge edge(cut);
  for (const int tooth : {0, 1})
    for (const double at : {15.0, 60.0, 90.0, 150.0}) {
      // look() takes the immersion of tooth 0 and says where the tip is.
      const EdgePoint point = edge.look(tooth, 0, (at + 180 * tooth) * degree);
      EXPECT_NEAR(point.chip / um, chip_by_sampling(cut.tool, tooth, point.angle) / um, 1e-5)
          << tooth << ' ' << at;
    }
}

TEST(Mechanistic, runout_shares_the_feed_between_the_teeth) {
  Deck deck = paper();
  deck.tool->runout = 3 * um, deck.tool->helix = 0;
  const MillEdge edge(find_cut(deck, slot()));
  const double first = edge.look(0, 0, 90 * degree).chip, second = edge.look(1, 0, 270 * degree).chip;
  EXPECT_NEAR(first / um, 16, 1e-3); // tooth 0 reaches 2 x 3 um farther than tooth 1
  EXPECT_NEAR(second / um, 4, 1e-3);
  deck.tool->runout = 6 * um; // more than half of the feed: tooth 1 cuts nothing, tooth 0 both feeds
  const MillEdge one(find_cut(deck, slot()));
  EXPECT_NEAR(one.look(0, 0, 90 * degree).chip / um, 20, 1e-3);
  EXPECT_EQ(one.look(1, 0, 270 * degree).chip, 0);
}

TEST(Mechanistic, work_of_the_torque_is_the_energy_of_the_cut) {
  // One turn removes flutes x feed x diameter x depth of a slot; with K_tc alone the work is K_tc times that
  // volume. Chip times radius counts a ring's area as that of a strip, which is more by chip / (2 R): pi / 8
  // feed / R for a sine.
  const HistoryTable table = run_model(paper(), with(1000, 0, 0, 0));
  double work = 0;
  for (double at = 0; at < 360; at += 0.5) work += value_at(table, "torque", at) * 0.5 * degree;
  EXPECT_NEAR(work / (1e9 * 2 * 10e-6 * 800e-6 * 100e-6), 1 + std::numbers::pi / 8 * 10 / 400, 2e-4);
}

TEST(Mechanistic, thin_chips_wait_until_they_are_thick_enough) {
  MechanisticDeck model = with(1633, 152, 22.2, 41.0);
  model.minimum_chip = 3 * um;
  Deck deck = paper();
  deck.tool->helix = 0;
  const MillCut cut = find_cut(deck, model);
  const MillEdge edge(cut);
  // Where each pass adds less than the minimum n passes must gather: at 10 deg 1.84 um a pass, so every other
  // cuts.
  EXPECT_NEAR(edge.share_without_chip(10.5 * degree), 0.5, 0.03);
  EXPECT_NEAR(edge.share_without_chip(90.5 * degree), 0, 1e-12);
  EXPECT_GT(edge.share_without_chip(3.5 * degree), 0.7); // 0.73 um a pass: every fifth
  for (double at = 1; at < 180; at += 1) {
    const EdgePoint point = edge.look(0, 0, at * degree);
    EXPECT_TRUE(!point.cuts || point.chip >= 0.98 * model.minimum_chip) << at;
  }
  // Nothing is lost: what is cut in the long run is what is fed.
  const HistoryTable with_minimum = run_model(deck, model);
  model.minimum_chip = 0;
  const HistoryTable without = run_model(deck, model);
  EXPECT_NEAR(value_at(with_minimum, "force_planar", 90), value_at(without, "force_planar", 90), 1e-9);
}

TEST(Mechanistic, a_turn_takes_less_than_a_tenth_of_a_second) {
  const Deck deck = paper();
  MechanisticDeck model = with(1633, 152, 22.2, 41.0);
  double best = 1e9;
  for (int k = 0; k < 5; ++k) { // the best, for the machine has other work too
    const auto begin = std::chrono::steady_clock::now();
    run_model(deck, model);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  std::printf("a turn takes %.4f s\n", best);
  EXPECT_LT(best, 0.1);
}

TEST(Identify, finds_the_coefficients_of_forces_with_noise_and_says_how_well) {
  const TemporaryFolder folder;
  MechanisticDeck known = with(1633, 152, 22.2, 41.0);
  known.K_ac = 300e6, known.K_ae = 2e3;
  const Coefficients truth = coefficients_of(known);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.05);
  std::vector<std::pair<double, HistoryTable>> exact;
  for (const double feed : {4.0, 8.0, 12.0}) {
    Deck deck = paper();
    deck.tool->feed_per_tooth = feed * um;
    exact.emplace_back(feed, run_model(deck, known));
  }
  int within = 0, draws = 20;
  for (int draw = 0; draw < draws; ++draw) {
    std::string text = "immersion [deg],feed_per_tooth [um],force_x [mN],force_y [N],force_z [N]\n";
    for (const auto& [feed, table] : exact)
      for (double at = 10; at <= 170; at += 10)
        text += fmt::format(
            "{},{},{},{},{}\n", at, feed, 1e3 * (value_at(table, "force_x", at) + noise(random)),
            value_at(table, "force_y", at) + noise(random), value_at(table, "force_z", at) + noise(random));
    const Identified found = identify_from_table(folder.write("forces.csv", text), paper(), slot());
    EXPECT_EQ(found.points, 3 * 17 * 3);
    EXPECT_NEAR(found.scatter, 0.05, 0.01); // 4 of its own standard errors
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_LT(std::abs(found.value[k] - truth[k]), 4.5 * found.error[k]) << coefficient_names[k];
      within += std::abs(found.value[k] - truth[k]) < found.error[k] ? 1 : 0;
    }
  }
  EXPECT_NEAR(within / (6.0 * draws), 0.68, 0.13); // three standard errors of that share
}

TEST(Identify, three_thicknesses_of_a_wedge_give_a_line) {
  const TemporaryFolder folder;
  const double K_tc = 1500e6, K_te = 30e3, K_rc = 200e6, K_re = 45e3, width = 1e-3;
  std::vector<std::string> folders;
  const std::string deck = read_text(SWARF_SOURCE_DIR "/inputs/orthogonal_cutting.toml");
  for (const double chip : {20.0, 40.0, 60.0}) {
    folders.push_back((folder / fmt::format("h{}", chip)).string());
    const ResultsFolder results = create_results(folders.back());
    std::string own = deck;
    const std::string size = "size = [\"500 um\", \"80 um\", \"20 um\"]";
    ASSERT_NE(own.find(size), own.npos);
    own.replace(own.find(size), size.size(),
                fmt::format("size = [\"500 um\", \"{} um\", \"20 um\"]", 40 + chip));
    write_file(results.deck(), own);
    HistoryFile file(results.history(), 1);
    for (int i = 0; i <= 200; ++i) {
      HistorySample s;
      s.time = 1e-6 * i;
      if (i > 80) s.force = {-width * (K_tc * chip * um + K_te), width * (K_rc * chip * um + K_re), 0};
      file.append(s);
    }
  }
  const Identified found = identify_from_runs(folders, slot());
  EXPECT_NEAR(found.value[0] / K_tc, 1, 1e-6);
  EXPECT_NEAR(found.value[1] / K_rc, 1, 1e-6);
  EXPECT_NEAR(found.value[3] / K_te, 1, 1e-6);
  EXPECT_NEAR(found.value[4] / K_re, 1, 1e-6);
  EXPECT_FALSE(found.is_found[2]);
  EXPECT_THAT(message_of<DeckError>([&] { identify_from_runs({folders[0]}, slot()); }),
              HasSubstr("three feeds"));
}

TEST(Mechanistic, section_reads_back_and_its_faults_are_said) {
  const TemporaryFolder folder;
  MechanisticDeck model = with(1633, 152, 22.2, 41.0);
  model.line = 1;
  const std::string file = folder.write("k.toml", write_mechanistic(model));
  EXPECT_EQ(read_mechanistic(file), model);
  EXPECT_THAT(message_of<DeckError>([&] { read_mechanistic(folder.write("a.toml", "[other]\n")); }),
              HasSubstr("mechanistic: is missing"));
  EXPECT_THAT(message_of<DeckError>([&] {
                read_mechanistic(
                    folder.write("b.toml", "[mechanistic]\nK_tc = \"1633 N/mm\"\nK_rc = \"1 N/mm2\"\n"));
              }),
              HasSubstr("b.toml:2: mechanistic.K_tc"));
  EXPECT_THAT(message_of<DeckError>([&] {
                read_mechanistic(folder.write("c.toml",
                                              "[mechanistic]\nK_tc = \"1 GPa\"\nK_rc = \"1 GPa\"\nexit = \"0 "
                                              "deg\"\n"));
              }),
              HasSubstr("expected more than entry"));
}
