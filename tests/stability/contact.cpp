// A block on a wall, fast; the same scene from millimetres to nanometres; a particle that leaves the others.
#include "tests/stability/watch.hpp"
#include <cmath>

namespace swarf::stability {
namespace {

constexpr int n = 6;
constexpr double wave = 6000; // m/s, about

// Thrown at a wall just below it.
Deck thrown(const Formulation& f, double a, const Triple& velocity) {
  Deck deck = default_deck();
  f.apply(deck);
  deck.bodies = {block("block", f.fill, {0, 0, 0.01 * a}, {n * a, n * a, n * a}, a)};
  deck.bodies[0].velocity = velocity;
  deck.tool = ToolDeck(ToolKind::wall);
  deck.tool->normal = {0, 0, 1}, deck.tool->size = 40 * n * a;
  deck.contact.friction = 0.5;
  return deck;
}

} // namespace

Outcome hit_wall(const Formulation& f) {
  Simulation simulation(thrown(f, um, {0.005 * wave, 0, -0.01 * wave}));
  const auto at = snapshot(simulation.scene());
  Watch watch(simulation, um, Lattice(at, block_index(least_corner(at), um)));
  double leaked = 0;
  watch.run(6 * n * um / wave,
            [&] { leaked = std::max(leaked, double(simulation.leaked_particles()) / double(at.size())); });
  Outcome o = watch.result();
  o.measures.push_back({"leaked", leaked});
  return o;
}

Outcome scale_scene(const Formulation& f) {
  Outcome o;
  std::vector<PointState> first;
  double worst = 0, first_scale = 0;
  for (const int power : {-10, -20, -24, -30}) { // spacings of 1 mm, 1 um, 60 nm, 1 nm
    const double a = std::ldexp(1.0, power);
    Deck deck = thrown(f, a, {0.01 * wave, 0, -0.02 * wave});
    deck.materials[0].law = Law::linear_hardening;
    deck.materials[0].yield_stress = 900e6, deck.materials[0].hardening_modulus = 1e9;
    deck.materials[0].taylor_quinney = 0.9;
    Simulation simulation(deck);
    simulation.start();
    try {
      for (int k = 0; k < 300; ++k) {
        simulation.step(), ++o.steps;
        if (simulation.steps_to_check() <= 0) simulation.check();
      }
    } catch (const SimulationFault& fault) {
      o.fault = fault.what();
      return o;
    }
    const auto at = snapshot(simulation.scene());
    if (first.empty()) first = at, first_scale = a;
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t d = 0; d < 3; ++d) {
        const double off = std::abs(at[i].x[d] / a - first[i].x[d] / first_scale);
        worst = off <= worst ? worst : off;
      }
  }
  o.measures = {{"scale_error", worst}};
  return o;
}

// Half a spacing off the lattice already, at half the speed of waves: it must not come back, nor gain.
Outcome lose_particle(const Formulation& f) {
  constexpr int m = 5;
  const double speed = 0.5 * wave;
  Deck deck = default_deck();
  f.apply(deck);
  deck.bodies = {block("body", "particles", {0, 0, 0}, {m * um, m * um, m * um}, um),
                 block("lone", "particles", {2 * um, 2 * um, (m + 0.5) * um}, {um, um, um}, um)};
  deck.bodies[1].velocity = {0, 0, speed};
  Simulation simulation(deck);
  Watch watch(simulation, um);
  double fastest = 0;
  watch.run(20 * um / speed, [&] {
    for (const PointMass& p : point_masses(simulation.scene()))
      if (p.name == m * m * m) fastest = std::max(fastest, double(norm(p.v)));
  });
  Outcome o = watch.result();
  o.measures.push_back({"gain", std::max(0.0, fastest / speed - 1)});
  return o;
}

} // namespace swarf::stability
