// Eigenvalues and eigenvectors of a symmetric tensor.
#pragma once
#include "swarf/core/tensor.hpp"

namespace swarf {

// Largest eigenvalue in closed form (Smith 1961).
SWARF_FN Real largest_eigenvalue(const Symmetric3& a) {
  const Real mean = trace(a) / Real(3);
  const Symmetric3 dev = deviator(a);
  const Real p = Kokkos::sqrt(contract(dev, dev) / Real(6));
  if (!(p > Real(0))) return mean;
  const Real r = Real(0.5) * determinant(to_tensor((Real(1) / p) * dev));
  const Real cosine = Kokkos::min(Kokkos::max(r, Real(-1)), Real(1)); // |r| <= 1 but for round-off
  return mean + Real(2) * p * Kokkos::cos(Kokkos::acos(cosine) / Real(3));
}

struct Eigen3 {
  Real value[3];
  Vector3 vector[3]; // unit, at right angles
};

// Jacobi's rotations in cyclic order (Golub & Van Loan, Matrix Computations, ch. 8.5). Five sweeps leave
// round-off: each squares what stands beside the diagonal.
SWARF_FN Eigen3 eigen_decomposition(const Symmetric3& symmetric) {
  const Tensor3 full = to_tensor(symmetric);
  Real a[3][3] = {{full.xx, full.xy, full.xz}, {full.yx, full.yy, full.yz}, {full.zx, full.zy, full.zz}};
  Real v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; // columns
  for (int sweep = 0; sweep < 5; ++sweep)
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (a[p][q] == Real(0)) continue;
        const Real half = Real(0.5) * (a[q][q] - a[p][p]) / a[p][q];
        const Real t =
            (half < Real(0) ? Real(-1) : Real(1)) / (Kokkos::abs(half) + Kokkos::sqrt(half * half + Real(1)));
        const Real c = Real(1) / Kokkos::sqrt(t * t + Real(1)), s = t * c;
        for (int k = 0; k < 3; ++k) { // columns, then rows
          const Real kp = a[k][p], kq = a[k][q];
          a[k][p] = c * kp - s * kq, a[k][q] = s * kp + c * kq;
          const Real vp = v[k][p], vq = v[k][q];
          v[k][p] = c * vp - s * vq, v[k][q] = s * vp + c * vq;
        }
        for (int k = 0; k < 3; ++k) {
          const Real pk = a[p][k], qk = a[q][k];
          a[p][k] = c * pk - s * qk, a[q][k] = s * pk + c * qk;
        }
      }
  Eigen3 e;
  for (int k = 0; k < 3; ++k) e.value[k] = a[k][k], e.vector[k] = {v[0][k], v[1][k], v[2][k]};
  return e;
}

} // namespace swarf
