// Elastic bodies that must stay whole and smooth: tension, zero-energy modes, rotation, disorder.
#include "tests/stability/watch.hpp"
#include "tests/verification/clamped_beam.hpp"
#include "tests/verification/pulled_strip.hpp"
#include "tests/verification/rubber_ring.hpp"
#include "tests/verification/spinning_plate.hpp"

namespace swarf::stability {
namespace {

// Particles only: neighbours torn, at most at any time, and parts that have come off.
struct Whole {
  std::size_t all = 0;
  int torn = 0, parts = 1;
  rubber_ring::Bonds bonds;
  double spacing;
  Whole(const Scene& scene, double a) : bonds(scene, scene.particles.count > 0 ? a : 0, true), spacing(a) {
    all = bonds.count();
  }
  void look(const Scene& scene) {
    if (all == 0) return;
    torn = std::max(torn, bonds.torn(scene));
    parts = std::max(parts, count_parts(scene.particles, 1.6 * spacing));
  }
  void add_to(Outcome& o) const {
    if (all == 0) return;
    o.measures.push_back({"torn", double(torn) / double(all)});
    o.measures.push_back({"fragments", double(parts - 1)});
  }
};

Outcome stay_whole(Simulation& simulation, double spacing, const Lattice& lattice, double end,
                   double stretch = 1) {
  Whole whole(simulation.scene(), spacing);
  whole.spacing *= stretch;
  Watch watch(simulation, spacing, lattice);
  watch.run(end, [&] { whole.look(simulation.scene()); });
  Outcome o = watch.result();
  whole.add_to(o);
  return o;
}

Lattice lattice_of(const Scene& scene, double spacing) {
  const auto at = snapshot(scene);
  return Lattice(at, block_index(least_corner(at), spacing));
}

constexpr int along = 24, across = 8; // of the strip

Simulation strip_of(const Formulation& f, double pull) {
  Deck deck = pulled_strip::strip(f.fill, pull, along, across);
  f.apply(deck);
  return Simulation(deck);
}

} // namespace

Outcome collide_ring(const Formulation& f) {
  using namespace rubber_ring;
  constexpr int thick = 4;
  Deck deck = rubber();
  f.apply(deck);
  deck.bodies = {ring_of(f.fill, thick)};
  put_wall(deck);
  Simulation simulation(deck);
  const double a = (outer - inner) / thick;
  const int around = (*deck.bodies[0].cells)[0];
  const double half = f.fill == "particles" ? 0.5 : 0;
  const Lattice lattice(
      snapshot(simulation.scene()),
      [&](const Triple& x) {
        const int turn = int(std::lround(std::atan2(x[1], x[0]) / (2 * pi) * around - half));
        return LatticeIndex{(turn % around + around) % around,
                            int(std::lround((std::hypot(x[0], x[1]) - inner) / a - half)),
                            int(std::lround(x[2] / a - half))};
      },
      around);
  return stay_whole(simulation, a, lattice, ring_time);
}

// Gray, Monaghan & Swift (2001): the tip starts at 0.05 c0.
Outcome bend_plate(const Formulation& f) {
  clamped_beam::Beam beam = clamped_beam::plate();
  const double nu = beam.material.poissons_ratio, thick = 4;
  const double c0 =
      std::sqrt(beam.material.youngs_modulus.value / (3 * (1 - 2 * nu)) / beam.material.density);
  Deck deck = clamped_beam::clamped(default_deck(), beam, f.fill, int(thick));
  deck.run.courant = default_deck().run.courant;
  f.apply(deck);
  Simulation simulation(deck);
  set_velocity(simulation.scene(), [&](const Triple& x) {
    return Triple{0, x[0] > 0 ? 0.05 * c0 * clamped_beam::mode_shape(x[0] / beam.length) : 0, 0};
  });
  const double a = beam.thickness / thick, period = 0.2551; // s, of small oscillations
  return stay_whole(simulation, a, lattice_of(simulation.scene(), a), period);
}

Outcome pull_strip(const Formulation& f) {
  using namespace pulled_strip;
  const double speed = 0.005 * wave, rate = speed / (along * a / 2), strain = 0.2;
  Simulation simulation = strip_of(f, speed);
  set_velocity(simulation.scene(), [&](const Triple& x) {
    return Triple{rate * x[0], -nu / (1 - nu) * rate * x[1], 0};
  });
  return stay_whole(simulation, a, lattice_of(simulation.scene(), a), strain / rate, 1 + strain);
}

namespace {

// An endless block in which a field alternates from point to point: at a surface the velocity gradient would
// see it. Hexes without the viscosity of shocks, which is not what should damp it.
struct Checkered {
  static constexpr double a = pulled_strip::a;
  Simulation simulation;
  Lattice lattice;
  std::function<LatticeIndex(const Triple&)> index;
  static Deck deck_of(const Formulation& f) {
    Deck deck = pulled_strip::strip(f.fill, 0, 12, 12);
    deck.bodies[0].faces.clear();
    hold(deck.bodies[0], "periodic", {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"});
    f.apply(deck);
    deck.particles.viscosity_quadratic = 0;
    deck.hexes.viscosity_linear = deck.hexes.viscosity_quadratic = 0;
    return deck;
  }
  explicit Checkered(const Formulation& f)
      : simulation(deck_of(f)), lattice(lattice_of(simulation.scene(), a)),
        index(block_index(least_corner(snapshot(simulation.scene())), a)) {}
  double sign(const Triple& x) const {
    const LatticeIndex i = index(x);
    return (i[0] + i[1]) % 2 == 0 ? 1 : -1;
  }
  void seed(double speed) const {
    set_velocity(simulation.scene(), [&](const Triple& x) {
      return Triple{speed * sign(x), speed * sign(x), 0};
    });
  }
};

// Driven to a twentieth of the spacing in twenty steps and let go at rest: does anything hold it?
double mode_that_stays(const Formulation& f, double end, Outcome& o) {
  Checkered block(f);
  Simulation& simulation = block.simulation;
  const Scene& scene = simulation.scene();
  const std::vector<PointState> start = snapshot(scene);
  const double goal = 0.05 * Checkered::a;
  const auto amplitude = [&] {
    const auto at = snapshot(scene);
    double sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t d = 0; d < 2; ++d) sum += block.sign(start[i].x) * (at[i].x[d] - start[i].x[d]);
    return sum / (2.0 * double(at.size()));
  };
  simulation.start();
  for (int k = 0; k < 20; ++k) { // signs are those of the lattice: seeds stay within half a spacing of it
    block.seed(goal / (20 * simulation.dt()));
    Kokkos::deep_copy(scene.particles.force, Real(0)), Kokkos::deep_copy(scene.hexes.force, Real(0));
    simulation.step();
    if (simulation.steps_to_check() <= 0) simulation.check();
  }
  block.seed(0);
  const double reached =
      std::abs(amplitude()); // less than the goal where points do not move as they are told
  double sum = 0;
  int looks = 0;
  try {
    run_until(simulation, end, [&] {
      if (simulation.time() > 0.5 * end) sum += amplitude(), ++looks;
    });
  } catch (const SimulationFault& fault) {
    o.fault = fault.what();
  }
  o.steps += simulation.step_count();
  return std::abs(sum / looks) / reached;
}

} // namespace

Outcome shake_block(const Formulation& f) {
  const double a = Checkered::a, wave = pulled_strip::wave, seed = 1e-3 * wave, end = 300 * a / wave;
  Checkered block(f);
  block.seed(seed);
  Watch watch(block.simulation, a, block.lattice);
  watch.run(end);
  Outcome o = watch.result();
  // All energy is in the fastest modes, of which central differences keep (omega dt / 2)^2: no measure here.
  o.measures = {{"mode_left", watch.sawtooth * a / (seed * end)}};
  o.measures.push_back({"mode_stays", mode_that_stays(f, end, o)});
  return o;
}

Outcome spin_plate(const Formulation& f) {
  using namespace spinning_plate;
  constexpr int n = 16;
  Deck deck = plate(f.fill, n);
  f.apply(deck);
  Simulation simulation(deck);
  set_velocity(simulation.scene(), [](const Triple& x) { return Triple{-omega * x[1], omega * x[0], 0}; });
  const double first = double(angular_momentum(simulation.scene()).z);
  Outcome o = stay_whole(simulation, side / n, lattice_of(simulation.scene(), side / n), turn);
  o.measures.push_back(
      {"angular_momentum", std::abs(double(angular_momentum(simulation.scene()).z) / first - 1)});
  return o;
}

// A free plate that stretches to and fro by 2 %, its points a fifth of a spacing off their lattice.
Outcome disturb_lattice(const Formulation& f) {
  constexpr int n = 12;
  const double a = spinning_plate::side / n;
  Deck deck = spinning_plate::plate(f.fill, n);
  f.apply(deck);
  Simulation simulation(deck);
  const Scene& scene = simulation.scene();
  const Lattice lattice = lattice_of(scene, a);
  const auto index = block_index(least_corner(snapshot(scene)), a);
  const MaterialDeck& m = deck.materials[0];
  const double shear_speed = std::sqrt(m.youngs_modulus.value / (2 * (1 + m.poissons_ratio)) / m.density);
  const double rate = 0.02 * pi * shear_speed / spinning_plate::side;
  set_velocity(scene, [&](const Triple& x) { return Triple{rate * x[0], -rate * x[1], 0}; });
  const bool particles = f.fill == "particles"; // nodes that a period couples move alike
  const VectorField field = particles ? scene.particles.position : scene.hexes.position;
  const auto x = host_copy(field);
  for (int i = 0; i < (particles ? scene.particles.count : scene.hexes.nodes); ++i) {
    const LatticeIndex at = index({double(x(i, 0)), double(x(i, 1)), double(x(i, 2))});
    for (int d = 0; d < (particles ? 3 : 2); ++d)
      x(i, d) += Real(0.2 * a * scatter(at[0], at[1], particles ? at[2] : 0, d));
  }
  Kokkos::deep_copy(field, x);
  Watch watch(simulation, a, lattice);
  if (!particles) { // the mass of the hex as it is now, or its energy would be another's
    const auto mass = host_copy(scene.hexes.points.mass), volume = host_copy(scene.hexes.volume),
               rho = host_copy(scene.hexes.points.density);
    for (int e = 0; e < scene.hexes.points.count; ++e) mass(e) = rho(e) * volume(e);
    Kokkos::deep_copy(scene.hexes.points.mass, mass);
  }
  watch.run(6 * spinning_plate::side / shear_speed);
  Outcome o = watch.result();
  o.measures.push_back({"noise", watch.noise()});
  return o;
}

} // namespace swarf::stability
