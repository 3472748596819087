// The distance of a point from the active region (freeze.hpp), for the kernels that freeze.
#pragma once
#include "swarf/kernels.hpp"

namespace swarf {

// Boxes around runs of 16 boxes of the level below.
struct BoxRuns {
  static constexpr int length = 16;
  VectorField low, high;

  SWARF_FN int count() const { return int(low.extent(0)); }
  SWARF_FN Real squared_distance(int run, const Vector3& x) const {
    const Vector3 below = load_vector(low, run) - x, above = x - load_vector(high, run);
    const Vector3 out{Kokkos::max(Kokkos::max(below.x, above.x), Real(0)),
                      Kokkos::max(Kokkos::max(below.y, above.y), Real(0)),
                      Kokkos::max(Kokkos::max(below.z, above.z), Real(0))};
    return dot(out, out);
  }
};

inline BoxRuns box_runs(const VectorField& low, const VectorField& high) {
  const int rows = int(low.extent(0)), count = (rows + BoxRuns::length - 1) / BoxRuns::length;
  const BoxRuns runs{VectorField("region_low", count), VectorField("region_high", count)};
  Kokkos::parallel_for(
      "box_runs", Range(0, count), KOKKOS_LAMBDA(int run) {
        const int begin = run * BoxRuns::length, end = Kokkos::min(begin + BoxRuns::length, rows);
        for (int d = 0; d < 3; ++d) {
          Real least = low(begin, d), most = high(begin, d);
          for (int k = begin + 1; k < end; ++k)
            least = Kokkos::min(least, low(k, d)), most = Kokkos::max(most, high(k, d));
          runs.low(run, d) = least, runs.high(run, d) = most;
        }
      });
  return runs;
}

// find_active_region gives the middles along a Hilbert curve, so that the boxes are small.
struct RegionCells {
  VectorField middle;
  BoxRuns runs, runs_of_runs;
  Real size, beyond;
};

inline RegionCells group_cells(const VectorField& region, const Freeze& s) {
  const BoxRuns runs = box_runs(region, region);
  const Real farthest = s.distance + s.margin + s.reach;
  return {region, runs, box_runs(runs.low, runs.high), s.cell, Real(1.01) * farthest};
}

// No more than from x to the active region in the nearest of the cells, or `beyond`, which is farther than
// freezing asks; 0 where there are none, so that all move.
SWARF_FN Real distance_to(const RegionCells& cells, const Vector3& x) {
  const int rows = int(cells.middle.extent(0)), length = BoxRuns::length;
  if (rows == 0) return 0;
  const Real half_diagonal = Real(0.5) * Kokkos::sqrt(Real(3)) * cells.size;
  Real least = (cells.beyond + half_diagonal) * (cells.beyond + half_diagonal);
  for (int outer = 0; outer < cells.runs_of_runs.count(); ++outer) {
    if (!(cells.runs_of_runs.squared_distance(outer, x) < least)) continue;
    const int last = Kokkos::min((outer + 1) * length, cells.runs.count());
    for (int run = outer * length; run < last; ++run) {
      if (!(cells.runs.squared_distance(run, x) < least)) continue;
      const int end = Kokkos::min((run + 1) * length, rows);
      for (int k = run * length; k < end; ++k) {
        const Vector3 d = x - load_vector(cells.middle, k);
        least = Kokkos::min(least, dot(d, d));
      }
    }
  }
  return Kokkos::max(Kokkos::sqrt(least) - half_diagonal, Real(0));
}

} // namespace swarf
