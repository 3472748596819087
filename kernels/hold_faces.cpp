// v_i = v_f + c (v_m - v_f) for the particles i that follow host m at a held face (held_rows.hpp), after a
// kick that moved them as if they were free. Of all velocities that obey it those nearest in kinetic energy
// to the free ones,
//   v_m = [m_m v_m + c sum_i m_i (v_i - (1 - c) v_f)] / [m_m + c^2 sum_i m_i],
// which is d'Alembert's principle: the constraint does no work but that of the face. Reads constraints, mass,
// plastic_strain and force; writes velocity; adds to external_work what the constraint does.
#include "swarf/kernels.hpp"

namespace swarf {
namespace {

// The impulse meets the mean of the velocities before the kick and after it, as the force does.
SWARF_FN void change_velocity(const Motion& m, const Kick& kick, int i, const Vector3& v) {
  const Real inertia = kick.mass_factor * m.mass(i);
  const Vector3 free = load_vector(m.velocity, i),
                before = free - (kick.dt / inertia) * load_vector(m.force, i); // kick has booked gravity
  m.external_work(i) += Real(0.5) * inertia * dot(v - free, before + v);
  store_vector(m.velocity, i, v);
}

SWARF_FN bool is_moved(const Motion& m, int i) { return i < m.count && !(m.constraints(i) & held_bit); }

} // namespace

void hold_faces(const HeldRows& h, const Motion& m, const ConstraintTable& table, const Kick& kick) {
  Kokkos::parallel_for(
      "hold_faces", Range(0, h.groups), KOKKOS_LAMBDA(int g) {
        const int host = h.row(h.host(g));
        const bool lets_go = (m.constraints(host) & retired_bit) || m.plastic_strain(host) > follows_until,
                   moves = is_moved(m, host) && !lets_go;
        const Real c = lets_go ? Real(0) : Real(held_share);
        Real inertia = kick.mass_factor * m.mass(host);
        Vector3 v_host = load_vector(m.velocity, host), momentum = inertia * v_host;
        for (int k = h.start(g); moves && k < h.start(g + 1); ++k) {
          const int i = h.row(h.held(k));
          if (!is_moved(m, i)) continue;
          const Real own = c * kick.mass_factor * m.mass(i);
          momentum = momentum + own * (load_vector(m.velocity, i) - (1 - c) * table(h.face(k)).velocity);
          inertia += c * own;
        }
        if (moves) v_host = (1 / inertia) * momentum, change_velocity(m, kick, host, v_host);
        for (int k = h.start(g); k < h.start(g + 1); ++k) {
          const int i = h.row(h.held(k));
          if (is_moved(m, i)) change_velocity(m, kick, i, (1 - c) * table(h.face(k)).velocity + c * v_host);
        }
      });
}

// After rows have changed their places.
void find_held_rows(const HeldRows& h, const Particles& p) {
  const IndexField row = h.row, identity = p.identity;
  const int known = int(row.extent(0));
  if (h.groups == 0) return;
  Kokkos::parallel_for(
      "find_held_rows", Range(0, p.stored), KOKKOS_LAMBDA(int i) {
        if (identity(i) < known) row(identity(i)) = i;
      });
}

} // namespace swarf
