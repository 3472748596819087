// Temperatures of the tool's cells, handed from one run to the next in tool_heat.h5.
#pragma once
#include "src/files/results.hpp"
#include "swarf/tool/tool_heat.hpp"

namespace swarf {

// tool: what two runs must have in common for the temperatures to mean the same.
void write_tool_heat(const std::filesystem::path& file, const std::string& tool, const ToolHeat& heat);

// Throws ResultsError where there is no such file, or it is of another tool or of other cells.
void read_tool_heat(const std::filesystem::path& file, const std::string& tool, const ToolHeat& heat);

} // namespace swarf
