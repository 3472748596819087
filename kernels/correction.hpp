// Correction of the kernel's gradient (Randles & Libersky 1996), shared by the gradients of both frames.
#pragma once
#include "swarf/kernels.hpp"

namespace swarf {

// K = A^-1 where the neighbours span space well: measured with the mean of A, which their number and volume
// scale, |K|^2 is 3 inside and 5 at a corner of a lattice. Where they do not (a lone pair, a stretched sheet)
// K amplifies noise without bound, and goes over to 1, the plain sum.
KOKKOS_INLINE_FUNCTION Tensor3 correction_from(const Tensor3& A) {
  const Real det = determinant(A);
  if (!(det > Real(0))) return identity3();
  const Tensor3 K = inverse(A, det);
  const Real* k = &K.xx;
  const Real mean = (A.xx + A.yy + A.zz) / Real(3);
  Real norm2 = 0;
  for (int c = 0; c < 9; ++c) norm2 += mean * mean * k[c] * k[c];
  const Real share = Kokkos::clamp((Real(24) - norm2) / Real(12), Real(0), Real(1));
  Tensor3 blend = identity3();
  Real* b = &blend.xx;
  for (int c = 0; c < 9; ++c) b[c] += share * (k[c] - b[c]);
  return blend;
}

// Whether K is A^-1, not blended with 1.
KOKKOS_INLINE_FUNCTION bool is_inverse(const Tensor3& K, const Tensor3& A) {
  const Real trace = K.xx * A.xx + K.yy * A.yy + K.zz * A.zz + K.xy * A.yx + K.xz * A.zx + K.yx * A.xy +
                     K.yz * A.zy + K.zx * A.xz + K.zy * A.yz;
  return Kokkos::abs(trace - Real(3)) < Real(1e-3);
}

// To where the forces will have sigma K, and to where conduct_heat looks for it.
KOKKOS_INLINE_FUNCTION void store_correction(const Particles& p, int i, const Tensor3& K) {
  store_tensor(p.pair_stress, i, K);
  if (p.heat_shape.extent(0) > 0) store_symmetric(p.heat_shape, i, symmetric_part(K));
}

} // namespace swarf
