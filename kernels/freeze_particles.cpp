// Freezes, holds, or thaws each particle by its distance d from the active region (freeze.hpp), and
// orders the rows: active particles, active tied ones, frozen ones that a list may hold, those far from all
// and those that have retired. What stops gives its kinetic energy to external_work, as at a fixed face.
// Writes constraints, damping and the counts.
#include "append_points.hpp"
#include "point_grid.hpp"
#include "region_cells.hpp"

namespace swarf {
namespace {

enum Rank : int { active, active_tied, listed, far, ranks };
constexpr int rank_shift = 40; // of a key; below it the place within the rank

struct RankStarts {
  int first[ranks + 1];
};

SWARF_FN void stop_particle(const Particles& p, int i, Real mass_factor) {
  const Vector3 v = load_vector(p.velocity, i);
  p.external_work(i) -= Real(0.5) * mass_factor * p.points.mass(i) * dot(v, v);
  store_vector(p.velocity, i, {0, 0, 0});
}

// A frozen row shows its neighbours no motion, and is an insulator to them.
SWARF_FN void still(const Particles& p, int i) {
  store_tensor(p.points.velocity_gradient, i, Tensor3{});
  store_vector(p.velocity, i, {0, 0, 0});
  if (p.hourglass_rate.extent(0) > 0) store_vector(p.hourglass_rate, i, {0, 0, 0});
  if (p.heat_state.extent(0) > 0) p.heat_state(i, 1) = 0;
  if (p.surface_shift.extent(0) > 0) p.surface_shift(i, 0) = 0;
  p.points.plastic_strain_rate(i) = 0;
}

ScalarField distances(const Particles& p, const VectorField& region, const Freeze& s) {
  const ScalarField d(Kokkos::view_alloc(Kokkos::WithoutInitializing, "freeze_distance"), p.stored);
  const RegionCells cells = group_cells(region, s);
  Kokkos::parallel_for(
      "freeze_distance", Range(0, p.stored),
      KOKKOS_LAMBDA(int i) { d(i) = distance_to(cells, load_vector(p.position, i)); });
  return d;
}

// Tied particles in hexes of which a node may move, though they lie beyond what moves.
struct IsCarried {
  Particles p;
  ScalarField d;
  Freeze s;
  SWARF_FN bool operator()(int i) const {
    return p.identity(i) >= p.whole && d(i) > s.distance && d(i) <= s.distance + s.margin - s.reach;
  }
};

PointGrid find_carried(const Particles& p, const ScalarField& d, const Freeze& s) {
  VectorField found("carried", 0);
  const int rows = append_points(p.position, p.stored, IsCarried{p, d, s}, found, 0);
  Kokkos::resize(found, rows);
  return make_point_grid(found, s.reach);
}

// The rank that each row takes, and its place within: particles keep their order, so that nothing changes
// where nothing is frozen; tied ones have theirs.
View<CellKey*> rank_rows(const Particles& p, const VectorField& region, const Freeze& s) {
  const View<CellKey*> key(Kokkos::view_alloc(Kokkos::WithoutInitializing, "freeze_key"), p.stored);
  const ScalarField distance = distances(p, region, s);
  const PointGrid carried = find_carried(p, distance, s);
  Kokkos::parallel_for(
      "freeze_particles", Range(0, p.stored), KOKKOS_LAMBDA(int i) {
        key(i) = (CellKey(far) << rank_shift) | CellKey(i);
        if (p.constraints(i) & retired_bit) return;
        const Real d = distance(i);
        const bool tied = p.identity(i) >= p.whole, moves = d <= s.distance;
        const bool is_active =
            d <= s.distance + s.reach ||
            (d <= s.distance + s.margin && (tied || carried.any_within(load_vector(p.position, i), s.reach)));
        p.damping(i) = damping_at(s, d);
        p.constraints(i) = (p.constraints(i) & ~held_bit) | (moves || tied ? 0u : held_bit);
        if (!moves && !tied) stop_particle(p, i, s.mass_factor);
        if (!is_active) still(p, i);
        const Rank rank =
            is_active ? (tied ? active_tied : active) : (d <= s.distance + s.margin + s.reach ? listed : far);
        key(i) = (CellKey(rank) << rank_shift) | CellKey(tied ? p.identity(i) : i);
      });
  return key;
}

// Rows that are not among those of their rank change places with one another, and all active tied ones are
// put in order; the others stay, so that a look costs what changes, not what is frozen.
Moves moves_between(const View<CellKey*>& key, const RankStarts& starts) {
  const int rows = int(key.extent(0));
  const IndexField place("freeze_place", rows);
  Kokkos::parallel_for(
      "leave_rank", Range(0, rows), KOKKOS_LAMBDA(int i) {
        const int rank = int(key(i) >> rank_shift);
        place(i) = rank == active_tied || i < starts.first[rank] || i >= starts.first[rank + 1] ? 1 : 0;
      });
  const int count = number_taken(place);
  const Moves moves{IndexField("freeze_to", count), IndexField("freeze_from", count)};
  const KeyedRows order("freeze_order", count);
  Kokkos::parallel_for(
      "leave_rank", Range(0, rows), KOKKOS_LAMBDA(int i) {
        if (place(i) >= 0) moves.to(place(i)) = i, order(place(i)) = {key(i), i};
      });
  Kokkos::sort(
      ExecSpace{}, order, KOKKOS_LAMBDA(const KeyedRow& a, const KeyedRow& b) { return a < b; });
  Kokkos::parallel_for(
      "leave_rank", Range(0, count), KOKKOS_LAMBDA(int k) { moves.from(k) = order(k).row; });
  return moves;
}

int rows_before(const View<CellKey*>& key, Rank rank) {
  int rows = 0;
  Kokkos::parallel_reduce(
      "rows_before", Range(0, int(key.extent(0))),
      KOKKOS_LAMBDA(int k, int& sum) { sum += (key(k) >> rank_shift) < CellKey(rank) ? 1 : 0; }, rows);
  return rows;
}

} // namespace

void freeze_particles(Particles& p, const Tie& tie, const VectorField& region, const Freeze& s) {
  const View<CellKey*> key = rank_rows(p, region, s);
  const RankStarts starts{
      {0, rows_before(key, active_tied), rows_before(key, listed), rows_before(key, far), p.stored}};
  const Moves moves = moves_between(key, starts);
  const PermuteScratch scratch(moves);
  for_each_field(p, [&](const char*, const auto& field, auto facts) {
    if (facts.life != Life::derived) permute(field, moves, scratch);
  });
  p.count = starts.first[active_tied];
  p.tied = starts.first[listed] - p.count;
  p.listed = starts.first[far];
  p.points.count = p.count + p.tied;
  if (p.heat.extent(0) > 0) Kokkos::deep_copy(p.heat, Real(0)); // of the rows that were active
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
