// Verlet lists of clusters: rows in Z order are cut into runs of pack_width; the list of a run holds every
// row within the cutoff of one of its members. Candidates come from the sorted Z keys of the cells around the
// run's box; a search cell is 4 x 4 x 4 cells of the key. Two passes, count and fill. No absolute distance
// anywhere.
#include "swarf/pair.hpp"
#include "z_order.hpp"

namespace swarf {
namespace {

constexpr int search_level = 2; // search cell = key cell * 2^search_level
constexpr int key_shift = 3 * search_level;

struct Search {
  ZGrid grid; // of search cells
  SortedRows rows;
  int total = 0;
  VectorField position;
  Real cutoff2 = 0;
};

SWARF_FN int lower_bound(const View<ZKey*>& key, int count, ZKey value) {
  int low = 0;
  while (count > 0) {
    const int half = count / 2;
    if (key(low + half) < value)
      low += half + 1, count -= half + 1;
    else
      count = half;
  }
  return low;
}

struct CellBox {
  int low[3], high[3];
};

KOKKOS_INLINE_FUNCTION CellBox cells_around(const Search& s, const Lanes& lanes, Real cutoff) {
  Vector3 low = load_vector(s.position, lanes.first), high = low;
  for (int lane = 1; lane < lanes.size; ++lane) {
    const Vector3 x = load_vector(s.position, lanes.first + lane);
    low = {Kokkos::min(low.x, x.x), Kokkos::min(low.y, x.y), Kokkos::min(low.z, x.z)};
    high = {Kokkos::max(high.x, x.x), Kokkos::max(high.y, x.y), Kokkos::max(high.z, x.z)};
  }
  const ZGrid& g = s.grid;
  return {{int(g.index(low.x - cutoff, g.origin.x)), int(g.index(low.y - cutoff, g.origin.y)),
           int(g.index(low.z - cutoff, g.origin.z))},
          {int(g.index(high.x + cutoff, g.origin.x)), int(g.index(high.y + cutoff, g.origin.y)),
           int(g.index(high.z + cutoff, g.origin.z))}};
}

// Calls take(row) for every row within the cutoff of a lane.
template <class Take>
KOKKOS_INLINE_FUNCTION void for_each_near(const Search& s, const Lanes& lanes, Real cutoff,
                                          const Take& take) {
  const CellBox box = cells_around(s, lanes, cutoff);
  const auto x_i = lanes.load_vector(s.position);
  for (int k = box.low[2]; k <= box.high[2]; ++k)
    for (int j = box.low[1]; j <= box.high[1]; ++j)
      for (int i = box.low[0]; i <= box.high[0]; ++i) {
        const ZKey first = z_key(i, j, k) << key_shift, last = first + (ZKey(1) << key_shift);
        for (int r = lower_bound(s.rows.key, s.total, first); r < s.total && s.rows.key(r) < last; ++r) {
          const int row = s.rows.row(r);
          const auto x_ij = x_i - broadcast_vector(s.position, row);
          if (any_less(dot(x_ij, x_ij), s.cutoff2)) take(row);
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
void walk(const Neighbors& n, const Search& s, bool fill) {
  const Real cutoff = n.cutoff;
  Kokkos::parallel_for(
      "find_neighbors", Range(0, n.clusters + n.tied_clusters), KOKKOS_LAMBDA(int c) {
        const Lanes lanes{n.first(c), n.size(c)};
        long found = 0;
        const long begin = fill ? n.start(c) : 0;
        for_each_near(s, lanes, cutoff, [&](int row) {
          if (fill) n.neighbor(begin + found) = row;
          ++found;
        });
        if (!fill) n.start(c) = found;
      });
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
  Search s;
  const ZGrid keys = z_grid(p.position, p.total, n.cutoff / Real(1 << search_level));
  s.rows = sort_rows(p.position, p.total, keys);
  s.grid = {keys.origin, keys.cell_size * Real(1 << search_level)};
  s.total = p.total, s.position = p.position, s.cutoff2 = n.cutoff * n.cutoff;
  walk(n, s, false);
  const long total = scan_starts(n);
  if (long(n.neighbor.extent(0)) < total)
    n.neighbor = IndexField(Kokkos::view_alloc(Kokkos::WithoutInitializing, "neighbor"), total + total / 16);
  walk(n, s, true);
  const int rows = p.total;
  if (int(n.build_position.extent(0)) < rows) n.build_position = VectorField("build_position", rows);
  const auto from = p.position, to = n.build_position;
  Kokkos::parallel_for(
      "build_position", Range(0, rows), KOKKOS_LAMBDA(int i) { store_vector(to, i, load_vector(from, i)); });
}

} // namespace swarf
