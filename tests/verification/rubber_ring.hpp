// Rubber rings and spheres, the wall that they meet, and what of them has torn.
#pragma once
#include "tests/verification/point_masses.hpp"

namespace swarf::test::rubber_ring {

// Gray, Monaghan & Swift (2001): K = rho c0^2, G = 0.22 K; rings of 3 and 4 cm, 0.059 c0 each.
inline constexpr double density = 1010, c0 = 852, nu = 0.3975, inner = 0.03, outer = 0.04;
inline constexpr double speed = 0.059 * c0;

inline Deck rubber() {
  Deck deck = default_deck();
  deck.materials[0].density = density, deck.materials[0].poissons_ratio = nu;
  deck.materials[0].youngs_modulus = 3 * density * c0 * c0 * (1 - 2 * nu);
  return deck;
}

inline void put_wall(Deck& deck) {
  deck.tool = ToolDeck(ToolKind::wall);
  deck.tool->normal = {1, 0, 0}, deck.tool->size = 8 * outer;
  deck.tool->position = {-outer, 0, 0};
}

// `across` cells in the thickness; plane strain.
inline BodyDeck ring_of(const std::string& fill, int across) {
  const double a = (outer - inner) / across;
  const int around = int(std::lround(pi * (inner + outer) / a));
  BodyDeck b = ring("ring", fill, inner, outer, 3 * a, {around, 3, across});
  b.faces = {{"bottom", FaceKind::periodic, {}}, {"top", FaceKind::periodic, {}}};
  b.velocity = {-speed, 0, 0};
  return b;
}

inline BodyDeck sphere_of(const std::string& fill, int across) {
  BodyDeck b = body("sphere", "sphere", fill);
  b.inner_radius = inner, b.outer_radius = outer, b.spacing = (outer - inner) / across;
  b.velocity = {-speed, 0, 0};
  return b;
}

// Neighbours of the lattice that the run tears apart.
class Bonds {
 public:
  Bonds(const Scene& scene, double spacing, bool plane) : in_plane(plane) {
    const std::vector<PointState> at = snapshot(scene);
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t j = i + 1; j < at.size(); ++j)
        if (const double d = apart(at, i, j, false); d < 1.2 * spacing) pairs.push_back({i, j, d});
  }
  int torn(const Scene& scene) const {
    const std::vector<PointState> at = snapshot(scene);
    int count = 0;
    for (const auto& [i, j, d] : pairs) count += apart(at, i, j, in_plane) > 1.6 * d;
    return count;
  }

  std::size_t count() const { return pairs.size(); }

 private:
  struct Pair {
    std::size_t i, j;
    double distance; // m, at the start
  };
  bool in_plane; // periodic planes carry particles from one side to the other
  std::vector<Pair> pairs;

  static double apart(const std::vector<PointState>& at, std::size_t i, std::size_t j, bool plane) {
    const Triple &x = at[i].x, &y = at[j].x;
    return std::hypot(x[0] - y[0], x[1] - y[1], plane ? 0.0 : x[2] - y[2]);
  }
};

inline constexpr double ring_time = 2e-3, sphere_time = 1.2e-3; // s: they have left the wall

} // namespace swarf::test::rubber_ring
