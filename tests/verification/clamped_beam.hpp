// Beams clamped at one end: a plate in plane strain and a square cantilever.
#pragma once
#include "tests/verification/drive.hpp"
#include <cmath>

namespace swarf::test::clamped_beam {

struct Beam {
  std::string name;
  double length, thickness;
  MaterialDeck material;
  bool plane_strain; // a slice across which nothing changes; else as deep as thick
  double tip_speed;  // of the start, m/s
};

inline Beam plate() {
  return {"3 oscillating plate", 0.2, 0.02, elastic_material(1000, 2e6, 0.3975), true, 0.05};
}
inline Beam cantilever() {
  return {"3 cantilever", 1e-3, 1e-4, elastic_material(4430, 110e9, 0.33), false, 1};
}

// First mode of a thin cantilever, 1 at the tip (Euler & Bernoulli).
inline double mode_shape(double s) {
  const double k = 1.8751040687, r = (std::cos(k) + std::cosh(k)) / (std::sin(k) + std::sinh(k));
  const auto f = [&](double z) { return std::cosh(z) - std::cos(z) - r * (std::sinh(z) - std::sin(z)); };
  return f(k * s) / f(k);
}

// Along x, clamped at its face x = 0, bending in y.
inline Deck clamped(const Deck& method, const Beam& beam, const std::string& fill, int across) {
  Deck deck = method;
  deck.materials = {beam.material};
  const double spacing = beam.thickness / across;
  const bool particles = fill == "particles";
  const double depth = !beam.plane_strain ? beam.thickness : particles ? 3 * spacing : spacing;
  deck.bodies = {block("beam", fill, {0, 0, 0}, {beam.length, beam.thickness, depth}, spacing)};
  hold(deck.bodies[0], "fixed", {"x_min"});
  if (beam.plane_strain) hold(deck.bodies[0], particles ? "periodic" : "symmetric", {"z_min", "z_max"});
  deck.run.courant = 0.5;
  return deck;
}

} // namespace swarf::test::clamped_beam
