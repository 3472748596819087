// Sleep in a whole run: what it leaves unchanged, what comes back of a wave, and that energy closes.
#include "src/results.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/small_deck.hpp"
#include "tests/verification/drive.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double mm = 1e-3, wave_length = 30 * mm, ramp = 60 * mm, distance = 150 * mm;

// A bar 240 mm long of 1 mm, in plane strain. A wall slides past its near end and does not touch it, so that
// the action is there.
Deck make_bar(const std::string& fill, int across) {
  Deck deck = undamped();
  deck.materials = {elastic_material(4430, 110e9, 0.33)};
  const double side = across * mm;
  deck.bodies = {block("bar", fill, {0, 0, 0}, {240 * mm, side, side}, mm)};
  hold(deck.bodies[0], "symmetric", {"y_min", "y_max", "z_min", "z_max"});
  ToolDeck wall;
  wall.kind = "wall", wall.normal = {1, 0, 0}, wall.size = 20 * mm, wall.position = {-0.7 * mm, 0, 0};
  wall.velocity = {0, 100, 0};
  deck.tool = wall;
  deck.sleep.distance = distance, deck.sleep.ramp = ramp / distance, deck.sleep.speed = 1;
  deck.run.end_time = 1, deck.run.courant = 0.5;
  return deck;
}

// A packet of waves splits into two halves that run both ways; the near end, free, sends one after the other.
// Largest speed outside the ramp once both have met it, over that of a half.
double reflected_share(const Deck& deck) {
  Simulation simulation(deck);
  set_velocity(simulation.scene(), [](const Triple& x) {
    const double s = x[0] - 45 * mm;
    return Triple{std::exp(-std::pow(s / (15 * mm), 2)) * std::sin(2 * std::numbers::pi * s / wave_length), 0,
                  0};
  });
  simulation.start();
  const double c = double(longitudinal_wave_speed(host_copy(simulation.scene().materials)(0)));
  double largest = 0;
  run_until(simulation, 330 * mm / c, [&] {
    if (simulation.time() < 185 * mm / c || simulation.step_count() % 10 != 0) return;
    for (const PointState& p : snapshot(simulation.scene()))
      if (p.x[0] < distance - ramp) largest = std::max(largest, std::abs(p.v[0]));
  });
  return largest / 0.5;
}

} // namespace

TEST(Sleep, sends_back_less_than_2_percent_of_a_wave_of_half_a_ramp_in_hexes) {
  EXPECT_LT(reflected_share(make_bar("hexes", 1)), 0.02);
}

TEST(Sleep, sends_back_less_than_2_percent_of_a_wave_of_half_a_ramp_in_particles) {
  EXPECT_LT(reflected_share(make_bar("particles", 4)), 0.02);
}
