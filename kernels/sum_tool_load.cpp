// Load on the tool: F = -sum f_i, M = -sum (x_i - X) x f_i, power = sum f_i . v_tool(x_i), added to
// the running sums. Blocks of fixed size, then the blocks in order: the sum does not depend on the number of
// threads. Reads contact_force, position, area; writes sums.
#include "swarf/kernels.hpp"

namespace swarf {
namespace {

SWARF_FN void add_point(ToolLoad& load, const Tool& tool, const ToolPose& pose, const ToolFrame& frame,
                        const Vector3& x, const Vector3& f) {
  const Vector3 on_tool = Real(-1) * f;
  load.force = load.force + on_tool;
  load.moment = load.moment + cross(x - pose.position, on_tool);
  const int tooth = tooth_of(tool, to_tool(frame, x));
  load.tooth_force[tooth] = load.tooth_force[tooth] + on_tool;
  load.power += dot(f, surface_velocity(pose, x));
  load.contacts += Real(1);
}

} // namespace

void sum_tool_load(const ContactPoints& points, const Tool& tool, const ToolPose& pose, Real dt,
                   const ToolLoadSums& sums) {
  const ToolFrame frame = make_frame(pose);
  const int blocks = (points.count + ToolLoadSums::block - 1) / ToolLoadSums::block;
  Kokkos::parallel_for(
      "sum_tool_load", Range(0, blocks), KOKKOS_LAMBDA(const int b) {
        ToolLoad load;
        const int begin = b * ToolLoadSums::block;
        const int end = Kokkos::min(begin + ToolLoadSums::block, points.count);
        for (int i = begin; i < end; ++i) {
          if (points.area(i) == 0) continue;
          const Vector3 f = load_vector(points.contact_force, i);
          if (f.x == 0 && f.y == 0 && f.z == 0) continue;
          add_point(load, tool, pose, frame, load_vector(points.position, i), f);
        }
        sums.blocks(b) = load;
      });
  Kokkos::parallel_for(
      "sum_tool_load", Range(0, 1), KOKKOS_LAMBDA(const int) {
        ToolLoad load;
        for (int b = 0; b < blocks; ++b) load.add(sums.blocks(b));
        load.work = load.power * dt;
        sums.total().add(load);
      });
}

} // namespace swarf
