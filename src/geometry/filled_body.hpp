// A body of the deck, filled: what the parts of the scene are built from.
#pragma once
#include "src/geometry/lattice.hpp"
#include "swarf/core/tensor.hpp"

namespace swarf {

struct FilledBody {
  const BodyDeck* deck = nullptr;
  int row = 0;      // of deck.bodies
  int material = 0; // row of deck.materials
  Shape shape;
  PointSet points; // one of the two is empty; hexes that become particles have a spacing, too
  HexSet hexes;
  int first = 0; // row of the first particle, or of the first node
  int first_hex = 0;

  bool has_particles() const { return deck->fill == Fill::particles; }
};

inline Vector3 to_vector3(const Point& x) { return {Real(x.x()), Real(x.y()), Real(x.z())}; }
inline Vector3 to_vector3(const Triple& x) { return {Real(x[0]), Real(x[1]), Real(x[2])}; }

} // namespace swarf
