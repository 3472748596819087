// Load of the workpiece on the tool, summed over steps.
#pragma once
#include "swarf/tool/tool.hpp"

namespace swarf {

// On the tool: forces N; moment about the pose's position, N m (z: about the axis). Sums over steps: divide
// by their number for means. Only `work` is an integral in time.
struct ToolLoad {
  Vector3 force{0, 0, 0}, moment{0, 0, 0};
  Vector3 tooth_force[max_tool_teeth]{};
  Real power = 0;    // of the tool on the workpiece, W
  Real contacts = 0; // points that touch
  Real work = 0;     // J, of the tool on the workpiece

  KOKKOS_INLINE_FUNCTION void add(const ToolLoad& other) {
    force = force + other.force, moment = moment + other.moment;
    for (int k = 0; k < max_tool_teeth; ++k) tooth_force[k] = tooth_force[k] + other.tooth_force[k];
    power += other.power, contacts += other.contacts, work += other.work;
  }
};

// The running sums, and one row for each block of points: made once, for the largest set of points.
struct ToolLoadSums {
  static constexpr int block = 1024; // rows; part of the result, since it orders the sum
  View<ToolLoad> total;
  View<ToolLoad*> blocks;
};
inline ToolLoadSums make_tool_load_sums(int most_points) {
  return {View<ToolLoad>("tool_load"),
          View<ToolLoad*>("tool_load_blocks", most_points / ToolLoadSums::block + 1)};
}

} // namespace swarf
