// The scalar of pair sums: a pack of particles in SIMD lanes on a CPU, one Real on a GPU.
#pragma once
#include "swarf/types.hpp"

#if defined(KOKKOS_ENABLE_CUDA) || defined(KOKKOS_ENABLE_HIP) || defined(KOKKOS_ENABLE_SYCL)
#define SWARF_ONE_LANE
#else
#include <Kokkos_SIMD.hpp>
#endif

namespace swarf {

KOKKOS_FORCEINLINE_FUNCTION Real select(bool mask, Real a, Real b) { return mask ? a : b; }

#ifdef SWARF_ONE_LANE
using Pack = Real;
inline constexpr int pack_width = 1;

template <class Lane>
KOKKOS_FORCEINLINE_FUNCTION Pack make_pack(const Lane& lane) {
  return lane(0);
}
KOKKOS_FORCEINLINE_FUNCTION Real lane_of(const Pack& p, int) { return p; }
KOKKOS_FORCEINLINE_FUNCTION bool any_less(const Pack& a, Real b) { return a < b; }
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
KOKKOS_FORCEINLINE_FUNCTION bool any_less(const Pack& a, Real b) {
  return Kokkos::Experimental::any_of(a < Pack(b));
}
#endif

} // namespace swarf
