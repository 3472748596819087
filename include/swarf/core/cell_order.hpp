// Orders of the cells of a grid: row by row, to search in, and along a Hilbert curve, to store by.
#pragma once
#include "swarf/core/tensor.hpp"

namespace swarf {

using CellKey = unsigned long long;
inline constexpr int cell_bits = 21; // cells per direction: 2^21

struct CellIndex {
  CellKey i, j, k;
};

// Cells of one size over a box from `origin`.
struct CellGrid {
  Vector3 origin{0, 0, 0};
  Real cell_size = 1;

  // What lies outside, or nowhere (not finite), is put into the first or the last cell.
  SWARF_FN CellKey index(Real x, Real x0) const {
    const Real i = Kokkos::floor((x - x0) / cell_size);
    return i > Real(0) ? (i < Real((1 << cell_bits) - 1) ? CellKey(i) : CellKey((1 << cell_bits) - 1))
                       : CellKey(0);
  }
  SWARF_FN CellIndex index(const Vector3& x) const {
    return {index(x.x, origin.x), index(x.y, origin.y), index(x.z, origin.z)};
  }
};

// Cells of one row along x have consecutive keys.
SWARF_FN CellKey row_key(const CellIndex& c) { return c.i | c.j << cell_bits | c.k << 2 * cell_bits; }

// Every third bit of the result is a bit of i.
SWARF_FN CellKey spread_bits(CellKey i) {
  i = (i | i << 32) & 0x001f00000000ffffULL;
  i = (i | i << 16) & 0x001f0000ff0000ffULL;
  i = (i | i << 8) & 0x100f00f00f00f00fULL;
  i = (i | i << 4) & 0x10c30c30c30c30c3ULL;
  return (i | i << 2) & 0x1249249249249249ULL;
}

// Place of a cell on the curve through 2^bits cells per direction: consecutive cells share a face. Skilling,
// AIP Conf. Proc. 707 (2004) 381: from the coarsest bit down, the finer ones are mirrored or have two axes
// exchanged; then Gray's code.
SWARF_FN CellKey hilbert_key(const CellIndex& c, int bits) {
  CellKey x[3] = {c.i, c.j, c.k};
  for (int b = bits - 1; b > 0; --b) {
    const CellKey bit = CellKey(1) << b, finer = bit - 1;
    for (int d = 0; d < 3; ++d) {
      const CellKey exchanged = (x[d] & bit) ? 0 : (x[0] ^ x[d]) & finer;
      x[0] ^= (x[d] & bit) ? finer : exchanged;
      x[d] ^= exchanged;
    }
  }
  x[1] ^= x[0], x[2] ^= x[1];
  CellKey turn = 0;
  for (int b = bits - 1; b > 0; --b)
    if (x[2] >> b & 1) turn ^= (CellKey(1) << b) - 1;
  return spread_bits(x[2] ^ turn) | spread_bits(x[1] ^ turn) << 1 | spread_bits(x[0] ^ turn) << 2;
}

} // namespace swarf
