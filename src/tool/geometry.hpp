// The surface of the tool, its motion, and the device structure made from it. Lengths in m, tool's frame.
#pragma once
#include "src/geometry/facet_surface.hpp"
#include "swarf/tool/tool.hpp"

namespace swarf {

// Right-hand cutter that turns clockwise seen from +z, flat end face at z = 0, shank end at z = length.
// In the section z = 0, tooth k's edge has its outermost point at diameter / 2, k * 360 / flutes
// counter-clockwise from +y; it turns counter-clockwise by tan(helix) z / R with z. Positive rake leans the
// rake face back, away from the motion. Behind the straight clearance face the back falls to the core. The
// whole section is offset by `runout`, runout_angle clockwise from +y (0: tooth 0 cuts more).
FacetSurface make_end_mill(const ToolDeck& tool);

// Cuts along +x, the finished surface below it at y = 0: the lowest point of the rounded edge is the origin.
// Rake face towards +x, leaned back by positive rake, up to y = height; clearance face of the same length.
// Extruded along z over `width`, centred, then turned by `inclination` about +y.
FacetSurface make_wedge(const ToolDeck& tool);

// Square plate: front face, with outward `normal`, centred on the origin; a quarter of its size thick.
FacetSurface make_wall(const ToolDeck& tool);

// Any of the above by tool.kind, checked; a relative STL file is looked for in `folder`, the deck's.
FacetSurface make_tool_surface(const ToolDeck& tool, const std::string& folder);

// The device structure; distances are exact within `reach` (m) of the surface, at least the largest gap plus
// the deepest penetration that the run may see. A few bytes per cell of size `reach`, coarser for large
// tools.
Tool build_tool(const FacetSurface& surface, const ToolDeck& deck, double reach);

// Velocity plus feed; angle = -(start_angle + spindle_speed t), within one turn so that float keeps it.
ToolPose tool_pose(const ToolDeck& tool, double time);
// Angle of tooth 0 at z = 0, deg, clockwise from +y; counts whole turns.
double immersion(const ToolDeck& tool, double time);

// --- parts shared by the generators
using Section = std::vector<std::array<double, 2>>; // counter-clockwise, no two successive sides in line

struct Layer {
  double z, angle; // the section turned counter-clockwise by angle, rad
};
// The section through all layers, z increasing, closed at both ends. Throws DeckError if it crosses itself.
FacetSurface loft(const Section& section, const std::vector<Layer>& layers);
std::vector<std::array<int, 3>> triangulate(const Section& section);

// Points of the arc about `centre` between the angles of two outward normals, with one at `middle` exactly.
// At most 5 degrees apart and at least 12 steps in all; a single point if the radius is 0.
Section round_edge(std::array<double, 2> centre, double radius, double from, double middle, double to);

} // namespace swarf
