// Cubic spline kernel of Monaghan & Lattanzio (1985) in three dimensions; support 2 h.
// S is Real or Pack; q = r / h.
#pragma once
#include "swarf/core/pack.hpp"

namespace swarf {

inline constexpr Real inverse_pi = Real(0.31830988618379067154);
inline constexpr Real support_ratio = 2; // support / h

// h^3 W
template <class S>
KOKKOS_FORCEINLINE_FUNCTION S kernel_shape(const S& q) {
  const S far = Kokkos::max(S(Real(2)) - q, S(Real(0)));
  const S near = Kokkos::max(S(Real(1)) - q, S(Real(0)));
  return S(inverse_pi) * (S(Real(0.25)) * far * far * far - near * near * near);
}

// h^5 (dW/dr) / r from q^2: the gradient is this times x_ij / h^5. Finite at q = 0, so that no pair is
// special.
template <class S>
KOKKOS_FORCEINLINE_FUNCTION S kernel_slope(const S& q2) {
  constexpr Real c = Real(0.75) * inverse_pi;
  const S above_0 = q2 + S(Real(1e-30)), inverse_q = inverse_sqrt(above_0), q = above_0 * inverse_q;
  const S inside = S(3 * c) * q - S(4 * c);
  const S outside = (S(c) * q - S(2 * c)) * (Kokkos::max(S(Real(2)) - q, S(Real(0))) * inverse_q);
  return select(q < S(Real(1)), inside, outside);
}

} // namespace swarf
