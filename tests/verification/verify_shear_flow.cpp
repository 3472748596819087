// Ti-6Al-4V in even shear between two plates that also press it: a velocity field without anything that the
// gradients do not see. What the hourglass forces take here is made by the lattice, of which rows pass rows.
#include "tests/verification/case.hpp"
#include "tests/verification/drive.hpp"

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double dx = 10 * um, speed = 0.5, gamma_end = 2, squeeze = 0.015;
constexpr int along = 8, high = 12, deep = 4;

// As the cutting decks, but isothermal: softening would gather the shear in a band.
Deck sheared() {
  Deck deck = read_deck(std::string(SWARF_SOURCE_DIR) + "/inputs/orthogonal_cutting.toml");
  MaterialDeck& mat = deck.materials[0];
  mat.taylor_quinney = 0, mat.conductivity = 0;
  const double height = high * dx, end = gamma_end * height / speed, press = squeeze * height / end;
  deck.bodies = {block("layer", "particles", {0, 0, 0}, {along * dx, height, deep * dx}, dx)};
  BodyDeck& layer = deck.bodies[0];
  layer.material = mat.name, layer.temperature = mat.reference_temperature;
  layer.faces = {{"y_min", "velocity", {-speed / 2, press / 2, 0}},
                 {"y_max", "velocity", {speed / 2, -press / 2, 0}}};
  hold(layer, "periodic", {"x_min", "x_max", "z_min", "z_max"});
  deck.tool.reset();
  deck.output.force_scale = 1;
  deck.run.end_time = end;
  return deck;
}

} // namespace

TEST(ShearFlow, GivesTheHourglassForcesNothing) {
  Simulation simulation(sheared());
  const double height = high * dx, rate = speed / height;
  set_velocity(simulation.scene(), [&](const Triple& x) { return Triple{rate * (x[1] - height / 2), 0, 0}; });
  simulation.start();
  run_until(simulation, gamma_end / rate, [] {});
  const HistorySample s = simulation.sample();
  report(
      {"5 shear between plates, particles", "work of viscosity and hourglass forces / external work",
       "Ti-6Al-4V, isothermal, shear 2 under a pressure that rises to 1.7 GPa, 8 x 12 x 4 particles, as the "
       "cutting decks",
       0, "", "a linear velocity field has no part that the velocity gradients do not see",
       (s.viscous + s.hourglass) / s.external, (s.viscous + s.hourglass) / s.external, 0.01, true});
}
