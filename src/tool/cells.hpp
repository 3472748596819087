// The tool's cells of heat, made once from its surface.
#pragma once
#include "src/geometry/filled_body.hpp"
#include "src/tool/octree.hpp"

namespace swarf {

// What the deck asks of them. finest: m, spacing of what the tool touches.
HeatPlan plan_tool_heat(const Deck& deck, const std::vector<Shape>& shapes, double finest);

// Cells in the tool whose surface is given, at the start temperature of the deck's tool.
ToolHeat build_tool_heat(const Tool& tool, const FacetSurface& surface, const ToolDeck& deck,
                         const HeatPlan& plan);

} // namespace swarf
