#include "src/isoparametric.hpp"
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace swarf {

using Point = Eigen::Vector3d;

std::optional<std::array<double, 8>> locate_in_hex(const std::array<Point, 8>& corner, const Point& x) {
  static constexpr int sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                     {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  Point xi(0, 0, 0);
  std::array<double, 8> N{};
  // Newton's method on sum N_a(xi) x_a = x. Far outside it may leave the hex for good: then the point is not
  // in it.
  for (int pass = 0; pass < 30; ++pass) {
    Point residual = x;
    Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
    for (int a = 0; a < 8; ++a) {
      const double f[3] = {1 + sign[a][0] * xi[0], 1 + sign[a][1] * xi[1], 1 + sign[a][2] * xi[2]};
      N[a] = f[0] * f[1] * f[2] / 8;
      residual -= N[a] * corner[a];
      J += corner[a] *
           Eigen::RowVector3d(sign[a][0] * f[1] * f[2], f[0] * sign[a][1] * f[2], f[0] * f[1] * sign[a][2]) /
           8;
    }
    const Point step = J.partialPivLu().solve(residual);
    if (!step.allFinite() || xi.cwiseAbs().maxCoeff() > 10) return std::nullopt;
    if (step.cwiseAbs().maxCoeff() < 1e-13 || pass == 29) break;
    xi += step;
  }
  if (xi.cwiseAbs().maxCoeff() > 1 + 1e-9) return std::nullopt;
  return N;
}

NearestOnQuad nearest_on_quad(const std::array<Point, 4>& corner, const Point& x) {
  double u[2] = {0, 0};
  const auto shape_at = [&] {
    return std::array<double, 4>{(1 - u[0]) * (1 - u[1]) / 4, (1 + u[0]) * (1 - u[1]) / 4,
                                 (1 + u[0]) * (1 + u[1]) / 4, (1 - u[0]) * (1 + u[1]) / 4};
  };
  const auto offset = [&] {
    const auto N = shape_at();
    return Point(x - N[0] * corner[0] - N[1] * corner[1] - N[2] * corner[2] - N[3] * corner[3]);
  };
  // Gauss-Newton on the squared distance; a coordinate at its bound whose slope points outwards is held
  // there.
  for (int pass = 0; pass < 50; ++pass) {
    const Point r = offset();
    const Point t[2] = {((1 - u[1]) * (corner[1] - corner[0]) + (1 + u[1]) * (corner[2] - corner[3])) / 4,
                        ((1 - u[0]) * (corner[3] - corner[0]) + (1 + u[0]) * (corner[2] - corner[1])) / 4};
    const double slope[2] = {t[0].dot(r), t[1].dot(r)};
    const bool held[2] = {std::abs(u[0]) >= 1 && slope[0] * u[0] > 0,
                          std::abs(u[1]) >= 1 && slope[1] * u[1] > 0};
    const double a = t[0].dot(t[0]), b = held[0] || held[1] ? 0 : t[0].dot(t[1]), c = t[1].dot(t[1]);
    const double det = a * c - b * b;
    double step[2] = {(c * slope[0] - b * slope[1]) / det, (a * slope[1] - b * slope[0]) / det};
    double moved = 0;
    for (int d = 0; d < 2; ++d) {
      const double next = held[d] ? u[d] : std::clamp(u[d] + step[d], -1.0, 1.0);
      moved = std::max(moved, std::abs(next - u[d]));
      u[d] = next;
    }
    if (moved < 1e-14) break;
  }
  return {shape_at(), offset().norm()};
}

} // namespace swarf
