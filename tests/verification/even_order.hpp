// How evenly particles fill a body of plane strain: a slice that is periodic along z, and along x where a
// period is given.
#pragma once
#include "tests/verification/point_masses.hpp"

namespace swarf::test {

struct EvenOrder {
  double holes = 0;   // share of the inside that is farther than `hole` spacings from every particle
  double nearest = 0; // distance of the nearest neighbour / spacing, 5th percentile
};

// The middle of a cubic lattice's cell is 0.87 spacings from all corners, and 0.96 after a stretch of 1.5.
inline constexpr double hole = 1.1;

class SliceOrder {
 public:
  struct Slice {
    double spacing, z0, depth;   // begin and period along z
    double x0 = 0, x_period = 0; // none: not periodic
    std::vector<char> counts;    // by particle: neither it nor what is nearest to it counts; empty: all do
  };

  SliceOrder(const std::vector<Vector3>& position, const Slice& of) : slice(of), a(of.spacing) {
    for (std::size_t i = 0; i < position.size(); ++i) {
      const Vector3& x = position[i];
      const double z = x.z - slice.depth * std::floor((double(x.z) - slice.z0) / slice.depth);
      const double px = slice.x_period;
      const double along = px > 0 ? x.x - px * std::floor((double(x.x) - slice.x0) / px) : double(x.x);
      for (int k = -1; k <= 1; ++k)
        for (int m = px > 0 ? -1 : 0; m <= (px > 0 ? 1 : 0); ++m) {
          const double zk = z + k * slice.depth, xm = along + m * px;
          if (zk < slice.z0 - 4 * a || zk > slice.z0 + slice.depth + 4 * a) continue;
          if (px > 0 && (xm < slice.x0 - 8 * a || xm > slice.x0 + px + 8 * a)) continue;
          points.push_back({xm, double(x.y), zk, int(i), k == 0 && m == 0});
        }
    }
    make_grid();
  }

  EvenOrder measure() const {
    EvenOrder order;
    const std::vector<char> inside = inside_columns();
    double all = 0, empty = 0;
    const int levels = std::max(1, int(std::lround(slice.depth / step)));
    for (int column = 0; column < nx * ny; ++column) {
      const double x = x_min + step * (column % nx), y = y_min + step * (column / nx);
      if (!inside[std::size_t(column)]) continue;
      if (slice.x_period > 0 && (x < slice.x0 || x >= slice.x0 + slice.x_period)) continue;
      for (int level = 0; level < levels; ++level) {
        const double z = slice.z0 + (level + 0.5) * slice.depth / levels;
        const auto [r, i] = nearest_to(x, y, z, -1);
        if (i >= 0 && !counted(points[std::size_t(i)].row)) continue;
        all += 1, empty += r > hole * a;
      }
    }
    order.holes = all > 0 ? empty / all : 0;
    std::vector<double> distance;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i].own && counted(points[i].row))
        distance.push_back(nearest_to(points[i].x, points[i].y, points[i].z, int(i)).first / a);
    std::sort(distance.begin(), distance.end());
    order.nearest = distance.empty() ? 0 : distance[distance.size() / 20];
    return order;
  }

 private:
  struct Point {
    double x, y, z;
    int row;
    bool own; // no copy
  };
  Slice slice;
  double a, step = 0, x_min = 0, y_min = 0;
  int nx = 0, ny = 0; // columns, a quarter of the spacing wide
  std::vector<Point> points;
  std::vector<std::vector<int>> bins; // of 4 x 4 columns

  bool counted(int row) const { return slice.counts.empty() || slice.counts[std::size_t(row)]; }
  int bins_along() const { return nx / 4 + 1; }

  void make_grid() {
    step = a / 4;
    double x_max = points[0].x, y_max = points[0].y;
    x_min = x_max, y_min = y_max;
    for (const Point& p : points) {
      x_min = std::min(x_min, p.x), x_max = std::max(x_max, p.x);
      y_min = std::min(y_min, p.y), y_max = std::max(y_max, p.y);
    }
    x_min -= 4 * a, y_min -= 4 * a;
    nx = int((x_max + 4 * a - x_min) / step) + 1, ny = int((y_max + 4 * a - y_min) / step) + 1;
    bins.resize(std::size_t(bins_along() * (ny / 4 + 1)));
    for (std::size_t i = 0; i < points.size(); ++i)
      bins[std::size_t(int((points[i].y - y_min) / a) * bins_along() + int((points[i].x - x_min) / a))]
          .push_back(int(i));
  }

  // Distance and point: of those within three spacings.
  std::pair<double, int> nearest_to(double x, double y, double z, int except) const {
    double best = 9 * a * a;
    int found = -1;
    const int bx = int((x - x_min) / a), by = int((y - y_min) / a), rows = ny / 4 + 1;
    for (int ring = 0; ring <= 3 && best > std::pow((ring - 1) * a, 2); ++ring)
      for (int j = std::max(0, by - ring); j <= std::min(rows - 1, by + ring); ++j)
        for (int k = std::max(0, bx - ring); k <= std::min(bins_along() - 1, bx + ring); ++k) {
          if (std::max(std::abs(j - by), std::abs(k - bx)) != ring) continue;
          for (const int i : bins[std::size_t(j * bins_along() + k)]) {
            const Point& p = points[std::size_t(i)];
            const double r2 = std::pow(p.x - x, 2) + std::pow(p.y - y, 2) + std::pow(p.z - z, 2);
            if (i != except && r2 < best) best = r2, found = i;
          }
        }
    return {std::sqrt(best), found};
  }

  // Marks the columns nearer than `reach` to a place.
  void stamp(std::vector<char>& mark, double x, double y, double reach, char value) const {
    const int r = int(reach / step) + 1, cx = int((x - x_min) / step), cy = int((y - y_min) / step);
    for (int j = std::max(0, cy - r); j <= std::min(ny - 1, cy + r); ++j)
      for (int k = std::max(0, cx - r); k <= std::min(nx - 1, cx + r); ++k)
        if (std::hypot(x_min + step * k - x, y_min + step * j - y) < reach)
          mark[std::size_t(j * nx + k)] = value;
  }

  // A disc of two spacings that comes from without rolls around the particles: inside is what it leaves, less
  // what lies beyond the centres of the outer row.
  std::vector<char> inside_columns() const {
    const double disc = 2 * a;
    std::vector<char> body(std::size_t(nx * ny), 0);
    for (const Point& p : points) stamp(body, p.x, p.y, disc, 1);
    std::vector<char> outside(body.size(), 0);
    std::vector<int> front;
    const auto reach = [&](int k, int j) {
      if (k < 0 || j < 0 || k >= nx || j >= ny) return;
      const std::size_t c = std::size_t(j * nx + k);
      if (body[c] || outside[c]) return;
      outside[c] = 1, front.push_back(int(c));
    };
    for (int k = 0; k < nx; ++k) reach(k, 0), reach(k, ny - 1);
    for (int j = 0; j < ny && slice.x_period == 0; ++j) reach(0, j), reach(nx - 1, j);
    while (!front.empty()) {
      const int c = front.back(), k = c % nx, j = c / nx;
      front.pop_back();
      reach(k - 1, j), reach(k + 1, j), reach(k, j - 1), reach(k, j + 1);
    }
    std::vector<char> inside(body.size(), 1);
    for (int c = 0; c < nx * ny; ++c) {
      if (!outside[std::size_t(c)]) continue;
      inside[std::size_t(c)] = 0;
      const int k = c % nx, j = c / nx;
      bool border = false;
      for (const auto& [dk, dj] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
        if (k + dk >= 0 && k + dk < nx && j + dj >= 0 && j + dj < ny)
          border = border || !outside[std::size_t((j + dj) * nx + k + dk)];
      if (border) stamp(inside, x_min + step * k, y_min + step * j, disc, 0);
    }
    return inside;
  }
};

inline std::vector<Vector3> positions(const Particles& p) {
  const auto x = host_copy(p.position);
  std::vector<Vector3> all;
  for (int i = 0; i < p.count; ++i) all.push_back(load_vector(x, i));
  return all;
}

} // namespace swarf::test
