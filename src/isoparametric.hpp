// Where a point lies in a trilinear hex or on a bilinear quad.
#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>

namespace swarf {

// Shape functions N_a of the hex at the point, VTK order; nothing if it lies outside by more than round-off.
std::optional<std::array<double, 8>> locate_in_hex(const std::array<Eigen::Vector3d, 8>& corner,
                                                   const Eigen::Vector3d& x);

struct NearestOnQuad {
  std::array<double, 4> shape; // of the nearest point of the quad
  double distance = 0;         // m
};
NearestOnQuad nearest_on_quad(const std::array<Eigen::Vector3d, 4>& corner, const Eigen::Vector3d& x);

} // namespace swarf
