// Z-order (Morton) keys of cells: particles that are near in space are near in memory.
#pragma once
#include "swarf/tensor.hpp"

namespace swarf {

using ZKey = unsigned long long;
inline constexpr int z_bits = 21; // cells per direction: 2^21

// Every third bit of the result is a bit of i.
SWARF_FN ZKey spread_bits(ZKey i) {
  i = (i | i << 32) & 0x001f00000000ffffULL;
  i = (i | i << 16) & 0x001f0000ff0000ffULL;
  i = (i | i << 8) & 0x100f00f00f00f00fULL;
  i = (i | i << 4) & 0x10c30c30c30c30c3ULL;
  return (i | i << 2) & 0x1249249249249249ULL;
}

SWARF_FN ZKey z_key(ZKey i, ZKey j, ZKey k) {
  return spread_bits(i) | spread_bits(j) << 1 | spread_bits(k) << 2;
}

// Cells of one size over a box from `origin`.
struct ZGrid {
  Vector3 origin{0, 0, 0};
  Real cell_size = 1;

  SWARF_FN ZKey index(Real x, Real x0) const {
    const Real i = Kokkos::floor((x - x0) / cell_size);
    return i > Real(0) ? (i < Real((1 << z_bits) - 1) ? ZKey(i) : ZKey((1 << z_bits) - 1)) : ZKey(0);
  }
  SWARF_FN ZKey key(const Vector3& x) const {
    return z_key(index(x.x, origin.x), index(x.y, origin.y), index(x.z, origin.z));
  }
};

} // namespace swarf
