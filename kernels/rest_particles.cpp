// Puts to sleep, holds, or wakes each particle by its distance d from the action (sleep.hpp), and orders the
// rows: awake particles, awake tied ones, sleeping ones that a list may hold, those far from all and those
// that have retired. What stops gives its kinetic energy to external_work, as at a fixed face. Writes
// constraints, damping and the counts.
#include "cell_order.hpp"

namespace swarf {
namespace {

enum Rank : CellKey { awake, awake_tied, listed, far };

SWARF_FN void stop_particle(const Particles& p, int i, Real mass_factor) {
  const Vector3 v = load_vector(p.velocity, i);
  p.external_work(i) -= Real(0.5) * mass_factor * p.points.mass(i) * dot(v, v);
  store_vector(p.velocity, i, {0, 0, 0});
}

// A sleeping row shows its neighbours no motion, and is an insulator to them.
SWARF_FN void still(const Particles& p, int i) {
  store_tensor(p.points.velocity_gradient, i, Tensor3{});
  store_vector(p.velocity, i, {0, 0, 0});
  if (p.hourglass_rate.extent(0) > 0) store_vector(p.hourglass_rate, i, {0, 0, 0});
  if (p.heat_state.extent(0) > 0) p.heat_state(i, 1) = 0;
  p.points.plastic_strain_rate(i) = 0;
}

// Particles keep their order, so that nothing changes where nothing sleeps; tied ones come back to theirs.
KeyedRows rank_rows(const Particles& p, const VectorField& action, const Sleep& s) {
  const KeyedRows order(Kokkos::view_alloc(Kokkos::WithoutInitializing, "rest_order"), p.stored);
  const ActionCells cells = group_cells(action, s.cell);
  Kokkos::parallel_for(
      "rest_particles", Range(0, p.stored), KOKKOS_LAMBDA(int i) {
        if (p.constraints(i) & retired_bit) {
          order(i) = {(CellKey(far) << 40) | CellKey(i), i};
          return;
        }
        const Real d = distance_to(cells, load_vector(p.position, i));
        const bool tied = p.identity(i) >= p.whole;
        const bool moves = d <= s.distance, is_awake = d <= s.distance + s.margin;
        p.damping(i) = damping_at(s, d);
        p.constraints(i) = (p.constraints(i) & ~held_bit) | (moves || tied ? 0u : held_bit);
        if (!moves && !tied) stop_particle(p, i, s.mass_factor);
        if (!is_awake) still(p, i);
        const Rank rank =
            is_awake ? (tied ? awake_tied : awake) : (d <= s.distance + s.margin + s.reach ? listed : far);
        order(i) = {(CellKey(rank) << 40) | CellKey(tied ? p.identity(i) : i), i};
      });
  Kokkos::sort(
      ExecSpace{}, order, KOKKOS_LAMBDA(const KeyedRow& a, const KeyedRow& b) { return a < b; });
  return order;
}

int rows_before(const KeyedRows& order, Rank rank) {
  int rows = 0;
  Kokkos::parallel_reduce(
      "rows_before", Range(0, int(order.extent(0))),
      KOKKOS_LAMBDA(int k, int& sum) { sum += (order(k).key >> 40) < CellKey(rank) ? 1 : 0; }, rows);
  return rows;
}

} // namespace

void rest_particles(Particles& p, const Tie& tie, const VectorField& action, const Sleep& s) {
  const KeyedRows order = rank_rows(p, action, s);
  const PermuteScratch scratch(order);
  p.for_each_field([&](const char*, auto& field) { permute(field, order, scratch); });
  p.for_each_pair_field([&](const char*, auto& field) { permute(field, order, scratch); });
  p.count = rows_before(order, awake_tied);
  p.tied = rows_before(order, listed) - p.count;
  p.listed = rows_before(order, far);
  p.points.count = p.count + p.tied;
  if (p.heat.extent(0) > 0) Kokkos::deep_copy(p.heat, Real(0)); // of the rows that were awake
  find_tied_rows(tie, p);
}

// tie.row from the identities.
void find_tied_rows(const Tie& tie, const Particles& p) {
  const IndexField row = tie.row, identity = p.identity;
  const int whole = p.whole;
  Kokkos::parallel_for(
      "find_tied_rows", Range(0, p.stored), KOKKOS_LAMBDA(int i) {
        if (identity(i) >= whole) row(identity(i) - whole) = i;
      });
}

} // namespace swarf
