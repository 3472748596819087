// Finds the boxes that hold a point, by a uniform grid over all of them.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace swarf {

class BoxGrid {
 public:
  using Box = Eigen::AlignedBox3d;
  using Point = Eigen::Vector3d;

  explicit BoxGrid(const std::vector<Box>& boxes) {
    Point mean(0, 0, 0);
    for (const Box& b : boxes) all.extend(b), mean += b.sizes() / double(boxes.size());
    if (boxes.empty()) return;
    // Cells as large as the mean box; larger where most of the space is empty.
    for (double scale = 1;
         scale == 1 || double(cells[0]) * cells[1] * cells[2] > 4.0 * double(boxes.size()) + 64;
         scale *= 1.26)
      for (int d = 0; d < 3; ++d) {
        const double extent = all.sizes()[d];
        cells[d] =
            mean[d] > 0 ? std::max(1L, std::min(1L << 20, std::lround(extent / (scale * mean[d])))) : 1;
        size[d] = extent > 0 ? extent / double(cells[d]) : 1;
      }
    start.assign(std::size_t(cells[0] * cells[1] * cells[2]) + 1, 0);
    for (const Box& b : boxes) visit(b, [&](std::size_t c) { ++start[c + 1]; });
    for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
    entry.resize(std::size_t(start.back()));
    std::vector<long> next(start.begin(), start.end() - 1);
    for (std::size_t b = 0; b < boxes.size(); ++b)
      visit(boxes[b], [&](std::size_t c) { entry[std::size_t(next[c]++)] = int(b); });
  }

  // Calls visit(box) in ascending order for boxes of the point's cell: all that hold it, and others.
  // Stops when visit returns true.
  template <class Visit>
  void find(const Point& x, Visit&& call) const {
    if (start.empty() || !all.contains(x)) return;
    const std::size_t c = cell(index(x, 0), index(x, 1), index(x, 2));
    for (long e = start[c]; e < start[c + 1]; ++e)
      if (call(entry[std::size_t(e)])) return;
  }

 private:
  Box all;
  long cells[3] = {1, 1, 1};
  Point size{1, 1, 1};
  std::vector<long> start;
  std::vector<int> entry;

  std::size_t cell(long i, long j, long k) const { return std::size_t((i * cells[1] + j) * cells[2] + k); }
  long index(const Point& x, int d) const {
    return std::clamp(long(std::floor((x[d] - all.min()[d]) / size[d])), 0L, cells[d] - 1);
  }
  template <class Visit>
  void visit(const Box& b, Visit&& call) const {
    for (long i = index(b.min(), 0); i <= index(b.max(), 0); ++i)
      for (long j = index(b.min(), 1); j <= index(b.max(), 1); ++j)
        for (long k = index(b.min(), 2); k <= index(b.max(), 2); ++k) call(cell(i, j, k));
  }
};

} // namespace swarf
