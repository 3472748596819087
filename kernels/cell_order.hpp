// Shared by the kernels that order rows in space: the grid from the least corner of a set of points, and
// sorting.
#pragma once
#include "swarf/cell_order.hpp"
#include "swarf/kernels.hpp"
#include <Kokkos_Sort.hpp>

namespace swarf {

struct KeyedRow {
  CellKey key;
  int row;
  KOKKOS_INLINE_FUNCTION bool operator<(const KeyedRow& o) const {
    return key < o.key || (key == o.key && row < o.row);
  }
};
using KeyedRows = View<KeyedRow*>;

// Rows [0, listed) and [stored, total): all that a list may hold.
struct SeenRows {
  int listed, stored, total;
  SWARF_FN int count() const { return listed + total - stored; }
  SWARF_FN int operator()(int k) const { return k < listed ? k : k + stored - listed; }
};
inline SeenRows first_rows(int rows) { return {rows, rows, rows}; }

CellGrid cell_grid(const VectorField& position, int rows, Real cell_size);

// Ascending keys; equal keys in the order of their rows. key_of(position) on the device.
template <class KeyOf>
KeyedRows sort_rows(const VectorField& position, const SeenRows& seen, const KeyOf& key_of) {
  const KeyedRows sorted(Kokkos::view_alloc(Kokkos::WithoutInitializing, "sorted_rows"), seen.count());
  Kokkos::parallel_for(
      "cell_key", Range(0, seen.count()), KOKKOS_LAMBDA(int k) {
        sorted(k) = {key_of(load_vector(position, seen(k))), seen(k)};
      });
  Kokkos::sort(
      ExecSpace{}, sorted, KOKKOS_LAMBDA(const KeyedRow& a, const KeyedRow& b) { return a < b; });
  return sorted;
}

struct RowKeyOf {
  CellGrid grid;
  SWARF_FN CellKey operator()(const Vector3& x) const { return row_key(grid.index(x)); }
};

// The first of `count` sorted rows whose key is no less than `value`.
SWARF_FN int lower_bound(const KeyedRows& rows, int count, CellKey value) {
  int low = 0;
  while (count > 0) {
    const int half = count / 2;
    if (rows(low + half).key < value)
      low += half + 1, count -= half + 1;
    else
      count = half;
  }
  return low;
}

// The cells of the action in groups, each with the box of its middles: find_action gives them line by line,
// so that a box is small.
struct ActionCells {
  static constexpr int group = 16;
  VectorField middle, low, high;
  Real size = 0;
};

inline ActionCells group_cells(const VectorField& middle, Real size) {
  const int rows = int(middle.extent(0)), groups = (rows + ActionCells::group - 1) / ActionCells::group;
  const ActionCells cells{middle, VectorField("action_low", groups), VectorField("action_high", groups),
                          size};
  Kokkos::parallel_for(
      "group_cells", Range(0, groups), KOKKOS_LAMBDA(int g) {
        const int begin = g * ActionCells::group, end = Kokkos::min(begin + ActionCells::group, rows);
        for (int d = 0; d < 3; ++d) {
          Real low = cells.middle(begin, d), high = low;
          for (int k = begin + 1; k < end; ++k)
            low = Kokkos::min(low, cells.middle(k, d)), high = Kokkos::max(high, cells.middle(k, d));
          cells.low(g, d) = low, cells.high(g, d) = high;
        }
      });
  return cells;
}

// No more than from x to the action in the nearest of the cells; 0 where there are none, so that all move.
SWARF_FN Real distance_to(const ActionCells& cells, const Vector3& x) {
  const int rows = int(cells.middle.extent(0));
  Real least = rows > 0 ? Kokkos::Experimental::infinity_v<Real> : Real(0);
  for (int g = 0; g * ActionCells::group < rows; ++g) {
    const Vector3 below = load_vector(cells.low, g) - x, above = x - load_vector(cells.high, g);
    const Vector3 out{Kokkos::max(Kokkos::max(below.x, above.x), Real(0)),
                      Kokkos::max(Kokkos::max(below.y, above.y), Real(0)),
                      Kokkos::max(Kokkos::max(below.z, above.z), Real(0))};
    if (!(dot(out, out) < least)) continue;
    const int end = Kokkos::min((g + 1) * ActionCells::group, rows);
    for (int k = g * ActionCells::group; k < end; ++k) {
      const Vector3 d = x - load_vector(cells.middle, k);
      least = Kokkos::min(least, dot(d, d));
    }
  }
  return Kokkos::max(Kokkos::sqrt(least) - Real(0.5) * Kokkos::sqrt(Real(3)) * cells.size, Real(0));
}

// place(i): 1 where row i is taken, else 0; becomes its number among those taken, else -1. Returns how many.
inline int number_taken(const IndexField& place) {
  int taken = 0;
  Kokkos::parallel_scan(
      "number_taken", Range(0, int(place.extent(0))),
      KOKKOS_LAMBDA(int i, int& sum, bool last) {
        const int own = place(i);
        if (last) place(i) = own ? sum : -1;
        sum += own;
      },
      taken);
  return taken;
}

// What permute copies to, for all fields of a sort. A few columns at a time: a copy of the widest field would
// be the most memory that a run asks for.
struct PermuteScratch {
  static constexpr std::size_t columns = 3;
  View<Real* [columns]> rows;

  explicit PermuteScratch(const KeyedRows& from)
      : rows(Kokkos::view_alloc(Kokkos::WithoutInitializing, "permute"), from.extent(0)) {}

  template <class T, std::size_t width>
  auto of() const {
    static_assert(width * sizeof(T) <= columns * sizeof(Real));
    using Copy = Kokkos::View<T* [width], ExecSpace::memory_space, Kokkos::MemoryUnmanaged>;
    return Copy(reinterpret_cast<T*>(rows.data()), rows.extent(0));
  }
};

// Row i becomes what row from(i).row was.
template <class T>
void permute(const View<T*>& field, const KeyedRows& from, const PermuteScratch& scratch) {
  if (field.extent(0) == 0) return;
  const int rows = int(from.extent(0));
  const auto copy = scratch.of<T, 1>();
  Kokkos::parallel_for(
      "permute", Range(0, rows), KOKKOS_LAMBDA(int i) { copy(i, 0) = field(from(i).row); });
  Kokkos::parallel_for(
      "permute", Range(0, rows), KOKKOS_LAMBDA(int i) { field(i) = copy(i, 0); });
}

template <class T, std::size_t columns>
void permute(const View<T* [columns]>& field, const KeyedRows& from, const PermuteScratch& scratch) {
  if (field.extent(0) == 0) return;
  constexpr std::size_t width = columns < PermuteScratch::columns ? columns : PermuteScratch::columns;
  const int rows = int(from.extent(0));
  const auto copy = scratch.of<T, width>();
  for (std::size_t first = 0; first < columns; first += width) {
    const std::size_t taken = Kokkos::min(width, columns - first);
    Kokkos::parallel_for(
        "permute", Range(0, rows), KOKKOS_LAMBDA(int i) {
          for (std::size_t c = 0; c < taken; ++c) copy(i, c) = field(from(i).row, first + c);
        });
    Kokkos::parallel_for(
        "permute", Range(0, rows), KOKKOS_LAMBDA(int i) {
          for (std::size_t c = 0; c < taken; ++c) field(i, first + c) = copy(i, c);
        });
  }
}

} // namespace swarf
