// An elastic strip between two faces that move apart.
#pragma once
#include "tests/verification/point_masses.hpp"

namespace swarf::test::pulled_strip {

inline constexpr double E = 1e9, nu = 0.3, density = 1000, a = 1e-3; // spacing
inline const double wave = std::sqrt(E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / density);

// Pulled at both ends at the speed `pull`; plane strain.
inline Deck strip(const std::string& fill, double pull, int along = 40, int across = 10) {
  Deck deck = default_deck();
  deck.materials[0].density = density, deck.materials[0].youngs_modulus = E;
  deck.materials[0].poissons_ratio = nu;
  deck.bodies = {
      block("strip", fill, {-along * a / 2, -across * a / 2, 0}, {along * a, across * a, 3 * a}, a)};
  deck.bodies[0].faces = {{"z_min", FaceKind::periodic, {}},
                          {"z_max", FaceKind::periodic, {}},
                          {"x_min", FaceKind::velocity, {-pull, 0, 0}},
                          {"x_max", FaceKind::velocity, {pull, 0, 0}}};
  return deck;
}

} // namespace swarf::test::pulled_strip
