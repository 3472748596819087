// Tie of particles to hexes: tied particles continue the lattice into the hexes and move with them.
#pragma once
#include "swarf/tensor.hpp"

namespace swarf {

// Row k belongs to the tied particle at row particles.count + k.
// Kinematics: x, v by the 8 shape functions of the host hex (exact for linear fields). Stress and velocity
// gradient: linear about the centre of the host, slopes from the hexes at its faces; a constant per hex would
// sample the traction too deep and reflect waves. Its own K would need tied neighbours: it is that of the
// undeformed lattice. Forces: to the 4 nodes of the nearest face of the hexes' surface, by its shape
// functions, so that a constant stress crosses the face without a dipole in the first layer of hexes.
struct Tie {
  int count = 0;
  Real correction = 1;          // K / identity, of a cubic lattice
  IndexField host;              // hex
  View<Real* [8]> shape;        // N_a at the particle
  View<int* [7]> state_hex;     // the host and the hexes at its faces; the host again where there is none
  View<Real* [7]> state_weight; // of their stresses, sum 1
  View<int* [4]> face_nodes;    // receive the force
  View<Real* [4]> face_shape;   // weights, sum 1
  // Gather without atomics: rows of node row_node[r] are entry[start[r] .. start[r+1]), each 4 * k + corner.
  IndexField row_node, start, entry;
};

} // namespace swarf
