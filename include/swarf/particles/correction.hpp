// Correction of the kernel's gradient (Randles & Libersky 1996), shared by the gradients of both frames.
#pragma once
#include "swarf/core/eigen.hpp"

namespace swarf {

struct Correction {
  Tensor3 K;
  bool exact; // K = A^-1: the gradient of a linear field is exact in every direction
};

// Least eigenvalue of A that is inverted as it is. A = sum_j V_j (x_j - x_i) (x) grad W_ij is 0.98 inside;
// its least eigenvalue over the mean of the three is 0.7 in a face, 0.6 in an edge or a corner of a lattice,
// and 0.45 in disorder of a fifth of a spacing.
SWARF_FN Real least_inverted(const Symmetric3& A) { return Real(0.25) * trace(A) / Real(3); }

// A tenth is a single row of particles that leaves the support: below it the neighbours fade out of the sum,
// instead of being weighed ever more until they vanish. Not for tied particles, whose volumes are small.
constexpr Real fading = Real(0.1);

// a - s 1 is positive definite: Sylvester's criterion.
SWARF_FN bool exceeds(const Symmetric3& a, Real s) {
  const Symmetric3 b = a + Symmetric3{-s, -s, -s, 0, 0, 0};
  return b.xx > Real(0) && b.xx * b.yy - b.xy * b.xy > Real(0) && determinant(to_tensor(b)) > Real(0);
}

// K = sum_k e_k e_k / max(a_k, least): in directions in which there are neighbours enough (within a sheet,
// along a string) the gradient stays exact; in others, where A^-1 would amplify noise without bound, it is
// bounded.
SWARF_FN Correction correction_from(const Symmetric3& A, bool is_tied = false) {
  const Real least = is_tied ? least_inverted(A) : Kokkos::max(least_inverted(A), Real(fading));
  if (exceeds(A, least)) {
    const Tensor3 full = to_tensor(A);
    return {inverse(full, determinant(full)), true};
  }
  const Eigen3 e = eigen_decomposition(A);
  Symmetric3 K{};
  for (int k = 0; k < 3; ++k) {
    const Vector3& v = e.vector[k];
    K = K + (Real(1) / Kokkos::max(e.value[k], least)) *
                Symmetric3{v.x * v.x, v.y * v.y, v.z * v.z, v.x * v.y, v.y * v.z, v.z * v.x};
  }
  return {to_tensor(K), false};
}

} // namespace swarf
