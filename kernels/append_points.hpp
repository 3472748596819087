// Gathers the positions of some rows: those for which takes(row) is true on the device.
#pragma once
#include "cell_order.hpp"

namespace swarf {

// Appends to found after its first `count` rows; returns how many there are then.
template <class Takes>
int append_points(const VectorField& position, int rows, const Takes& takes, VectorField& found, int count) {
  const IndexField place("append_points_place", rows);
  Kokkos::parallel_for(
      "append_points", Range(0, rows), KOKKOS_LAMBDA(int i) { place(i) = takes(i) ? 1 : 0; });
  const int more = number_taken(place);
  ensure_rows(found, count + more);
  const VectorField to = found;
  Kokkos::parallel_for(
      "append_points", Range(0, rows), KOKKOS_LAMBDA(int i) {
        if (place(i) >= 0) store_vector(to, count + place(i), load_vector(position, i));
      });
  return count + more;
}

} // namespace swarf
