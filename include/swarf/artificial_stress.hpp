// Artificial stress against the tensile instability: Gray, Monaghan & Swift (2001),
// R = -epsilon * (the tensile part of the stress in its principal frame).
#pragma once
#include "swarf/tensor.hpp"

namespace swarf {

// All principal values <= 0: no principal minor of -a is negative.
SWARF_FN bool has_no_tension(const Symmetric3& a) {
  return a.xx <= 0 && a.xx * a.yy - a.xy * a.xy >= 0 && a.yy <= 0 && a.zz <= 0 &&
         determinant(to_tensor(a)) <= 0 && a.yy * a.zz - a.yz * a.yz >= 0 && a.xx * a.zz - a.zx * a.zx >= 0;
}

// One Jacobi rotation of the pair (p, q); the eigenvectors are the columns of v.
SWARF_FN void rotate_pair(Real a[3][3], Real v[3][3], int p, int q) {
  if (a[p][q] == Real(0)) return;
  const Real theta = (a[q][q] - a[p][p]) / (Real(2) * a[p][q]);
  const Real t =
      Kokkos::copysign(Real(1), theta) / (Kokkos::abs(theta) + Kokkos::sqrt(theta * theta + Real(1)));
  const Real c = Real(1) / Kokkos::sqrt(t * t + Real(1)), s = t * c;
  for (int k = 0; k < 3; ++k) {
    const Real kp = a[k][p], kq = a[k][q];
    a[k][p] = c * kp - s * kq, a[k][q] = s * kp + c * kq;
  }
  for (int k = 0; k < 3; ++k) {
    const Real pk = a[p][k], qk = a[q][k], vp = v[k][p], vq = v[k][q];
    a[p][k] = c * pk - s * qk, a[q][k] = s * pk + c * qk;
    v[k][p] = c * vp - s * vq, v[k][q] = s * vp + c * vq;
  }
}

// sum over positive principal values of lambda n (x) n, by cyclic Jacobi sweeps (five give round-off).
SWARF_FN Symmetric3 tensile_part(const Symmetric3& s) {
  if (has_no_tension(s)) return {0, 0, 0, 0, 0, 0};
  Real a[3][3] = {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  Real v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int sweep = 0; sweep < 5; ++sweep)
    rotate_pair(a, v, 0, 1), rotate_pair(a, v, 1, 2), rotate_pair(a, v, 0, 2);
  Symmetric3 tension{0, 0, 0, 0, 0, 0};
  for (int k = 0; k < 3; ++k) {
    const Real x = v[0][k], y = v[1][k], z = v[2][k];
    if (a[k][k] > 0) tension = tension + a[k][k] * Symmetric3{x * x, y * y, z * z, x * y, y * z, z * x};
  }
  return tension;
}

} // namespace swarf
