// Orthogonal cutting, coarse: the shear and the contact that the program is for.
#include "tests/stability/watch.hpp"
#include "tests/verification/orthogonal_cut.hpp"
#include "tests/verification/read_table.hpp"
#include <cmath>

namespace swarf::stability {
namespace {

constexpr double dx = 10 * um, depth = 40 * um, length = 150 * um;

// Hexes: the whole workpiece is one body of them.
Deck scene(const Formulation& f, double speed, double mass_factor) {
  Deck deck = orthogonal_cut::orthogonal(speed, depth, 0.18, dx);
  deck.particles = default_deck().particles, deck.hexes = default_deck().hexes;
  f.apply(deck);
  BodyDeck &zone = deck.bodies[0], &bulk = deck.bodies[1];
  zone.size[0] = bulk.size[0] = 240 * um;
  if (f.fill == "hexes") {
    bulk.spacing = dx;
    bulk.size[1] += zone.size[1];
    deck.bodies.erase(deck.bodies.begin());
  }
  deck.run.end_time = length / speed;
  deck.run.mass_factor = mass_factor;
  return deck;
}

// Shares of the particles inside the tool and without any neighbour, and how far pressures differ from the
// mean of their neighbours.
struct Chip {
  double leaked = 0, stray = 0, noise = 0;
  void look(const Simulation& simulation, double yield) {
    const Particles& p = simulation.scene().particles;
    if (p.count == 0) return;
    const auto x = host_copy(p.position);
    const auto s = host_copy(p.points.stress);
    const auto pressure = [&](int i) { return -(s(i, 0) + s(i, 1) + s(i, 2)) / 3; };
    int lone = 0;
    double square = 0;
    for (int i = 0; i < p.count; ++i) {
      double sum = 0;
      int neighbors = 0;
      for (int j = 0; j < p.count; ++j) {
        const double r = std::hypot(x(i, 0) - x(j, 0), x(i, 1) - x(j, 1), x(i, 2) - x(j, 2));
        if (i != j && r < 1.6 * dx) sum += pressure(j), ++neighbors;
      }
      lone += neighbors == 0;
      if (neighbors > 0) square += std::pow(pressure(i) - sum / neighbors, 2);
    }
    leaked = std::max(leaked, double(simulation.leaked_particles()) / p.count);
    stray = std::max(stray, double(lone) / p.count);
    noise = std::max(noise, std::sqrt(square / p.count) / yield);
  }
};

// The measured force; the mean over the second half of the cut.
double measured() {
  const Table table = read_table("ti64_orthogonal_cutting.csv");
  for (std::size_t r = 0; r < table.rows.size(); ++r)
    if (table.rows[r][0] == 30 && table.rows[r][1] == 40) return table.column("Fc_lam0_exp")[r];
  throw std::runtime_error("no such row");
}

Outcome run(const Formulation& f, double speed, double mass_factor, bool compare) {
  const Deck deck = scene(f, speed, mass_factor);
  const double end = *deck.run.end_time;
  Simulation simulation(deck);
  Watch watch(simulation, dx);
  Chip chip;
  // Work is the sum of the forces along the way: no sample is missed.
  double work[2]{}, at[2]{};
  watch.run(end, [&] {
    chip.look(simulation, deck.materials[0].A);
    const int half = simulation.time() < 0.5 * end ? 0 : 1;
    work[half] = watch.work(), at[half] = simulation.time();
  });
  Outcome o = watch.result();
  if (compare) {
    const double force = (work[1] - work[0]) / (speed * (at[1] - at[0])) * deck.output.force_scale;
    o.measures.push_back({"force_error", std::abs(force / measured() - 1)});
  }
  if (f.fill == "particles") {
    o.measures.push_back({"leaked", chip.leaked});
    o.measures.push_back({"stray", chip.stray});
    o.measures.push_back({"pressure_noise", chip.noise});
  }
  return o;
}

} // namespace

Outcome cut(const Formulation& f) { return run(f, 0.5, 1e4, true); }
Outcome cut_fast(const Formulation& f) { return run(f, 5, 1e4, false); }

} // namespace swarf::stability
