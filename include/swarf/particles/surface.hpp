// The outer row of particles: what a one-sided kernel misses (correct_surface.cpp).
#pragma once
#include "swarf/core/tensor.hpp"

namespace swarf {

// Whether neighbours lack at a face, 0 to 1: from the mean of sum_j w x x, on cubic lattices of h = 1.2
// spacings 0.98 inside, 0.97 one row below a face, 0.68 in it, 0.47 in an edge and 0.31 in a corner. In edges
// and corners n is along the diagonal and no derivative is along the surface: the correction would take a
// tenth to a quarter of the stable step there, and a column that is twisted fast does not stay bounded with
// it.
SWARF_FN Real lacking_neighbors(const Tensor3& A) {
  const Real mean = (A.xx + A.yy + A.zz) / Real(3);
  return Kokkos::clamp((Real(0.9) - mean) / Real(0.1), Real(0), Real(1)) *
         Kokkos::clamp((mean - Real(0.5)) / Real(0.1), Real(0), Real(1));
}

// s~ of row i.
SWARF_FN Vector3 load_shift(const View<Real* [4]>& surface_shift, int i) {
  return {surface_shift(i, 1), surface_shift(i, 2), surface_shift(i, 3)};
}

// A (1 - n n), n the direction of the shift: derivatives along the surface.
SWARF_FN Tensor3 along_surface(const Tensor3& A, const Vector3& shift) {
  const Vector3 across = (Real(1) / dot(shift, shift)) * multiply(A, shift);
  return {A.xx - across.x * shift.x, A.xy - across.x * shift.y, A.xz - across.x * shift.z,
          A.yx - across.y * shift.x, A.yy - across.y * shift.y, A.yz - across.y * shift.z,
          A.zx - across.z * shift.x, A.zy - across.z * shift.y, A.zz - across.z * shift.z};
}

} // namespace swarf
