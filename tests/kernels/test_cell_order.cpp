#include "swarf/core/cell_order.hpp"
#include <gtest/gtest.h>
#include <vector>

namespace swarf {
namespace {

// The definition of a Hilbert curve: it visits every cell once, and each next cell shares a face with the
// last.
TEST(CellOrder, HilbertCurveVisitsEveryCellByItsFaces) {
  for (int bits = 0; bits <= 4; ++bits) {
    const int n = 1 << bits;
    std::vector<std::vector<CellIndex>> at(n * n * n);
    for (CellKey i = 0; i < CellKey(n); ++i)
      for (CellKey j = 0; j < CellKey(n); ++j)
        for (CellKey k = 0; k < CellKey(n); ++k) {
          const CellKey key = hilbert_key({i, j, k}, bits);
          ASSERT_LT(key, at.size());
          at[key].push_back({i, j, k});
        }
    for (std::size_t key = 0; key < at.size(); ++key) {
      ASSERT_EQ(at[key].size(), 1u) << key;
      if (key == 0) continue;
      const auto step = [](CellKey a, CellKey b) { return a > b ? a - b : b - a; };
      const CellIndex a = at[key - 1][0], b = at[key][0];
      EXPECT_EQ(step(a.i, b.i) + step(a.j, b.j) + step(a.k, b.k), 1u) << key;
    }
  }
}

TEST(CellOrder, AllBitsFit) {
  const CellKey last = (1 << cell_bits) - 1;
  EXPECT_LT(hilbert_key({last, last, last}, cell_bits), CellKey(1) << 3 * cell_bits);
  EXPECT_EQ(row_key({last, last, last}), (CellKey(1) << 3 * cell_bits) - 1);
}

TEST(CellOrder, PointsOutsideOrNowhereFallIntoTheOuterCells) {
  const CellGrid grid{{1, 1, 1}, Real(0.5)};
  const Real infinity = Kokkos::Experimental::infinity_v<Real>;
  const CellIndex c = grid.index(Vector3{Real(0.5), infinity, infinity - infinity});
  EXPECT_EQ(c.i, 0u);
  EXPECT_EQ(c.j, CellKey((1 << cell_bits) - 1));
  EXPECT_EQ(c.k, 0u);
}

} // namespace
} // namespace swarf
