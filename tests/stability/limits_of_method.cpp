// How far a formulation may be driven: time step, mass factor, viscosity.
#include "tests/stability/watch.hpp"
#include <cmath>

namespace swarf::stability {
namespace {

Deck cube(const Formulation& f, int n, double a) {
  Deck deck = default_deck();
  f.apply(deck);
  deck.bodies = {block("cube", f.fill, {0, 0, 0}, {n * a, n * a, n * a}, a)};
  return deck;
}

void set_viscosity(Deck& deck, double linear) {
  deck.particles.viscosity_linear = deck.hexes.viscosity_linear = linear;
  deck.particles.viscosity_quadratic = deck.hexes.viscosity_quadratic = 2 * linear;
}

double speed_of_waves(const MaterialDeck& m) {
  const double nu = m.poissons_ratio;
  return std::sqrt(m.youngs_modulus.value * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / m.density);
}

// A cube shaken at random, every mode at once: 600 steps, in which a mode that grows by 2 % a step grows by
// 1e5.
bool keeps_bounded(Deck deck, double courant, long& steps) {
  deck.run.courant = courant;
  Simulation simulation(deck);
  const double a = *deck.bodies[0].spacing, speed = 1e-3 * speed_of_waves(deck.materials[0]);
  const auto index = block_index(least_corner(snapshot(simulation.scene())), a);
  set_velocity(simulation.scene(), [&](const Triple& x) {
    const LatticeIndex i = index(x);
    Triple v{};
    for (int d = 0; d < 3; ++d) v[std::size_t(d)] = speed * scatter(i[0], i[1], i[2], d);
    return v;
  });
  try {
    simulation.start();
    for (int k = 0; k < 600; ++k) {
      simulation.step(), ++steps;
      if (simulation.steps_to_check() > 0) continue;
      simulation.check();
      const HistorySample s = simulation.take_sample();
      if (!(s.kinetic + s.elastic < 2 * simulation.initial_kinetic())) return false;
    }
  } catch (const SimulationFault&) {
    return false;
  }
  return true;
}

double largest_courant(const Deck& deck, long& steps) {
  double largest = 0;
  for (int tenth = 3; tenth <= 12 && keeps_bounded(deck, 0.1 * tenth, steps); ++tenth) largest = 0.1 * tenth;
  return largest;
}

// A block of the workpiece of the cutting decks, 4 x 4 x 4 cells of 10 um, squeezed by 10 % at the cutting
// speed: the work done on it, J. Starts with the velocity of an even flow. A fault: NaN.
double work_of_squeezing(const Formulation& f, double mass_factor, double viscosity, Outcome& o) {
  const double a = 10 * um, speed = 0.5, height = 4 * a;
  Deck deck = cube(f, 4, a);
  deck.materials = read_deck(std::string(SWARF_SOURCE_DIR) + "/inputs/orthogonal_cutting.toml").materials;
  deck.bodies[0].material = deck.materials[0].name;
  deck.bodies[0].faces = {{"z_min", FaceKind::velocity, {0, 0, 0}},
                          {"z_max", FaceKind::velocity, {0, 0, -speed}}};
  deck.materials[0].conductivity = 0;
  deck.run.mass_factor = mass_factor, deck.run.courant = 0.5;
  if (viscosity >= 0) set_viscosity(deck, viscosity);
  Simulation simulation(deck);
  set_velocity(simulation.scene(), [&](const Triple& x) {
    const double rate = speed / height;
    return Triple{0.5 * rate * (x[0] - height / 2), 0.5 * rate * (x[1] - height / 2), -rate * x[2]};
  });
  const double end = 0.1 * height / speed;
  try {
    simulation.start();
    while (simulation.time() < end) {
      simulation.step(), ++o.steps;
      if (simulation.steps_to_check() <= 0 || simulation.time() >= end) simulation.check();
    }
  } catch (const SimulationFault&) {
    return std::nan("");
  }
  return simulation.take_sample().external * end / simulation.time(); // the last step may pass the end
}

} // namespace

Outcome raise_courant(const Formulation& f) {
  Outcome o;
  o.measures = {{"courant", largest_courant(cube(f, 6, um), o.steps)}};
  return o;
}

Outcome raise_mass(const Formulation& f) {
  Outcome o;
  const double natural = work_of_squeezing(f, 1, -1, o);
  double largest = 1, at_decks = 0;
  bool held = std::isfinite(natural);
  for (int power = 1; power <= 6; ++power) {
    const double change = std::abs(work_of_squeezing(f, std::pow(10, power), -1, o) / natural - 1);
    held = held && change <= 0.1;
    if (held) largest = std::pow(10, power);
    if (power == 4) at_decks = change;
  }
  o.measures = {{"mass_change", at_decks}, {"mass_factor", largest}};
  return o;
}

Outcome raise_viscosity(const Formulation& f) {
  Outcome o;
  const double factor = 1e4, none = work_of_squeezing(f, factor, 0, o);
  double most = 0, shipped = 0;
  for (const double viscosity : {0.5, 1.0, 2.0}) {
    const double change = std::abs(work_of_squeezing(f, factor, viscosity, o) / none - 1);
    most = change <= most ? most : change; // a NaN stays
    if (viscosity == 0.5) shipped = change;
  }
  Deck viscous = cube(f, 6, um);
  set_viscosity(viscous, 2);
  o.measures = {{"viscosity_shipped", shipped},
                {"viscosity_change", most},
                {"courant_viscous", largest_courant(viscous, o.steps)}};
  return o;
}

} // namespace swarf::stability
