// The patches of the tool's surface, made once from its facets.
#pragma once
#include "src/tool/geometry.hpp"
#include <Eigen/Geometry>
#include <functional>

namespace swarf {

struct PatchPlan {
  double finest = 0; // m, spacing of what the tool touches
  std::function<double(const Eigen::Vector3d&)>
      distance_to_work; // of a point of the tool, the least over the run, m
};

// Longest edges are at most twice the spacing, or a quarter of the distance from the work. Sums are zero.
ToolSurface build_tool_surface(const FacetSurface& surface, const PatchPlan& plan);

} // namespace swarf
