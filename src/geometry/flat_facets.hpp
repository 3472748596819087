// Facets without area, and what of a file is its surface.
#pragma once
#include "src/geometry/facet_surface.hpp"

namespace swarf {

// Flatter than a direction in the single precision of STL files needs.
bool is_flat(const FacetSurface& surface, const std::array<int, 3>& facet);

// Each flat facet and its neighbour across the longest side exchange their diagonal: the same surface without
// the flat one. What has no such neighbour stays. Counts them as collapsed ones.
void take_out_flat_facets(FacetSurface& surface);

// The bytes of the file that are its surface: without what follows the last facet of a binary one.
std::string read_stl_bytes(const std::string& file);

} // namespace swarf
