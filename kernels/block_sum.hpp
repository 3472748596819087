// Sums that do not depend on the number of threads: fixed blocks of rows, each summed in order by one thread,
// then the blocks in order. Value needs a default constructor that is its zero and `void add(const Value&)`.
#pragma once
#include "swarf/core/types.hpp"
#include <string>

namespace swarf {

inline constexpr int block_rows = 1024;

template <class Value, class AddRow>
Value block_sum(const std::string& label, int rows, const AddRow& add_row) {
  const int blocks = (rows + block_rows - 1) / block_rows;
  const View<Value*> partial(Kokkos::view_alloc(Kokkos::WithoutInitializing, label), blocks);
  Kokkos::parallel_for(
      label, Range(0, blocks), KOKKOS_LAMBDA(int block) {
        Value sum;
        const int end = Kokkos::min(rows, (block + 1) * block_rows);
        for (int i = block * block_rows; i < end; ++i) add_row(i, sum);
        partial(block) = sum;
      });
  Value total;
  const auto parts = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, partial);
  for (int block = 0; block < blocks; ++block) total.add(parts(block));
  return total;
}

} // namespace swarf
