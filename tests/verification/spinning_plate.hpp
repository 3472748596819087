// A square plate that spins freely, periodic across its thickness of three cells.
#pragma once
#include "tests/verification/point_masses.hpp"

namespace swarf::test::spinning_plate {

inline constexpr double side = 1, omega = 50, turn = 2 * pi / omega;

inline Deck plate(const std::string& fill, int n) {
  Deck deck = default_deck();
  deck.materials[0].density = 1100, deck.materials[0].youngs_modulus = 17e6;
  deck.materials[0].poissons_ratio = 0.45;
  const double a = side / n;
  const Triple corner{-side / 2, -side / 2, 0}, size{side, side, 3 * a};
  deck.bodies.clear();
  if (fill == "hybrid") {
    const Triple half{side / 2, side, 3 * a};
    deck.bodies = {block("left", "particles", corner, half, a),
                   block("right", "hexes", {0, -side / 2, 0}, half, a)};
    deck.bodies[0].tie = "right";
  } else {
    deck.bodies = {block("plate", fill, corner, size, a)};
  }
  for (BodyDeck& b : deck.bodies)
    b.faces = {{"z_min", FaceKind::periodic, {}}, {"z_max", FaceKind::periodic, {}}};
  return deck;
}

} // namespace swarf::test::spinning_plate
