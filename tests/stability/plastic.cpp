// Metal that flows far: pulled until it necks, sheared by ten times its height, and in the chip.
#include "tests/stability/watch.hpp"
#include "tests/verification/orthogonal_cut.hpp"
#include "tests/verification/plastic_strip.hpp"
#include "tests/verification/sheared_layer.hpp"
#include <cmath>

namespace swarf::stability {
namespace {

void use(const Formulation& f, Deck& deck) {
  deck.particles = default_deck().particles, deck.hexes = default_deck().hexes;
  f.apply(deck);
}

// Kernels of the initial frame keep their neighbours: how far apart these are says nothing.
bool has_order(const Simulation& simulation, const Formulation& f) {
  return simulation.scene().particles.count > 0 && f.follows;
}

void add_order(Outcome& o, const EvenOrder& order) {
  o.measures.push_back({"holes", order.holes});
  o.measures.push_back({"nearest", order.nearest});
}

} // namespace

// Hardens enough to stretch evenly all the way.
Outcome pull_metal(const Formulation& f) {
  using namespace plastic_strip;
  const Pull pull{24, 8, 0.5, stays_even, 0.15};
  Deck deck = strip(pull, f.fill);
  use(f, deck);
  Simulation simulation(deck);
  start_evenly(simulation.scene(), pull);
  Watch watch(simulation, dx);
  ForceBetween last(0.4, 0.5, pull);
  int parts = 1;
  watch.run(*deck.run.end_time, [&] {
    last.look(simulation.time(), watch.work());
    if (has_order(simulation, f)) parts = std::max(parts, count_parts(simulation.scene().particles, reach));
  });
  Outcome o = watch.result();
  o.measures.push_back({"pull_error", std::abs(last.stress() / last.exact(deck.materials[0], f.fill) - 1)});
  if (!has_order(simulation, f)) return o;
  o.measures.push_back({"pieces", double(parts - 1)});
  add_order(o, order(simulation.scene()));
  return o;
}

// From a lattice a fifth of a spacing out of order: in perfect order rows pass rows for ever.
Outcome shear_metal(const Formulation& f) {
  using namespace sheared_layer;
  const Shape layer{8, 10, 4, 1, 10};
  Deck deck = sheared(layer, f.fill);
  harden(deck.materials[0]);
  use(f, deck);
  Simulation simulation(deck);
  if (has_order(simulation, f)) disturb(simulation.scene(), 0.2);
  start_evenly(simulation.scene(), layer);
  Watch watch(simulation, dx);
  Middle middle(layer, deck.materials[0]);
  watch.run(layer.end(), [&] { middle.look(simulation.scene(), simulation.time()); });
  middle.finish(simulation.scene());
  Outcome o = watch.result();
  const HistorySample s = simulation.take_sample();
  o.measures.push_back({"strain_missing", std::abs(middle.strain / middle.exact_strain() - 1)});
  o.measures.push_back({"strain_spread", middle.spread});
  o.measures.push_back({"shear_error", std::abs(middle.stress / middle.exact_stress() - 1)});
  o.measures.push_back({"stabilisers", (s.viscous + s.hourglass) / s.external});
  if (has_order(simulation, f)) add_order(o, order(simulation.scene(), layer));
  return o;
}

namespace {

constexpr double chip_dx = 20.0 / 3 * um, depth = 40 * um, cut_length = 120 * um, cut_speed = 0.5;
constexpr double flowed = 0.3; // plastic strain from which on material is of the chip

// What has flowed, chip and finished surface.
EvenOrder order_of_chip(const Scene& scene) {
  const auto e = host_copy(scene.particles.points.equivalent_plastic_strain);
  SliceOrder::Slice slice{chip_dx, 0, 4 * chip_dx, 0, 0, {}};
  for (int i = 0; i < scene.particles.count; ++i) slice.counts.push_back(double(e(i)) > flowed);
  return SliceOrder(positions(scene.particles), slice).measure();
}

// Of the chip above the old surface: its mean plastic strain, over that of the shear plane: gamma / sqrt(3),
// gamma = cot(phi) + tan(phi - rake), from the speed at which the chip leaves (its thickness ratio r):
// tan(phi) = cos(rake) / (r - sin(rake)). Friction along the tool adds to it.
double share_of_shear(const Scene& scene) {
  using orthogonal_cut::rake;
  const auto x = host_copy(scene.particles.position), v = host_copy(scene.particles.velocity);
  const auto e = host_copy(scene.particles.points.equivalent_plastic_strain);
  double along = 0, strain = 0, n = 0;
  for (int i = 0; i < scene.particles.count; ++i) {
    if (x(i, 1) < depth + chip_dx || x(i, 1) > 2 * depth) continue;
    along += (double(v(i, 0)) - cut_speed) * -std::sin(rake) + double(v(i, 1)) * std::cos(rake);
    strain += double(e(i)), n += 1;
  }
  const double ratio = cut_speed / (along / n), phi = std::atan2(std::cos(rake), ratio - std::sin(rake));
  return strain / n / ((1 / std::tan(phi) + std::tan(phi - rake)) / std::sqrt(3.0));
}

} // namespace

Outcome fill_chip(const Formulation& f) {
  Deck deck = orthogonal_cut::orthogonal(cut_speed, depth, 0.18, chip_dx);
  use(f, deck);
  deck.bodies[0].size[0] = deck.bodies[1].size[0] = 200 * um;
  deck.run.end_time = cut_length / cut_speed;
  Simulation simulation(deck);
  Watch watch(simulation, chip_dx);
  EvenOrder worst{0, 1};
  double share = 0;
  int looks = 0;
  watch.run(*deck.run.end_time, [&] {
    if (simulation.time() < 0.75 * *deck.run.end_time) return;
    const EvenOrder now = order_of_chip(simulation.scene());
    worst = {std::max(worst.holes, now.holes), std::min(worst.nearest, now.nearest)};
    share += share_of_shear(simulation.scene()), ++looks;
  });
  Outcome o = watch.result();
  add_order(o, worst);
  o.measures.push_back({"shear_kept", share / looks});
  return o;
}

} // namespace swarf::stability
