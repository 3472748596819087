// What is shown of each patch of the tool's surface (tool_surface.hpp), of what was gathered in `duration`
// and spread over the faces of the points: patches at an edge are smaller than these. A tool that does not
// conduct has no temperature: 0. Once per frame. Reads sums, area, corner, the tool's temperature.
#include "swarf/kernels.hpp"

namespace swarf {
namespace {

SWARF_FN Vector3 corner_of(const ToolSurface& s, int patch, int k) {
  return {s.corner(patch, k, 0), s.corner(patch, k, 1), s.corner(patch, k, 2)};
}

// Of the cell a thousandth of a cell below the middle of the patch, as tool_contact.cpp takes it.
SWARF_FN Real temperature_below(const Tool& tool, int patch) {
  const Vector3 a = corner_of(tool.surface, patch, 0), b = corner_of(tool.surface, patch, 1),
                c = corner_of(tool.surface, patch, 2);
  const Vector3 n = cross(b - a, c - a);
  const Vector3 middle = Real(1.0 / 3) * (a + b + c);
  const Real depth = Real(1e-3) * tool.heat.finest / norm(n);
  return tool.heat.temperature(find_tool_cell(tool.heat, middle - depth * n));
}

} // namespace

View<Real* [shown_on_tool]> show_tool_surface(const Tool& tool, Real duration) {
  const ToolSurface& s = tool.surface;
  const View<Real* [shown_on_tool]> shown("show_tool_surface", s.patches);
  const bool conducts = tool.heat.cells > 0;
  Kokkos::parallel_for(
      "show_tool_surface", Range(0, s.patches), KOKKOS_LAMBDA(const int p) {
        const Real impulse = spread_sum(s, p, sum_impulse), share = s.area(p) * duration;
        if (duration > Real(0)) {
          shown(p, shown_pressure) = impulse / share;
          shown(p, shown_friction) = spread_sum(s, p, sum_friction) / share;
        }
        if (impulse > Real(0)) shown(p, shown_speed) = spread_sum(s, p, sum_slide) / impulse;
        if (conducts)
          shown(p, shown_temperature) =
              impulse > Real(0) ? spread_sum(s, p, sum_temperature) / impulse : temperature_below(tool, p);
        shown(p, shown_wear) = s.wear_A * spread_sum(s, p, sum_wear) / s.area(p);
      });
  return shown;
}

} // namespace swarf
