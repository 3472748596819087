// Shared by the kernels after which ghosts are behind their sources: one launch for the ghosts of a plane.
#pragma once
#include "swarf/kernels.hpp"

namespace swarf {

// Visits the table of fields for one ghost.
template <Ghosts when>
struct CopyToGhost {
  int source, ghost;
  const Transform& map;

  template <class Field, auto... named>
  SWARF_FN void operator()(const char*, const Field& field, Facts<named...> facts) const {
    if constexpr (Facts<named...>::on_ghosts_at(when))
      if (has_rows(field, facts)) copy_turned(field, source, ghost, map, facts);
  }
};

// Fields of the ghosts of plane k, of which a plane of a later pair may make ghosts.
template <Ghosts when>
void copy_to_ghosts(const char* label, const Particles& p, const Neighbors& n, const GhostPlanes& planes,
                    int k) {
  const int first = n.ghost_first;
  const auto source = n.ghost_source;
  const Transform map = planes[std::size_t(k)].to_ghost;
  Kokkos::parallel_for(
      label, Range(n.ghost_start[k], n.ghost_start[k + 1]), KOKKOS_LAMBDA(int ghost) {
        for_each_field(p, CopyToGhost<when>{source(ghost), first + ghost, map});
      });
}

template <Ghosts when>
void copy_to_ghosts(const char* label, const Particles& p, const Neighbors& n, const GhostPlanes& planes) {
  for (int k = 0; k < n.planes; ++k) copy_to_ghosts<when>(label, p, n, planes, k);
}

} // namespace swarf
