// Verlet lists of clusters: rows along a Hilbert curve are cut into runs of pack_width; the list of a run
// holds every row within the cutoff of one of its members. Candidates come row by row from a grid of cells,
// sorted, so that cells without rows take no memory; those near the run's box are tested against each member.
// Two passes, count and fill. No absolute distance anywhere.
#include "cell_order.hpp"
#include "swarf/particles/pair.hpp"

namespace swarf {
namespace {

struct Search {
  CellGrid grid;
  KeyedRows rows;       // by cell
  VectorField position; // of the sorted rows
  int total = 0;
  Real cutoff = 0;
};

struct Box {
  Vector3 low, high;
};

KOKKOS_INLINE_FUNCTION Box box_of(const VectorField& position, const Lanes& lanes) {
  Vector3 low = load_vector(position, lanes.first), high = low;
  for (int lane = 1; lane < lanes.size; ++lane) {
    const Vector3 x = load_vector(position, lanes.first + lane);
    low = {Kokkos::min(low.x, x.x), Kokkos::min(low.y, x.y), Kokkos::min(low.z, x.z)};
    high = {Kokkos::max(high.x, x.x), Kokkos::max(high.y, x.y), Kokkos::max(high.z, x.z)};
  }
  return {low, high};
}

// 0 inside.
SWARF_FN Real squared_distance(const Box& box, Real x, Real y, Real z) {
  const Real dx = Kokkos::max(Kokkos::max(box.low.x - x, x - box.high.x), Real(0));
  const Real dy = Kokkos::max(Kokkos::max(box.low.y - y, y - box.high.y), Real(0));
  const Real dz = Kokkos::max(Kokkos::max(box.low.z - z, z - box.high.z), Real(0));
  return dx * dx + dy * dy + dz * dz;
}

constexpr int chunk = 64; // candidates looked at together

// Of sorted rows begin .. end - 1, at most a chunk: takes those within the cutoff of a lane.
template <class Take>
KOKKOS_INLINE_FUNCTION void take_near(const Search& s, const Box& box, const Vector3Of<Pack>& x_i, int begin,
                                      int end, const Take& take) {
  const Real cutoff2 = s.cutoff * s.cutoff;
  Real distance2[chunk];
  int near[chunk], count = 0;
  for (int k = 0; k < end - begin; ++k) // no branch: fills the lanes with candidates
    distance2[k] =
        squared_distance(box, s.position(begin + k, 0), s.position(begin + k, 1), s.position(begin + k, 2));
  for (int k = 0; k < end - begin; ++k) {
    near[count] = begin + k;
    count += distance2[k] < cutoff2;
  }
  for (int k = 0; k < count; ++k) {
    const auto x_ij = x_i - broadcast_vector(s.position, near[k]);
    if (any_of(dot(x_ij, x_ij) < Pack(cutoff2))) take(s.rows(near[k]).row);
  }
}

// Calls take(row) for every row within the cutoff of a lane.
template <class Take>
KOKKOS_INLINE_FUNCTION void for_each_near(const Search& s, const VectorField& position, const Lanes& lanes,
                                          const Take& take) {
  const Box box = box_of(position, lanes);
  const Vector3 reach{s.cutoff, s.cutoff, s.cutoff};
  const CellIndex low = s.grid.index(box.low - reach), high = s.grid.index(box.high + reach);
  const auto x_i = lanes.load_vector(position);
  for (CellKey k = low.k; k <= high.k; ++k)
    for (CellKey j = low.j; j <= high.j; ++j) {
      const CellKey last = row_key({high.i, j, k});
      int begin = lower_bound(s.rows, s.total, row_key({low.i, j, k}));
      while (begin < s.total && s.rows(begin).key <= last) {
        int end = begin;
        while (end < s.total && end < begin + chunk && s.rows(end).key <= last) ++end;
        take_near(s, box, x_i, begin, end, take);
        begin = end;
      }
    }
}

void make_clusters(Neighbors& n, const Particles& p) {
  const int W = pack_width, count = p.count, tied = p.tied;
  n.clusters = (count + W - 1) / W;
  n.tied_clusters = (tied + W - 1) / W;
  const int clusters = n.clusters, all = n.clusters + n.tied_clusters;
  ensure_rows(n.first, all), ensure_rows(n.size, all), ensure_rows(n.start, all + 1);
  const IndexField first = n.first, size = n.size;
  Kokkos::parallel_for(
      "make_clusters", Range(0, all), KOKKOS_LAMBDA(int c) {
        const bool of_tied = c >= clusters;
        first(c) = of_tied ? count + (c - clusters) * W : c * W;
        size(c) = Kokkos::min(W, (of_tied ? count + tied : count) - first(c));
      });
}

// Counts (fill = false) or writes (fill = true) the lists.
void walk(const Neighbors& n, const Search& s, const VectorField& position, bool fill) {
  Kokkos::parallel_for(
      "find_neighbors", Range(0, n.clusters + n.tied_clusters), KOKKOS_LAMBDA(int c) {
        const Lanes lanes{n.first(c), n.size(c)};
        long found = 0;
        const long begin = fill ? n.start(c) : 0;
        for_each_near(s, position, lanes, [&](int row) {
          if (fill) n.neighbor(begin + found) = row;
          ++found;
        });
        if (!fill)
          n.start(c) = found;
        else
          mark_neighbors<entries_of_word>(
              n, c, [](const int*, int count) { return ~Marks(0) >> (entries_of_word - count); });
      });
}

Search make_search(const Particles& p, Real cutoff) {
  const SeenRows seen{p.listed, p.stored, p.total};
  Search s{cell_grid(p.position, p.total, cutoff), {}, {}, seen.count(), cutoff};
  s.rows = sort_rows(p.position, seen, RowKeyOf{s.grid});
  s.position = VectorField(Kokkos::view_alloc(Kokkos::WithoutInitializing, "sorted_position"), s.total);
  const VectorField from = p.position;
  Kokkos::parallel_for(
      "sorted_position", Range(0, s.total),
      KOKKOS_LAMBDA(int r) { store_vector(s.position, r, load_vector(from, s.rows(r).row)); });
  return s;
}

long scan_starts(const Neighbors& n) {
  const int all = n.clusters + n.tied_clusters;
  const auto start = n.start;
  long total = 0;
  Kokkos::parallel_scan(
      "scan_starts", Range(0, all + 1),
      KOKKOS_LAMBDA(int c, long& sum, bool last) {
        const long own = c < all ? start(c) : 0;
        if (last) start(c) = sum;
        sum += own;
      },
      total);
  return total;
}

} // namespace

void find_neighbors(Neighbors& n, const Particles& p) {
  make_clusters(n, p);
  const Search s = make_search(p, n.cutoff);
  walk(n, s, p.position, false);
  const long total = scan_starts(n);
  if (long(n.neighbor.extent(0)) < total) {
    n.neighbor = IndexField(); // gone before the next: the lists are the largest field
    n.neighbor = IndexField(Kokkos::view_alloc(Kokkos::WithoutInitializing, "neighbor"), total + total / 16);
  }
  ensure_rows(n.marks, std::size_t(total / entries_of_word + n.clusters + n.tied_clusters));
  walk(n, s, p.position, true);
  const int rows = p.total;
  if (int(n.build_position.extent(0)) < rows) n.build_position = VectorField("build_position", rows);
  const auto from = p.position, to = n.build_position;
  Kokkos::parallel_for(
      "build_position", Range(0, rows), KOKKOS_LAMBDA(int i) { store_vector(to, i, load_vector(from, i)); });
}

} // namespace swarf
