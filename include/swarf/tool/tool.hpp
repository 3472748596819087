// The rigid tool: a closed surface of facets, its motion, and what a query needs on the device.
#pragma once
#include "swarf/tool/tool_heat.hpp"
#include "swarf/tool/tool_surface.hpp"

namespace swarf {

inline constexpr int max_tool_teeth = 8;

// Rigid motion at one instant: translation, and rotation about the tool's own z axis.
struct ToolPose {
  Vector3 position{0, 0, 0}; // of the tool's origin
  Real angle = 0;            // rad, counter-clockwise seen from +z
  Vector3 velocity{0, 0, 0};
  Real angular_velocity = 0; // rad/s about +z
};

// The rotation of a pose, its sine and cosine computed once for all points.
struct ToolFrame {
  Vector3 position;
  Real cosine, sine;
};
inline ToolFrame make_frame(const ToolPose& pose) {
  return {pose.position, Kokkos::cos(pose.angle), Kokkos::sin(pose.angle)};
}
SWARF_FN Vector3 to_tool(const ToolFrame& frame, const Vector3& x) {
  const Vector3 r = x - frame.position;
  return {frame.cosine * r.x + frame.sine * r.y, frame.cosine * r.y - frame.sine * r.x, r.z};
}
SWARF_FN Vector3 direction_to_world(const ToolFrame& frame, const Vector3& n) {
  return {frame.cosine * n.x - frame.sine * n.y, frame.sine * n.x + frame.cosine * n.y, n.z};
}

// Velocity of the tool's material at x, as one vector: V + omega e_z x (x - X).
SWARF_FN Vector3 surface_velocity(const ToolPose& pose, const Vector3& x) {
  const Real omega = pose.angular_velocity;
  return {pose.velocity.x - omega * (x.y - pose.position.y),
          pose.velocity.y + omega * (x.x - pose.position.x), pose.velocity.z};
}

// Facets in the tool's frame, outward normals; a uniform grid lists for each cell the facets that can be
// nearest to a point of the cell. Exact: in every cell that comes within `reach` of the surface no such facet
// is left out. Other cells are empty, or hold the single entry deep_inside.
struct Tool {
  static constexpr int deep_inside = -1;

  int facets = 0;
  View<Real* [3][3]> vertex;       // corners of a facet, counter-clockwise from outside
  View<Real* [7][3]> pseudonormal; // unit: face; edges 01, 12, 20; corners 0, 1, 2 (Baerentzen & Aanaes 2005)
  Vector3 grid_origin{0, 0, 0};
  Real cell_size = 0; // m
  int cells[3] = {0, 0, 0};
  IndexField cell_start, cell_facet; // CSR; cell (i,j,k) at i + cells[0] * (j + cells[1] * k)
  ScalarField facet_distance;        // m, of each listed facet from the cell's centre; rising within a cell
  ScalarField cell_distance;         // m, signed, of the cell's centre; of a cell without facets -+ infinite
  Real reach = 0;                    // m
  int teeth = 1;                     // tooth 0 at +y, the others counter-clockwise from it
  Real twist = 0;                    // rad/m, by which the edges turn counter-clockwise along +z
  ToolHeat heat;                     // without cells where the tool does not conduct
  ToolSurface surface;               // what the contact does to it
};

// The tooth whose edge is nearest in angle to a point in the tool's frame.
SWARF_FN int tooth_of(const Tool& tool, const Vector3& x) {
  if (tool.teeth <= 1) return 0;
  const Real turn = Real(2) * Kokkos::numbers::pi_v<Real>;
  const Real angle = Kokkos::atan2(-x.x, x.y) - tool.twist * x.z; // 0 on tooth 0
  const int tooth = int(Kokkos::floor(Real(tool.teeth) * angle / turn + Real(0.5))) % tool.teeth;
  return tooth < 0 ? tooth + tool.teeth : tooth;
}

} // namespace swarf
