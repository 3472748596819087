#include "src/geometry/isoparametric.hpp"
#include <Eigen/Dense>
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

} // namespace swarf
