// Cylinders of OFHC copper, 25.4 mm long and 7.62 mm wide, shot against a hard wall by Johnson & Cook (1983),
// with the constants they give for it.
#include "tests/verification/case.hpp"
#include "tests/verification/taylor_bar.hpp"
#include <algorithm>

using namespace swarf;
using namespace swarf::test;

namespace {

struct Shot {
  double speed, length, diameter; // m/s; mm after the impact
};
constexpr Shot shots[] = {{130, 19.56, 9.91}, {146, 18.69, 10.67}, {190, 16.21, 13.56}};

// Johnson & Cook's constants come from tension and torsion, at strains below 1 and rates below 500 1/s.
MaterialDeck original(MaterialDeck m) {
  m.law = Law::johnson_cook;
  m.density = 8960, m.specific_heat = 383;
  m.youngs_modulus = 124e9, m.poissons_ratio = 0.34; // handbook
  m.taylor_quinney = 0.9;                            // assumption
  m.A = 90e6, m.B = 292e6, m.n = 0.31, m.C = 0.025, m.m = 1.09;
  m.reference_rate = 1, m.reference_temperature = 298, m.melt_temperature = 1356;
  return m;
}

// Fitted to such cylinders instead: no rate, no softening.
MaterialDeck fitted_to_cylinders(MaterialDeck m) {
  m = original(m);
  m.density = 8930, m.youngs_modulus = 117e9, m.poissons_ratio = 0.35;
  m.A = 118e6, m.B = 484e6, m.n = 0.74, m.C = 0;
  m.m = 1, m.melt_temperature = 1e9;
  return m;
}

Deck bar(const std::string& fill, double speed) {
  Deck deck = read_deck(std::string(SWARF_SOURCE_DIR) + "/inputs/taylor_bar_copper" +
                        (fill == "hexes" ? "_hexes" : "") + ".toml");
  deck.materials[0] = original(deck.materials[0]);
  BodyDeck& b = deck.bodies[0];
  b.radius = 3.81e-3, b.height = 25.4e-3, b.temperature = 298, b.spacing = 7.62e-3 / 12;
  b.velocity = {0, 0, -speed};
  return deck;
}

struct Faults {
  std::string length, diameter; // why they fail
};

// Until the bar has left the wall: more than twice the time in which the speed covers the loss of length. A
// measured bar is reproduced by a law fitted to other tests: 5 % in length and 10 % in diameter, the usual
// misfit of such laws.
void shoot(const Shot& shot, const std::string& fill, const Deck& deck, const std::string& constants,
           const Faults& faults = {}) {
  const BarShape ours = run_taylor_bar(deck, 2.4 * (25.4 - shot.length) * 1e-3 / shot.speed);
  const double length =
      1e3 * *std::min_element(ours.length.begin(), ours.length.end()); // it leaves the wall then
  const double diameter = 2e3 * ours.radius.back();
  char run[96];
  std::snprintf(run, sizeof run, "%g m/s, 12 across, constants %s", shot.speed, constants.c_str());
  const std::string name = "6 Taylor bar, OFHC copper, " + fill;
  const std::string source = "measured: Johnson & Cook, Proc. 7th Int. Symp. Ballistics, 1983";
  report({name, "final length", run, shot.length, "mm", source, length, relative_error(length, shot.length),
          0.05, false, faults.length});
  report({name, "final diameter of the foot", run, shot.diameter, "mm", source, diameter,
          relative_error(diameter, shot.diameter), 0.1, false, faults.diameter});
  report_energy(name, run, ours);
}

const std::string misfit = "the law with these constants, not its solution: particles and hexes err alike, "
                           "and constants fitted to cylinders "
                           "(below) do not";

} // namespace

TEST(TaylorOfhcLong, Hexes) {
  for (const Shot& shot : shots)
    shoot(shot, "hexes", bar("hexes", shot.speed), "of 1983", {misfit, shot.speed < 190 ? misfit : ""});
}

TEST(TaylorOfhcLong, Particles) {
  for (const Shot& shot : shots)
    shoot(shot, "particles", bar("particles", shot.speed), "of 1983", {misfit, ""});
}

// Johnson & Holmquist (Evaluation of cylinder-impact test data for constitutive model constants, J. Appl.
// Phys. 64, 1988) fitted laws to these very shots, so this row tests the solution and not the law. Values as
// published code inputs have them for that paper.
TEST(TaylorOfhcLong, HexesWithFittedConstants) {
  for (const Shot& shot : shots) {
    Deck deck = bar("hexes", shot.speed);
    deck.materials[0] = fitted_to_cylinders(deck.materials[0]);
    shoot(shot, "hexes", deck, "fitted to cylinders, 1988");
  }
}
