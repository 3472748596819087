// What a kernel reports when the computation goes wrong. The host reads it and ends the run.
#pragma once
#include "swarf/core/types.hpp"

namespace swarf {

enum class Fault : int { non_finite = 1, inverted_hex, return_mapping, particle_lost, skin_exceeded };

// Holds no_fault, or fault * 2^32 + index of the particle or hex.
using Status = View<unsigned long long>;
inline constexpr unsigned long long no_fault = ~0ULL;

// Atomic because any thread may find a fault; the minimum does not depend on who comes first.
KOKKOS_INLINE_FUNCTION void report(const Status& status, Fault fault, int index) {
  Kokkos::atomic_min(&status(), (static_cast<unsigned long long>(fault) << 32) + unsigned(index));
}

} // namespace swarf
