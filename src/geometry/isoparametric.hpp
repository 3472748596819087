// Where a point lies in a trilinear hex.
#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>

namespace swarf {

// Shape functions N_a of the hex at the point, VTK order; nothing if it lies outside by more than round-off.
std::optional<std::array<double, 8>> locate_in_hex(const std::array<Eigen::Vector3d, 8>& corner,
                                                   const Eigen::Vector3d& x);

} // namespace swarf
