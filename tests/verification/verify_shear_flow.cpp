// Even shear between two plates: a velocity field without anything that the gradients do not see. What the
// hourglass forces take here is made by the lattice, of which rows pass rows.
#include "tests/verification/case.hpp"
#include "tests/verification/sheared_layer.hpp"

using namespace swarf;
using namespace swarf::test;
using namespace swarf::test::sheared_layer;

TEST(ShearFlow, GivesTheHourglassForcesNothing) {
  const Shape layer{8, 12, 4, 0.5, 2};
  Simulation simulation(sheared(layer));
  start_evenly(simulation.scene(), layer);
  simulation.start();
  run_until(simulation, layer.end(), [] {});
  const HistorySample s = simulation.take_sample();
  report(
      {"5 shear between plates, particles", "work of viscosity and hourglass forces / external work",
       "Ti-6Al-4V, isothermal, shear 2 under a pressure that rises to 1.7 GPa, 8 x 12 x 4 particles, as the "
       "cutting decks",
       0, "", "a linear velocity field has no part that the velocity gradients do not see",
       (s.viscous + s.hourglass) / s.external, (s.viscous + s.hourglass) / s.external, 0.01, true});
}

namespace {

// Reasons why rows fail, by what they are of; empty where they pass.
struct Faults {
  std::string strain, stress, spread, work, nearest;
};

// Ten times its height: every row of particles passes a hundred others. From a lattice, or from one that is
// out of order by up to a fifth of the spacing.
void shear_far(bool order_at_start, const Faults& fault) {
  const Shape layer{8, 12, 4, 0.5, 10};
  Deck deck = sheared(layer);
  harden(deck.materials[0]);
  Simulation simulation(deck);
  if (!order_at_start) disturb(simulation.scene(), 0.2);
  start_evenly(simulation.scene(), layer);
  Middle middle(layer, deck.materials[0]);
  simulation.start();
  double residual = 0;
  advance(simulation, layer.end(), [&] {
    middle.look(simulation.scene(), simulation.time());
    residual = std::max(residual, std::abs(simulation.take_sample().residual));
  });
  middle.finish(simulation.scene());
  const HistorySample s = simulation.take_sample();
  const EvenOrder now = order(simulation.scene(), layer);
  const std::string name =
      std::string("5 shear to 10 between plates, particles") + (order_at_start ? "" : " out of order");
  const std::string run =
      "linear hardening, 1 GPa + 0.2 GPa e_p, pressed up to 1.7 GPa, 8 x 12 x 4 particles, "
      "as the cutting decks; three rows from the plates";
  const std::string law = "exact: J2, gamma = sqrt(3) e_p + tau / G, tau = (1 GPa + 0.2 GPa e_p) / sqrt(3)";
  const double work = (s.viscous + s.hourglass) / s.external;
  report({name, "mean plastic strain", run, middle.exact_strain(), "", law, middle.strain,
          relative_error(middle.strain, middle.exact_strain()), 0.02, false, fault.strain});
  report({name, "shear stress, mean of the last tenth", run, middle.exact_stress(), "Pa", law, middle.stress,
          relative_error(middle.stress, middle.exact_stress()), 0.03, false, fault.stress});
  report({name, "plastic strain, standard deviation / mean", run, 0, "", "exact: even", middle.spread,
          middle.spread, 0.05, true, fault.spread});
  report({name, "work of viscosity and hourglass forces / external work", run, 0, "",
          "a linear velocity field has no part that the velocity gradients do not see", work, work, 0.01,
          true, fault.work});
  report({name, "nearest neighbour, 5th percentile / spacing", run, 1, "", "cubic lattice", now.nearest,
          std::max(0.0, 1 - now.nearest), 0.25, true, fault.nearest});
  report({name, "worst energy residual / external work", run, 0, "", "energy balance", residual / s.external,
          residual / s.external, 0.01, true});
  report({name, "work lost by shifting / external work", run, 0, "", "even fields have nothing to lose",
          s.shifting / s.external, std::abs(s.shifting / s.external), 0.01, true});
  report({name, "share of the inside farther than 1.1 spacings from every particle", run, 0, "",
          "no point of a cubic lattice is farther than 0.87", now.holes, now.holes, 0.01, true});
}

// Of the whole layer's plastic strain nothing is missing: the law makes all but 0.5
// % of the plastic work of it.
const std::string spreads = "the middle has changed particles or values with the rows near the plates, which "
                            "are strained less";

} // namespace

TEST(ShearFlow, StaysEvenToTen) { shear_far(true, {spreads, "", "", "", ""}); }
TEST(ShearFlow, FromDisorderToTen) { shear_far(false, {spreads, "", "", "", ""}); }
