// The tool's cells of heat, made once from its surface.
#pragma once
#include "src/geometry/filled_body.hpp"
#include "src/tool/octree.hpp"

namespace swarf {

// How near the bodies, as they are at the start and go without the tool, come to a point of the tool until
// `end`, m. finest: m, spacing of what the tool touches.
std::function<double(const Point&)> find_distance_to_work(const Deck& deck, const std::vector<Shape>& shapes,
                                                          double finest, double end);

// What the deck asks of the cells.
HeatPlan plan_tool_heat(const Deck& deck, const std::vector<Shape>& shapes, double finest);

// Cells in the tool whose surface is given, at the start temperature of the deck's tool.
ToolHeat build_tool_heat(const Tool& tool, const FacetSurface& surface, const ToolDeck& deck,
                         const HeatPlan& plan);

// Conduction for `time` with nothing touching the tool, in equal steps of no more than `stable_step`, s.
void idle_tool(const ToolHeat& heat, double time, double stable_step);

} // namespace swarf
