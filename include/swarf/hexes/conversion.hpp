// Hexes that turn into particles while the scene runs: when.
#pragma once
#include "swarf/tool/tool.hpp"

namespace swarf {

// Per hex, 0: never. A hex converts for good.
struct ConversionLimits {
  ScalarField distance; // m, of its centre from the tool's surface: nearer
  ScalarField strain;   // equivalent plastic strain: at least this
  Tool tool;            // whose distances are exact as far as `distance` reaches; 0 facets: no tool
};

} // namespace swarf
