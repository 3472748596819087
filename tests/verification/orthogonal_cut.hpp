// Orthogonal cutting of Ti-6Al-4V: the shipped deck, shorter, at a spacing, speed and depth of choice.
#pragma once
#include "tests/verification/drive.hpp"
#include <cmath>

namespace swarf::test::orthogonal_cut {

inline constexpr double rake = 15 * degree;
inline constexpr double cut = 250 * um; // its length, of which the second half counts

// The inertia of all speeds is alike.
inline Deck orthogonal(double speed, double depth, double friction, double dx) {
  Deck deck = read_deck(std::string(SWARF_SOURCE_DIR) + "/inputs/orthogonal_cutting.toml");
  BodyDeck &zone = deck.bodies[0], &bulk = deck.bodies[1];
  zone.size = {60 * dx, 40 * um + depth, 4 * dx}, zone.spacing = dx;
  bulk.size = {60 * dx, 160 * um, 4 * dx}, bulk.spacing = 2 * dx;
  deck.tool->velocity = {speed, 0, 0};
  deck.tool->width = 12 * dx, deck.tool->position[2] = 2 * dx, deck.tool->height = 400 * um;
  deck.contact.friction = friction;
  deck.run.end_time = cut / speed;
  deck.run.mass_factor = 1e4 * std::pow(0.5 / speed, 2);
  deck.output.force_scale = 1e-3 / (4 * dx);
  return deck;
}

} // namespace swarf::test::orthogonal_cut
