// Points by cell, to ask whether one is near.
#pragma once
#include "cell_order.hpp"

namespace swarf {

struct PointGrid {
  CellGrid grid;
  KeyedRows rows;
  VectorField point;
  int count = 0;

  SWARF_FN bool any_within(const Vector3& x, Real reach) const {
    const Vector3 r{reach, reach, reach};
    const CellIndex low = grid.index(x - r), high = grid.index(x + r);
    for (CellKey k = low.k; k <= high.k; ++k)
      for (CellKey j = low.j; j <= high.j; ++j) {
        const CellKey last = row_key({high.i, j, k});
        for (int at = lower_bound(rows, count, row_key({low.i, j, k})); at < count && rows(at).key <= last;
             ++at) {
          const Vector3 d = x - load_vector(point, rows(at).row);
          if (dot(d, d) <= reach * reach) return true;
        }
      }
    return false;
  }
};

inline PointGrid make_point_grid(const VectorField& points, Real cell) {
  const int count = int(points.extent(0));
  const CellGrid grid = cell_grid(points, count, cell);
  return {grid, sort_rows(points, first_rows(count), RowKeyOf{grid}), points, count};
}

} // namespace swarf
