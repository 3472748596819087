// Contact of bodies with the rigid tool: the penalty spring, Coulomb friction and the heat that it makes.
#include "tests/verification/case.hpp"
#include "tests/verification/point_masses.hpp"

using namespace swarf;
using namespace swarf::test;

namespace {

Deck on_a_wall(const BodyDeck& body) {
  Deck deck = default_deck();
  deck.bodies = {body};
  ToolDeck wall(ToolKind::wall);
  wall.normal = {0, 0, 1};
  deck.tool = wall;
  return deck;
}

// --- one particle and the spring

constexpr double edge = um, speed = 6; // m/s, a thousandth of the wave speed: penetrates a thousandth of edge

struct Rebound {
  double restitution, time; // of the contact, s
};

// Free flight before and after is straight, so the contact begins and ends where these lines cross the gap.
Rebound rebound(double stiffness, double clearance, double& k_over_m) {
  BodyDeck particle = block("particle", "particles", {0, 0, 0}, {edge, edge, edge}, edge);
  particle.velocity = {0, 0, -speed};
  Deck deck = on_a_wall(particle);
  deck.bodies[0].origin[2] = clearance;
  deck.tool->size = 20 * edge;
  deck.contact.stiffness = stiffness;
  Simulation simulation(deck);
  simulation.start();
  k_over_m = stiffness / (simulation.dt() * simulation.dt());
  advance(simulation, clearance / speed + 1.2 * pi / std::sqrt(k_over_m));
  const double z = double(host_copy(simulation.scene().particles.position)(0, 2)) - edge / 2;
  const double v = double(host_copy(simulation.scene().particles.velocity)(0, 2));
  return {v / speed, simulation.time() - z / v - clearance / speed};
}

// Relative errors, over all phases of the first touch within a step.
struct Worst {
  double restitution = 0, time = 0;
};
Worst worst_rebound(double stiffness) {
  Worst worst;
  const double dt = 0.3 * 1.2 * edge / 6000; // about: phases need no more
  for (int phase = 0; phase < 16; ++phase) {
    double k_over_m = 0;
    const Rebound r = rebound(stiffness, (2 + phase / 16.0) * dt * speed, k_over_m);
    worst.restitution = std::max(worst.restitution, std::abs(r.restitution - 1));
    worst.time = std::max(worst.time, std::abs(r.time * std::sqrt(k_over_m) / pi - 1));
  }
  return worst;
}

// --- a block that slides

struct Slide {
  double distance, time;      // until it rests, m, s
  double friction_work, heat; // J
  double kinetic;             // J, at the start
};

constexpr double v0 = 1, gravity = 10, friction = 0.5, share = 0.5;

// In equilibrium with its weight from the start: a load put on suddenly would make an elastic block hop.
void put_weight(const Scene& scene, double height) {
  const auto load = [](const MaterialPoints& points, const auto& depth) {
    const auto stress = host_copy(points.stress);
    const auto rho = host_copy(points.density);
    for (int i = 0; i < points.count; ++i) stress(i, 2) = Real(-gravity * double(rho(i)) * depth(i));
    Kokkos::deep_copy(points.stress, stress);
  };
  const auto x = host_copy(scene.particles.position), node = host_copy(scene.hexes.position);
  const auto corner = host_copy(scene.hexes.connectivity);
  load(scene.particles.points, [&](int i) { return height - double(x(i, 2)); });
  load(scene.hexes.points,
       [&](int e) { return height - 0.5 * double(node(corner(e, 0), 2) + node(corner(e, 4), 2)); });
}

// Stiffness over mass of a contact, 1/s2: of a particle that of the half of it below its centre, M area /
// gap, as far as the step allows it.
double stiffness_per_mass(const Deck& deck, const Simulation& simulation) {
  const double limit = deck.contact.stiffness / (simulation.dt() * simulation.dt());
  if (deck.bodies[0].fill != Fill::particles) return limit;
  const MaterialDeck& m = deck.materials[0];
  const double nu = m.poissons_ratio, a = *deck.bodies[0].spacing;
  const double M = m.youngs_modulus.value * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  return std::min(limit, 2 * M / (m.density * a * a));
}

// Into the springs by what carries the weight, `columns` times the mass of what touches.
void sink(const Scene& scene, double per_mass, double columns) {
  const Real depth = Real(columns * gravity / per_mass);
  for (const auto& [field, rows] : {std::pair(scene.particles.position, scene.particles.count),
                                    std::pair(scene.hexes.position, scene.hexes.nodes)}) {
    const auto x = host_copy(field);
    for (int i = 0; i < rows; ++i) x(i, 2) -= depth;
    Kokkos::deep_copy(field, x);
  }
}

// The block slides on a wall at rest, or the wall under a block at rest.
Slide slide(const std::string& fill, bool wall_moves) {
  const double a = 0.01;
  BodyDeck body = block("block", fill, {0, 0, 0}, {8 * a, 8 * a, 4 * a}, a);
  body.velocity = {wall_moves ? 0 : v0, 0, 0};
  Deck deck = on_a_wall(body);
  deck.materials[0].density = 1000, deck.materials[0].youngs_modulus = 1e8;
  deck.tool->size = 1, deck.tool->velocity = {wall_moves ? -v0 : 0, 0, 0};
  deck.contact.friction = friction, deck.contact.heat_to_workpiece = share;
  deck.run.gravity = {0, 0, -gravity};
  Simulation simulation(deck);
  const Scene& scene = simulation.scene();
  put_weight(scene, 4 * a);
  simulation.start();
  sink(scene, stiffness_per_mass(deck, simulation), fill == "particles" ? 4 : 8);
  double mass = 0;
  for (const PointMass& p : point_masses(scene)) mass += p.mass;
  Slide s{0, 0, 0, 0, 0.5 * mass * v0 * v0};
  const double wall = deck.tool->velocity[0];
  double before = v0, last = 0;
  advance(simulation, 0.25, [&] {
    double v = -wall;
    for (const PointMass& p : point_masses(scene)) v += p.mass / mass * double(p.v.x);
    if (s.time == 0) {
      const double dt = simulation.time() - last;
      s.distance += 0.5 * (before + v) * dt;
      if (v <= 0) s.time = last + dt * before / (before - v);
    }
    before = v, last = simulation.time();
  });
  s.friction_work = simulation.take_sample().frictional;
  for (const MaterialPoints& points : {scene.particles.points, scene.hexes.points}) {
    const auto m = host_copy(points.mass), T = host_copy(points.temperature);
    for (int i = 0; i < points.count; ++i)
      s.heat +=
          double(m(i)) * deck.materials[0].specific_heat.value * (double(T(i)) - deck.bodies[0].temperature);
  }
  return s;
}

} // namespace

TEST(Contact, ReboundsWithoutLoss) {
  const std::string name = "8 rebound of a particle", source = "exact: linear spring, pi sqrt(m/k)";
  // The error of the speed depends on where in a step the contact begins and ends; it is largest where it
  // lasts half a step more than whole steps.
  std::array<double, 3> step{}, restitution{}, time{};
  for (int k = 0; k < 3; ++k) {
    const double steps = 10 * std::pow(2, k) - 0.5; // of contact
    const double stiffness = 4 * std::pow(std::sin(pi / (2 * steps)), 2);
    const Worst worst = worst_rebound(stiffness);
    step[std::size_t(k)] = 1 / steps, restitution[std::size_t(k)] = worst.restitution,
    time[std::size_t(k)] = worst.time;
  }
  const Worst worst = worst_rebound(0.1);
  // The trapezoidal rule cuts off the ramp of the force where the contact begins and where it ends, at most
  // (omega dt)^2 / 8 of the speed each.
  const double allowed = 0.1 / 4;
  const std::string parameters = "stiffness 0.1, worst of 16 phases";
  report({name, "restitution", parameters, 1, "", source, 1 - worst.restitution, worst.restitution, allowed});
  report({name, "time of contact / pi sqrt(m/k)", parameters, 1, "", source, 1 - worst.time, worst.time,
          allowed});
  const std::string sweep = "contact of 9.5, 19.5 and 39.5 steps";
  report_order(name, "restitution", sweep, step, restitution, 2, 0.3, "central differences");
  report_order(name, "time of contact", sweep, step, time, 2, 0.3, "central differences");
}

TEST(Contact, SlidingBlockStops) {
  const double distance = v0 * v0 / (2 * friction * gravity), time = v0 / (friction * gravity);
  // The block is elastic: a quarter of its slowest period in shear is 0.1 % of the time.
  const double allowed = 0.01;
  const char* const flutter = "physical: an undamped elastic body that slides under Coulomb's law flutters "
                              "(Adams 1995, J. Appl. Mech. "
                              "62, 867); it hops, and what sticks and slips in turn is braked less. Hexes: "
                              "15 % at 10 MPa, 3 % at 1 GPa; "
                              "particles are damped a little by their viscosity";
  for (const char* fill : {"particles", "hexes"})
    for (const bool wall_moves : {false, true}) {
      const bool particles = std::string(fill) == "particles";
      if (!particles && wall_moves) continue;
      const std::string name = std::string("8 sliding block, ") + fill;
      const std::string parameters = wall_moves ? "8 x 8 x 4 cells, tool moves" : "8 x 8 x 4 cells";
      const Slide s = slide(fill, wall_moves);
      const auto row = [&](const std::string& what, double reference, const std::string& unit, double ours,
                           const std::string& fault = "") {
        report({name, what, parameters, reference, unit, "exact: Coulomb's law", ours,
                relative_error(ours, reference), allowed, false, fault});
      };
      row("distance until it rests", distance, "m", s.distance);
      row("time until it rests", time, "s", s.time, flutter);
      row("friction work / kinetic energy at the start", 1, "", s.friction_work / s.kinetic,
          particles ? "" : flutter);
      report({name, "heat in the block / (share x friction work)", parameters, 1, "",
              "exact: every joule is heat", s.heat / (share * s.friction_work),
              relative_error(s.heat, share * s.friction_work), 1e-9});
    }
}
