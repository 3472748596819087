// Verlet lists with a skin, one list for a cluster of particles that fill the lanes of a pack.
#pragma once
#include "swarf/pack.hpp"
#include "swarf/transform.hpp"

namespace swarf {

// Cluster c holds the rows first(c) .. first(c) + size(c) - 1, size <= pack_width. Its list, shared by all
// lanes, is neighbor[start(c) .. start(c + 1)): every row within support + skin of a member (and others that
// the kernel's compact support cuts off). Clusters of particles come first, then those of tied particles.
struct Neighbors {
  int clusters = 0; // of particles
  int tied_clusters = 0;
  IndexField first, size; // [clusters + tied_clusters]
  View<long*> start;      // [clusters + tied_clusters + 1]
  IndexField neighbor;
  VectorField build_position; // positions when the list was built, of all rows; X of a total Lagrangian sum
  Real cutoff = 0;            // m, support + skin
  Real skin = 0;              // m

  // Images: row image_first + k copies row image_source(k); those of plane p are
  // image_start[p] <= k < image_start[p + 1].
  int image_first = 0, images = 0, planes = 0;
  int image_start[max_image_planes + 1] = {};
  IndexField image_source;
};

} // namespace swarf
