// Cubic spline kernel of Monaghan & Lattanzio (1985) in three dimensions; support 2 h.
// S is Real or Pack; q = r / h.
#pragma once
#include "swarf/pack.hpp"

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
  const S inverse_q = inverse_sqrt(Kokkos::max(q2, S(Real(1e-30)))), q = q2 * inverse_q;
  const S far = Kokkos::max(S(Real(2)) - q, S(Real(0)));
  const S inside = S(Real(2.25)) * q - S(Real(3));
  const S outside = S(Real(-0.75)) * far * far * inverse_q;
  return S(inverse_pi) * select(q < S(Real(1)), inside, outside);
}

} // namespace swarf
