// Tie of particles to hexes: tied particles continue the lattice into the hexes and move with them.
#pragma once
#include "swarf/core/tensor.hpp"

namespace swarf {

// Row k belongs to the tied particle of identity particles.whole + k. It moves by the 8 shape functions of
// its host hex (exact for linear fields) and is a particle in every other respect: its own gradient, stress
// and force. The force goes to the host's nodes by the same shape functions. The stress passes from particles
// to hexes along a ramp: the volume of tied particles falls from all to none of their cell over the support,
// and what they leave of a hex carries the hex's stress (HexMesh::share); the mass stays with the nodes. So
// all forces follow from one power,
//   sum over particles and tied particles V sigma : L  +  sum over hexes share V sigma : L,
// and momentum, angular momentum and energy pass to round-off.
struct Tie {
  int count = 0;
  IndexField host;       // hex
  View<Real* [8]> shape; // N_a at the particle, sum 1
  IndexField row;        // of the particles' fields
  // Gather without atomics: rows of node row_node[r] are entry[start[r] .. start[r+1]), each 8 * k + corner.
  IndexField row_node, start, entry;
};

} // namespace swarf
