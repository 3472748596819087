// Rows of points sorted by a whole number that each has, such as the cell that it touches: lists that do not
// depend on the number of threads.
#pragma once
#include "swarf/core/types.hpp"
#include <string>

namespace swarf {

// Rows of the points of each key: source[first[k] .. first[k + 1]), in any order. first has keys + 1 rows.
template <class Takes>
void list_rows_by_key(const std::string& label, const IndexField& key, int rows, const IndexField& first,
                      const IndexField& source, const Takes& takes) {
  Kokkos::deep_copy(first, 0);
  Kokkos::parallel_for(
      label + "_count", Range(0, rows), KOKKOS_LAMBDA(const int i) {
        // Atomic on an integer: a count is the same in any order.
        if (takes(i)) Kokkos::atomic_inc(&first(key(i)));
      });
  Kokkos::parallel_scan(
      label + "_start", Range(0, int(first.extent(0))),
      KOKKOS_LAMBDA(const int k, int& sum, const bool is_last) {
        sum += first(k);
        if (is_last) first(k) = sum; // one past the key's last: the next launch counts down
      });
  Kokkos::parallel_for(
      label + "_place", Range(0, rows), KOKKOS_LAMBDA(const int i) {
        if (takes(i)) source(Kokkos::atomic_dec_fetch(&first(key(i)))) = i;
      });
}

KOKKOS_INLINE_FUNCTION void sort_rows(const IndexField& rows, int begin, int end) { // few: by insertion
  for (int k = begin + 1; k < end; ++k) {
    const int row = rows(k);
    int at = k;
    for (; at > begin && rows(at - 1) > row; --at) rows(at) = rows(at - 1);
    rows(at) = row;
  }
}

} // namespace swarf
