// A particle that left through a periodic plane comes back through its partner, with all that has a
// direction. A particle outside by more than a whole period, or with a position that is no number, is lost.
#include "swarf/kernels.hpp"

namespace swarf {
namespace {

// Visits the table of fields for one particle. Pair fields, too: it may be frozen before they are made
// again.
struct TurnRow {
  int i;
  const Transform& map;

  template <class Field, auto... named>
  SWARF_FN void operator()(const char*, const Field& field, Facts<named...> facts) const {
    if constexpr (facts.life != Life::derived && facts.frame != Frame::scalar)
      if (has_rows(field, facts)) copy_turned(field, i, i, map, facts);
  }
};

} // namespace

void wrap_periodic(const Particles& p, const GhostPlanes& planes, const Status& status) {
  for (const GhostPlane& each : planes) {
    if (!each.periodic) continue;
    const GhostPlane plane = each;
    Kokkos::parallel_for(
        "wrap_periodic", Range(0, p.count), KOKKOS_LAMBDA(int i) {
          if (dot(plane.normal, load_vector(p.position, i)) >= plane.offset) return;
          for_each_field(p, TurnRow{i, plane.to_ghost});
          if (!(dot(plane.normal, load_vector(p.position, i)) >= plane.offset))
            report(status, Fault::particle_lost, p.identity(i)); // rows are sorted before anyone reads it
        });
  }
}

} // namespace swarf
