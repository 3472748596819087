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

CellGrid cell_grid(const VectorField& position, int rows, Real cell_size);

// Ascending keys; equal keys in the order of their rows. key_of(position) on the device.
template <class KeyOf>
KeyedRows sort_rows(const VectorField& position, int rows, const KeyOf& key_of) {
  const KeyedRows sorted(Kokkos::view_alloc(Kokkos::WithoutInitializing, "sorted_rows"), rows);
  Kokkos::parallel_for(
      "cell_key", Range(0, rows), KOKKOS_LAMBDA(int i) {
        sorted(i) = {key_of(load_vector(position, i)), i};
      });
  Kokkos::sort(
      ExecSpace{}, sorted, KOKKOS_LAMBDA(const KeyedRow& a, const KeyedRow& b) { return a < b; });
  return sorted;
}

} // namespace swarf
