// Shared by the kernels that order rows in space: the grid from the least corner of a set of points, and
// sorting.
#pragma once
#include "swarf/core/cell_order.hpp"
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

// Place along a Hilbert curve.
struct HilbertKeyOf {
  CellGrid grid;
  int bits;
  SWARF_FN CellKey operator()(const Vector3& x) const { return hilbert_key(grid.index(x), bits); }
};
HilbertKeyOf hilbert_key_of(const VectorField& position, int rows, const CellGrid& grid);

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

// Row to(k) becomes what row from(k) was; both hold the same rows.
struct Moves {
  IndexField to, from;
  int count() const { return int(to.extent(0)); }
};

// What permute copies to, for all fields of a sort. A few columns at a time: a copy of the widest field would
// be the most memory that a run asks for.
struct PermuteScratch {
  static constexpr std::size_t columns = 3;
  View<Real* [columns]> rows;

  explicit PermuteScratch(const Moves& moves)
      : rows(Kokkos::view_alloc(Kokkos::WithoutInitializing, "permute"), moves.count()) {}

  template <class T, std::size_t width>
  auto of() const {
    static_assert(width * sizeof(T) <= columns * sizeof(Real));
    using Copy = Kokkos::View<T* [width], ExecSpace::memory_space, Kokkos::MemoryUnmanaged>;
    return Copy(reinterpret_cast<T*>(rows.data()), rows.extent(0));
  }
};

template <class T>
void permute(const View<T*>& field, const Moves& moves, const PermuteScratch& scratch) {
  if (field.extent(0) == 0) return;
  const auto copy = scratch.of<T, 1>();
  Kokkos::parallel_for(
      "permute", Range(0, moves.count()), KOKKOS_LAMBDA(int k) { copy(k, 0) = field(moves.from(k)); });
  Kokkos::parallel_for(
      "permute", Range(0, moves.count()), KOKKOS_LAMBDA(int k) { field(moves.to(k)) = copy(k, 0); });
}

template <class T, std::size_t columns>
void permute(const View<T* [columns]>& field, const Moves& moves, const PermuteScratch& scratch) {
  if (field.extent(0) == 0) return;
  constexpr std::size_t width = columns < PermuteScratch::columns ? columns : PermuteScratch::columns;
  const auto copy = scratch.of<T, width>();
  for (std::size_t first = 0; first < columns; first += width) {
    const std::size_t taken = Kokkos::min(width, columns - first);
    Kokkos::parallel_for(
        "permute", Range(0, moves.count()), KOKKOS_LAMBDA(int k) {
          for (std::size_t c = 0; c < taken; ++c) copy(k, c) = field(moves.from(k), first + c);
        });
    Kokkos::parallel_for(
        "permute", Range(0, moves.count()), KOKKOS_LAMBDA(int k) {
          for (std::size_t c = 0; c < taken; ++c) field(moves.to(k), first + c) = copy(k, c);
        });
  }
}

} // namespace swarf
