// Contact of bodies with each other: who may meet whom, and what touches. The law is that of the tool
// (contact_law.hpp).
#pragma once
#include "swarf/core/tensor.hpp"

namespace swarf {

inline constexpr int no_hex = -1, no_surface = -2;

// Of a whole run. Bodies that are tied to each other are one group; bodies of one group never meet.
struct ContactGroups {
  int count = 0;              // 0: no two bodies can meet, and nothing of this file costs anything
  View<int* [6]> behind;      // hex at each side of a hex; no_hex; no_surface: nothing can touch it there
  IndexField of_hex, of_body; // group
  Real skin = 0;              // m, of the lists
};

inline constexpr int points_of_face = 4;

// What one point of an item does in one step. An item is a face of a hex, with four points, or a particle.
struct Touch {
  int other = -1;                // face that it touches
  Real weight[points_of_face]{}; // of the other's nodes
  Vector3 normal{0, 0, 0};       // unit, from the other to the point
  Vector3 force{0, 0, 0};        // N, on the point
  Real energy = 0;               // J, in its springs
  Real dissipated = 0;           // J in this step
};

// Lists of what is near to another group, made anew before anything has moved by more than `room`.
struct BodyContact {
  int faces = 0, items = 0; // items: faces, then particles
  IndexField key;           // 6 hex + side of each face, ascending
  IndexField row;           // of each particle among the items
  View<int* [points_of_face]> node;
  IndexField start, other; // items near to item i, of other groups: other[start(i) .. start(i + 1)), and back
  View<Touch* [points_of_face]> touch;
  View<Real* [points_of_face][3]> friction;     // N, of faces: stick-slip memory
  IndexField corner_start, corner;              // of nodes: 4 face + corner
  VectorField node_position, particle_position; // when the lists were made
  Real room = 0;                                // m, that anything may move until they are made again
};

// The nodes of the sides of a hex, counter-clockwise from outside: low and high of the first, second and
// third direction.
SWARF_FN int corner_of_side(int side, int k) {
  constexpr int corner[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  return corner[side][k];
}

// Weights of the corners at point q of a face: next to corner q, a twentieth of the edge inside, so that
// bodies whose edges lie on each other meet there as well as inside.
SWARF_FN Real weight_of_corner(int q, int corner) {
  constexpr Real near = Real(0.95), far = Real(1) - near;
  const int apart = q < corner ? corner - q : q - corner;
  return apart == 0 ? near * near : apart == 2 ? far * far : near * far;
}

} // namespace swarf
