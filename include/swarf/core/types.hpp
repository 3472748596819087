// Scalars, execution space and View aliases used everywhere.
#pragma once
#include <Kokkos_Core.hpp>

namespace swarf {

#ifdef SWARF_FLOAT
using Real = float;
#else
using Real = double;
#endif

using ExecSpace = Kokkos::DefaultExecutionSpace;
using Range = Kokkos::RangePolicy<ExecSpace>;
// Where dear rows lie side by side, as those near the edge do: threads take them in small portions.
using UnevenRange = Kokkos::RangePolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>;

// Default layout: rows are contiguous on a CPU, columns on a GPU.
template <class Data>
using View = Kokkos::View<Data, ExecSpace::memory_space>;
using ScalarField = View<Real*>;
using VectorField = View<Real* [3]>;
using SymmetricField = View<Real* [6]>; // order of Symmetric3: xx yy zz xy yz zx
using TensorField = View<Real* [9]>;    // row-major
using IndexField = View<int*>;

template <class Data>
auto host_copy(const View<Data>& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
}

// Copies src[perm[i]] to dst[i] happens in kernels; growing a field keeps its old rows.
template <class Data>
void ensure_rows(View<Data>& view, std::size_t rows) {
  if (view.extent(0) < rows) Kokkos::resize(view, rows);
}

} // namespace swarf
