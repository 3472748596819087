// Contact of bodies with each other: momentum, restitution and friction, whatever they are filled with.
#include "tests/verification/case.hpp"
#include "tests/verification/point_masses.hpp"
#include <fmt/format.h>

using namespace swarf;
using namespace swarf::test;

namespace {

struct Fills {
  const char *first, *second;
  std::string text() const { return fmt::format("{} on {}", second, first); }
};
const Fills all_fills[] = {{"hexes", "hexes"}, {"hexes", "particles"}, {"particles", "hexes"}};

Deck between(const Fills& fills, double first_spacing, double second_spacing, const Triple& first,
             const Triple& second, double gap) {
  Deck deck = default_deck();
  deck.bodies = {block("first", fills.first, {0, 0, -first[2]}, first, first_spacing),
                 block("second", fills.second, {0, 0, gap}, second, second_spacing)};
  deck.bodies[1].line = 14;
  return deck;
}

struct OfBodies {
  Vector3 momentum{0, 0, 0}, first{0, 0, 0}, second{0, 0, 0};
  double mass_first = 0, mass_second = 0, largest = 0;
};

// Nodes of the first body come first; particles are told apart by their body.
OfBodies sums(const Scene& scene) {
  OfBodies s;
  const auto add = [&](bool first, double mass, const Vector3& v) {
    (first ? s.first : s.second) = (first ? s.first : s.second) + Real(mass) * v;
    (first ? s.mass_first : s.mass_second) += mass;
    s.momentum = s.momentum + Real(mass) * v, s.largest += mass * double(norm(v));
  };
  const Particles& p = scene.particles;
  const auto m = host_copy(p.points.mass);
  const auto v = host_copy(p.velocity);
  const auto body = host_copy(p.body);
  for (int i = 0; i < p.count; ++i) add(body(i) == 0, double(m(i)), load_vector(v, i));
  const HexMesh& h = scene.hexes;
  const auto corner = host_copy(h.connectivity);
  const auto hex_body = host_copy(scene.hex_body);
  std::vector<int> of_node(std::size_t(h.nodes), 0);
  for (int e = 0; e < h.points.count; ++e)
    for (int a = 0; a < 8; ++a) of_node[std::size_t(corner(e, a))] = hex_body(e);
  const auto node_m = host_copy(h.mass);
  const auto node_v = host_copy(h.velocity);
  for (int a = 0; a < h.nodes; ++a)
    add(of_node[std::size_t(a)] == 0, double(node_m(a)), load_vector(node_v, a));
  return s;
}

} // namespace

// Blocks of unequal cells that meet askew, with friction: what one gains the other loses.
TEST(Bodies, MomentumToRoundOff) {
  for (const Fills& fills : all_fills) {
    Deck deck =
        between(fills, um, 0.7 * um, {8 * um, 8 * um, 4 * um}, {4.2 * um, 4.2 * um, 2.8 * um}, 0.3 * um);
    deck.bodies[1].origin[0] = 1.37 * um, deck.bodies[1].origin[1] = 2.11 * um;
    deck.bodies[1].velocity = {70, 30, -100};
    deck.contact.friction = 0.3;
    Simulation simulation(deck);
    simulation.start();
    const OfBodies before = sums(simulation.scene());
    advance(simulation, 1.5 * 0.3 * um / 100 + 4 * um / 6000);
    const OfBodies after = sums(simulation.scene());
    const double passed = double(norm(after.first - before.first)), scale = before.largest;
    const std::string name = "16 bodies that meet, " + fills.text();
    report({name, "share of the momentum that passes", "unequal cells, friction 0.3", 1, "", "it is felt",
            passed / scale, passed > 0.05 * scale ? 0.0 : 1.0, 0.5, true});
    const double lost = double(norm(after.momentum - before.momentum)) / scale;
    report({name, "momentum that is lost", "unequal cells, friction 0.3", 0, "", "Newton's third law", lost,
            lost, 1e-12, true});
    const HistorySample s = (simulation.check(), simulation.take_sample());
    const double given = simulation.initial_kinetic();
    report({name, "energy that is missing", "unequal cells, friction 0.3", 0, "", "the first law",
            s.residual / given, std::abs(s.residual) / given, 0.01, true});
  }
}

// Bars in uniaxial strain, one at rest, of equal material. Waves of constant strain run through both and the
// bars part when they are back: of equal bars the second takes all the speed, and of a bar of half the length
// the first comes to rest, which leaves half of the speed between the centres (Saint-Venant 1867).
TEST(Bodies, BarsThatMeet) {
  constexpr int across = 3;
  for (const Fills& fills : all_fills)
    for (const int ratio : {1, 2}) {
      const double a = 1 * um, length = 20 * a, speed = 6; // a thousandth of the wave speed
      Deck deck = between(fills, a, a, {across * a, across * a, ratio * length},
                          {across * a, across * a, length}, 1e-3 * a);
      for (BodyDeck& body : deck.bodies) hold(body, "symmetric", {"x_min", "x_max", "y_min", "y_max"});
      deck.bodies[1].velocity = {0, 0, -speed};
      Simulation simulation(deck);
      simulation.start();
      const double c = double(longitudinal_wave_speed(host_copy(simulation.scene().materials)(0)));
      advance(simulation, 1.3 * 2 * ratio * length / c);
      const OfBodies s = sums(simulation.scene());
      const double first = double(s.first.z) / s.mass_first, second = double(s.second.z) / s.mass_second;
      report({"16 bars that meet, " + fills.text(), "speed at which they part / speed at which they meet",
              fmt::format("20 cells against {}", 20 * ratio), 1.0 / ratio, "", "Saint-Venant 1867",
              (second - first) / speed, std::abs((second - first) / speed - 1.0 / ratio), 0.05, true});
      const HistorySample sample = (simulation.check(), simulation.take_sample());
      report({"16 bars that meet, " + fills.text(), "energy that is missing",
              fmt::format("20 cells against {}", 20 * ratio), 0, "", "the first law",
              sample.residual / simulation.initial_kinetic(),
              std::abs(sample.residual) / simulation.initial_kinetic(), 0.01, true});
    }
}
