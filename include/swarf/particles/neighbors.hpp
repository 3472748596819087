// Verlet lists with a skin, one list for a cluster of particles that fill the lanes of a pack.
#pragma once
#include "swarf/core/pack.hpp"
#include "swarf/core/transform.hpp"

namespace swarf {

using Marks = unsigned long long;
inline constexpr int entries_of_word = 64;

// Cluster c holds the rows first(c) .. first(c) + size(c) - 1, size <= pack_width. Its list, shared by all
// lanes, is neighbor[start(c) .. start(c + 1)): every row within support + skin of a member (and others that
// the kernel's compact support cuts off). Clusters of particles come first, then those of tied particles.
// Some of those rows, a tenth or more, are beyond the support of every lane: velocity_gradient, which looks
// at each, marks the others, so that the sums that follow it in a step visit no more than those.
struct Neighbors {
  int clusters = 0; // of particles
  int tied_clusters = 0;
  IndexField first, size; // [clusters + tied_clusters]
  View<long*> start;      // [clusters + tied_clusters + 1]
  IndexField neighbor;
  View<Marks*> marks; // bit k of word first_word(c) + w is of entry start(c) + 64 w + k; all are set at first
  VectorField build_position; // positions when the list was built, of all rows; X of a total Lagrangian sum
  Real cutoff = 0;            // m, support + skin
  Real skin = 0;              // m

  // Ghosts: row ghost_first + k copies row ghost_source(k); those of plane p are
  // ghost_start[p] <= k < ghost_start[p + 1].
  int ghost_first = 0, ghosts = 0, planes = 0;
  int ghost_start[max_ghost_planes + 1] = {};
  IndexField ghost_source;

  SWARF_FN long first_word(int c) const { return start(c) / entries_of_word + c; }
};

// visit(row) for every marked row of the list.
template <class Visit>
KOKKOS_FORCEINLINE_FUNCTION void for_each_neighbor(const Neighbors& n, int cluster, const Visit& visit) {
  const long end = n.start(cluster + 1);
  long word = n.first_word(cluster);
  for (long begin = n.start(cluster); begin < end; begin += entries_of_word, ++word)
    for (Marks left = n.marks(word); left != 0; left &= left - 1)
      visit(n.neighbor(begin + Kokkos::countr_zero(left)));
}

// Sets the marks of a list: near(rows, count) returns those of `count` rows, at most `chunk`, bit k for
// rows[k].
template <int chunk, class Near>
KOKKOS_FORCEINLINE_FUNCTION void mark_neighbors(const Neighbors& n, int cluster, const Near& near) {
  static_assert(entries_of_word % chunk == 0);
  const long end = n.start(cluster + 1);
  long word = n.first_word(cluster);
  for (long begin = n.start(cluster); begin < end; begin += entries_of_word, ++word) {
    const int entries = end - begin < entries_of_word ? int(end - begin) : entries_of_word;
    Marks marks = 0;
    for (int k = 0; k < entries; k += chunk)
      marks |= near(&n.neighbor(begin + k), entries - k < chunk ? entries - k : chunk) << k;
    n.marks(word) = marks;
  }
}

} // namespace swarf
