// Ghosts of the rows that lie within the cutoff of a periodic or mirror plane, so that pair sums need no
// special cases: rows [stored, total) of the fields that a neighbour is read from. Made at every
// rebuild of the lists; update_ghosts and update_ghost_state refresh their values in each step.
#include "cell_order.hpp"
#include "copy_to_ghosts.hpp"

namespace swarf {
namespace {

// Fills ghost_source with the rows seen near the plane, in ascending order; returns how many.
int append_sources(const VectorField& position, const SeenRows& seen, const GhostPlane& plane, Real cutoff,
                   IndexField& source, int first) {
  const int rows = seen.count();
  const IndexField place("make_ghosts_place", rows);
  Kokkos::parallel_for(
      "make_ghosts", Range(0, rows), KOKKOS_LAMBDA(int i) {
        const Real distance = dot(plane.normal, load_vector(position, seen(i))) - plane.offset;
        place(i) = distance < cutoff ? 1 : 0;
      });
  const int found = number_taken(place);
  ensure_rows(source, first + found);
  const IndexField to = source;
  Kokkos::parallel_for(
      "make_ghosts", Range(0, rows), KOKKOS_LAMBDA(int i) {
        if (place(i) >= 0) to(first + place(i)) = seen(i);
      });
  return found;
}

void ensure_ghost_rows(Particles& p, int rows) {
  if (int(p.position.extent(0)) >= rows) return;
  const int room = rows + (rows - p.stored) / 8;
  for_each_field(p, [&](const char*, auto& field, auto facts) {
    if constexpr (facts.on_ghosts)
      if (has_rows(field, facts)) ensure_rows(field, room);
  });
}

} // namespace

void make_ghosts(Particles& p, Neighbors& n, const GhostPlanes& planes) {
  n.ghost_first = p.stored;
  n.ghosts = 0;
  n.planes = int(planes.size());
  SeenRows seen{p.listed, p.stored, p.stored};
  for (int plane = 0; plane < n.planes; ++plane) {
    if (plane % 2 == 0) seen.total = n.ghost_first + n.ghosts; // a pair sees the ghosts of earlier pairs only
    n.ghost_start[plane] = n.ghosts;
    if (planes[plane].active)
      n.ghosts += append_sources(p.position, seen, planes[plane], n.cutoff, n.ghost_source, n.ghosts);
    n.ghost_start[plane + 1] = n.ghosts;
    ensure_ghost_rows(p, n.ghost_first + n.ghosts);
    // Also positions, which planes of later pairs must see.
    copy_to_ghosts<Ghosts::when_made>("fill_ghosts", p, n, planes, plane);
  }
  p.total = n.ghost_first + n.ghosts;
}

} // namespace swarf
