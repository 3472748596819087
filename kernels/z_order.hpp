// Shared by the kernels that order rows in space: the box of a set of points and its sorted keys.
#pragma once
#include "swarf/kernels.hpp"
#include "swarf/z_order.hpp"
#include <Kokkos_Sort.hpp>

namespace swarf {

struct SortedRows {
  View<ZKey*> key; // ascending; equal keys in the order of their rows
  IndexField row;
};

ZGrid z_grid(const VectorField& position, int rows, Real cell_size);
SortedRows sort_rows(const VectorField& position, int rows, const ZGrid& grid);

} // namespace swarf
