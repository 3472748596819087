// Closed surfaces as files, and decks with bodies that are filled from them.
#pragma once
#include "tests/src/tool_shapes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace swarf::test {

// A box; parts are put together by `add`.
inline FacetSurface make_box(const Triple& low, const Triple& size) {
  FacetSurface s;
  for (int v = 0; v < 8; ++v)
    s.vertices.push_back(
        {low[0] + (v & 1) * size[0], low[1] + (v >> 1 & 1) * size[1], low[2] + (v >> 2) * size[2]});
  s.facets = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
              {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return s;
}

// Along z from 0, of so many sides.
inline FacetSurface make_cylinder(double radius, double height, int sides) {
  FacetSurface s;
  for (int k = 0; k < sides; ++k)
    for (const double z : {0.0, height})
      s.vertices.push_back({radius * std::cos(2 * pi * k / sides), radius * std::sin(2 * pi * k / sides), z});
  const int low = 2 * sides, high = low + 1;
  s.vertices.push_back({0, 0, 0}), s.vertices.push_back({0, 0, height});
  for (int k = 0; k < sides; ++k) {
    const int a = 2 * k, b = 2 * ((k + 1) % sides);
    s.facets.insert(s.facets.end(), {{low, b, a}, {high, a + 1, b + 1}, {a, b, a + 1}, {b, b + 1, a + 1}});
  }
  return s;
}

inline FacetSurface add(FacetSurface one, const FacetSurface& other) {
  const int first = int(one.vertices.size());
  one.vertices.insert(one.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.facets) one.facets.push_back({a + first, b + first, c + first});
  return one;
}

// In metres.
inline BodyDeck stl_body(const std::string& file, const std::string& fill, double spacing) {
  BodyDeck b = body("b", "stl", fill);
  b.file = file, b.file_scale = 1, b.spacing = spacing;
  return b;
}

inline Deck deck_with(const std::vector<BodyDeck>& bodies) {
  Deck deck = empty_deck();
  deck.bodies = bodies;
  return deck;
}

} // namespace swarf::test
