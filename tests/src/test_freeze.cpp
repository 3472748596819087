// Freezing in a whole run: what it leaves unchanged, what comes back of a wave, and that energy closes.
#include "src/files/results.hpp"
#include "src/output/history.hpp"
#include "src/output/write_hdf5.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/small_deck.hpp"
#include "tests/verification/drive.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double mm = 1e-3, wave_length = 30 * mm, ramp = 60 * mm, distance = 150 * mm;

// A bar 240 mm long of 1 mm, in plane strain. A wall slides past its near end and does not touch it, so that
// the active region is there. The end lies inside a cell of the active region, and not on its face.
Deck make_bar(const std::string& fill, int across) {
  Deck deck = fill == "hexes" ? undamped() : shipped_defaults();
  deck.materials = {elastic_material(4430, 110e9, 0.33)};
  const double side = across * mm;
  deck.bodies = {block("bar", fill, {mm, 0, 0}, {240 * mm, side, side}, mm)};
  hold(deck.bodies[0], "symmetric", {"y_min", "y_max", "z_min", "z_max"});
  ToolDeck wall(ToolKind::wall);
  wall.normal = {1, 0, 0}, wall.size = 20 * mm, wall.position = {0.6 * mm, 0, 0};
  wall.velocity = {0, 100, 0};
  deck.tool = wall;
  deck.sleep.distance = distance, deck.sleep.ramp = ramp / distance, deck.sleep.speed = 1;
  deck.run.end_time = 1, deck.run.courant = 0.5;
  return deck;
}

// Largest speed along the bar between the free end, where waves double, and the ramp.
double largest_speed(const Simulation& simulation) {
  double largest = 0;
  for (const PointState& p : snapshot(simulation.scene()))
    if (p.x[0] > 20 * mm && p.x[0] < distance - ramp) largest = std::max(largest, std::abs(p.v[0]));
  return largest;
}

// A packet of waves splits into two halves that run both ways; the near end, free, sends one after the other.
// What comes back once both have met the ramp, over what went.
double reflected_share(const Deck& deck) {
  Simulation simulation(deck);
  set_velocity(simulation.scene(), [](const Triple& x) {
    const double s = x[0] - 45 * mm;
    return Triple{std::exp(-std::pow(s / (22.5 * mm), 2)) * std::sin(2 * std::numbers::pi * s / wave_length),
                  0, 0};
  });
  simulation.start();
  const double c = double(longitudinal_wave_speed(host_copy(simulation.scene().materials)(0)));
  double sent = 0, returned = 0;
  run_until(simulation, 330 * mm / c, [&] {
    const double way = c * simulation.time();
    if (simulation.step_count() % 10 != 0) return;
    if (way > 90 * mm && way < 110 * mm) sent = std::max(sent, largest_speed(simulation));
    if (way > 200 * mm) returned = std::max(returned, largest_speed(simulation));
  });
  std::printf("sent %.4f m/s, returned %.5f m/s\n", sent, returned);
  return returned / sent;
}

} // namespace

TEST(Freeze, sends_back_less_than_2_percent_of_a_wave_of_half_a_ramp_in_hexes) {
  EXPECT_LT(reflected_share(make_bar("hexes", 1)), 0.02);
}

TEST(Freeze, sends_back_less_than_2_percent_of_a_wave_of_half_a_ramp_in_particles) {
  EXPECT_LT(reflected_share(make_bar("particles", 4)), 0.02);
}

namespace {

// Of a plate, periodic in both directions, over which a small wall slides. No node on the face of a cell.
int count_active(const std::string& fill, const Triple& wall_position) {
  Deck deck = fill == "hexes" ? undamped() : shipped_defaults();
  deck.materials = {elastic_material(4430, 110e9, 0.33)};
  deck.bodies = {block("plate", fill, {0.25 * mm, 0.25 * mm, 0}, {60 * mm, 60 * mm, 5 * mm}, mm)};
  hold(deck.bodies[0], "periodic", {"x_min", "x_max", "y_min", "y_max"});
  ToolDeck wall(ToolKind::wall);
  wall.normal = {0, 0, -1}, wall.size = 1.5 * mm, wall.position = wall_position;
  wall.velocity = {1, 0, 0};
  deck.tool = wall;
  deck.sleep.distance = 16 * mm, deck.sleep.speed = 1;
  deck.run.end_time = 1;
  Simulation simulation(deck);
  simulation.start();
  const HexMesh& m = simulation.scene().hexes;
  const auto active = host_copy(m.active);
  return simulation.scene().particles.count +
         int(std::count(active.data(), active.data() + active.extent(0), hex_active));
}

} // namespace

// Across a corner too, where the image of an image lies.
TEST(Freeze, is_as_near_to_the_active_region_across_periodic_faces) {
  for (const char* fill : {"particles", "hexes"}) {
    const int in_the_middle = count_active(fill, {30.75 * mm, 30.75 * mm, 5.2 * mm});
    EXPECT_GT(in_the_middle, 2000) << fill;
    EXPECT_LT(in_the_middle, 10000) << fill;
    EXPECT_EQ(count_active(fill, {2.75 * mm, 2.75 * mm, 5.2 * mm}), in_the_middle) << fill;
  }
}

namespace {

HistoryTable run_history(const TemporaryFolder& folder, const std::string& name, const Edits& edits) {
  const std::string deck = write_deck(folder, edit_small_deck(edits));
  const Ended end = run_program(run_arguments(deck, folder / name));
  EXPECT_EQ(end.status, 0) << end.output;
  return read_history(folder / name / "history.csv");
}

} // namespace

// A distance beyond the scene: the order of sums differs, by the lists that are made more often, and with it
// the step, which grows at checks only, and these fall elsewhere; the work of the cut then by 4.9e-3.
TEST(Freeze, changes_nothing_where_all_is_active) {
  const TemporaryFolder folder;
  const HistoryTable plain = run_history(folder, "plain", {}),
                     active = run_history(folder, "active",
                                          {{"[run]", "[sleep]\ndistance = \"1 mm\"\nramp = 0.1\n[run]"}});
  for (const char* column : {"time", "external_work", "plastic_work", "max_temperature"})
    EXPECT_NEAR(active.at(column).back() / plain.at(column).back(), 1, 1e-2) << column;
}

// What stops, fades or is held gives its energy to the external work.
TEST(Freeze, closes_the_energy) {
  const TemporaryFolder folder;
  Edits edits = longer_sector;
  edits.push_back({"[run]", "[sleep]\ndistance = \"32 um\"\nspeed = 1.0\n[run]"});
  const HistoryTable frozen = run_history(folder, "frozen", edits);
  int active = 0;
  CheckpointReader(folder / "frozen" / "checkpoint.h5").get("active", active);
  EXPECT_LT(active, 1200); // of 1440
  const HistoryTable plain = run_history(folder, "plain", longer_sector);
  const double external = frozen.at("external_work").back();
  EXPECT_GT(external, 0);
  EXPECT_NEAR(frozen.at("energy_residual").back() / external,
              plain.at("energy_residual").back() / plain.at("external_work").back(), 2e-3);
}
