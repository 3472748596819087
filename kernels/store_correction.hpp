// Where the gradients of both frames leave their correction.
#pragma once
#include "swarf/kernels.hpp"
#include "swarf/particles/correction.hpp"

namespace swarf {

// To where the forces will have sigma K, and to where conduct_heat looks for it.
KOKKOS_INLINE_FUNCTION void store_correction(const Particles& p, int i, const Tensor3& K) {
  store_tensor(p.pair_stress, i, K);
  if (p.heat_shape.extent(0) > 0) store_symmetric(p.heat_shape, i, symmetric_part(K));
}

} // namespace swarf
