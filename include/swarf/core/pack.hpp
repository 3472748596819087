// The scalar of pair sums: a pack of particles in SIMD lanes on a CPU, one Real on a GPU.
#pragma once
#include "swarf/core/types.hpp"

#if defined(KOKKOS_ENABLE_CUDA) || defined(KOKKOS_ENABLE_HIP) || defined(KOKKOS_ENABLE_SYCL)
#define SWARF_ONE_LANE
#else
#include <Kokkos_SIMD.hpp>
#include <type_traits>
#endif

namespace swarf {

KOKKOS_FORCEINLINE_FUNCTION Real select(bool mask, Real a, Real b) { return mask ? a : b; }
KOKKOS_FORCEINLINE_FUNCTION Real reciprocal(Real x) { return Real(1) / x; }
KOKKOS_FORCEINLINE_FUNCTION Real inverse_sqrt(Real x) { return Kokkos::rsqrt(x); }

#ifdef SWARF_ONE_LANE
using Pack = Real;
inline constexpr int pack_width = 1;

template <class Lane>
KOKKOS_FORCEINLINE_FUNCTION Pack make_pack(const Lane& lane) {
  return lane(0);
}
KOKKOS_FORCEINLINE_FUNCTION Real lane_of(const Pack& p, int) { return p; }
KOKKOS_FORCEINLINE_FUNCTION bool any_of(bool mask) { return mask; }
#else
using Pack = Kokkos::Experimental::simd<Real>;
inline constexpr int pack_width = int(Pack::size());

template <class Lane>
KOKKOS_FORCEINLINE_FUNCTION Pack make_pack(const Lane& lane) {
  return Pack([&](auto i) { return lane(int(i)); });
}
KOKKOS_FORCEINLINE_FUNCTION Real lane_of(const Pack& p, int lane) { return p[lane]; }
KOKKOS_FORCEINLINE_FUNCTION Pack select(const Pack::mask_type& mask, const Pack& a, const Pack& b) {
  return Kokkos::Experimental::condition(mask, a, b);
}
KOKKOS_FORCEINLINE_FUNCTION bool any_of(const Pack::mask_type& mask) {
#ifdef KOKKOS_ARCH_AVX512XEON // Kokkos asks lane by lane, a branch each
  using Bits = std::conditional_t<sizeof(Real) == 4, __mmask16, __mmask8>;
  return static_cast<Bits>(mask) != 0;
#else
  return Kokkos::Experimental::any_of(mask);
#endif
}

// 1 / x and 1 / sqrt(x) of normal numbers x > 0, to a few units in the last place. A processor with AVX-512
// divides 8 lanes in the time of some 30 multiplications, but estimates to 14 bits in that of a few. With e,
// what the estimate r misses, 1 / x = r (1 + e + ..), e = 1 - x r, and 1 / sqrt(x) = r (1 + e / 2 + 3 e^2 / 8
// + ..), e = 1 - x r^2: four terms are 56 bits, two 28.
#ifdef KOKKOS_ARCH_AVX512XEON
#ifdef SWARF_FLOAT
KOKKOS_FORCEINLINE_FUNCTION Pack estimate_reciprocal(const Pack& x) {
  return Pack(_mm512_rcp14_ps(static_cast<__m512>(x)));
}
KOKKOS_FORCEINLINE_FUNCTION Pack estimate_inverse_sqrt(const Pack& x) {
  return Pack(_mm512_rsqrt14_ps(static_cast<__m512>(x)));
}
#else
KOKKOS_FORCEINLINE_FUNCTION Pack estimate_reciprocal(const Pack& x) {
  return Pack(_mm512_rcp14_pd(static_cast<__m512d>(x)));
}
KOKKOS_FORCEINLINE_FUNCTION Pack estimate_inverse_sqrt(const Pack& x) {
  return Pack(_mm512_rsqrt14_pd(static_cast<__m512d>(x)));
}
#endif

KOKKOS_FORCEINLINE_FUNCTION Pack reciprocal(const Pack& x) {
  const Pack r = estimate_reciprocal(x), e = Pack(Real(1)) - x * r, two_terms = r + r * e;
  return sizeof(Real) == 4 ? two_terms : two_terms + two_terms * (e * e);
}
KOKKOS_FORCEINLINE_FUNCTION Pack inverse_sqrt(const Pack& x) {
  const Pack r = estimate_inverse_sqrt(x), e = Pack(Real(1)) - (x * r) * r, half(Real(0.5));
  const Pack terms = sizeof(Real) == 4 ? half : half + e * (Pack(Real(0.375)) + Pack(Real(0.3125)) * e);
  return r + (r * e) * terms;
}
#else
KOKKOS_FORCEINLINE_FUNCTION Pack reciprocal(const Pack& x) { return Pack(Real(1)) / x; }
KOKKOS_FORCEINLINE_FUNCTION Pack inverse_sqrt(const Pack& x) { return Pack(Real(1)) / Kokkos::sqrt(x); }
#endif
#endif

} // namespace swarf
