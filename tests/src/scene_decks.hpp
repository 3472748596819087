// Decks made in memory for the tests of the scene.
#pragma once
#include "src/scene/scene.hpp"
#include <numbers>

namespace swarf::test {

inline constexpr double pi = std::numbers::pi;
inline constexpr double um = 1e-6;
inline constexpr double degree = pi / 180;

inline MaterialDeck titanium() {
  MaterialDeck m(Law::elastic);
  m.name = "Ti";
  m.density = 4430, m.youngs_modulus = 110e9, m.poissons_ratio = 0.33, m.specific_heat = 526.3;
  return m;
}

inline Deck empty_deck() {
  Deck deck;
  deck.file = "test.toml";
  deck.materials = {titanium()};
  return deck;
}

inline BodyDeck body(const std::string& name, const std::string& shape, const std::string& fill) {
  BodyDeck b(value_of_word<BodyShape>(shape), value_of_word<Fill>(fill));
  b.name = name, b.material = "Ti", b.temperature = 298, b.line = 7;
  b.end_angle = 2 * pi;
  return b;
}

inline BodyDeck block(const std::string& name, const std::string& fill, Triple origin, Triple size,
                      double spacing) {
  BodyDeck b = body(name, "block", fill);
  b.origin = origin, b.size = size, b.spacing = spacing;
  return b;
}

inline BodyDeck ring(const std::string& name, const std::string& fill, double inner, double outer,
                     double height, std::array<int, 3> cells) {
  BodyDeck b = body(name, "ring", fill);
  b.inner_radius = inner, b.outer_radius = outer, b.height = height, b.cells = cells;
  return b;
}

// The end mill of Demiral & Mamedov (2022); rake, clearance and core are assumed.
inline ToolDeck paper_mill() {
  ToolDeck t(ToolKind::end_mill);
  t.diameter = 800 * um, t.helix = 25.2 * degree, t.edge_radius = 6 * um, t.length = 150 * um;
  t.clearance = 10 * degree, t.core_ratio = 0.6, t.flutes = 2;
  t.spindle_speed = 10000 * 2 * pi / 60, t.feed_per_tooth = 10 * um;
  return t;
}

// Their workpiece, with lattices that give their counts exactly: 717 x 47 x 11 particles, 344 x 15 x 24
// hexes.
inline Deck paper_deck() {
  Deck deck = empty_deck();
  const double band = 400 * um + 11 * 3.3 * um;
  deck.bodies = {ring("zone", "particles", 400 * um, band, 150 * um, {717, 47, 11}),
                 ring("bulk", "hexes", band, 600 * um, 150 * um, {344, 15, 24})};
  deck.bodies[0].tie = "bulk";
  return deck;
}

inline double sum(const ScalarField& field, int rows) {
  const auto f = host_copy(field);
  double total = 0;
  for (int i = 0; i < rows; ++i) total += double(f(i));
  return total;
}

} // namespace swarf::test
