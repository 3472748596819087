// The exterior faces of a body of hexes.
#pragma once
#include "src/geometry/filled_body.hpp"

namespace swarf {

// The hexes at the six faces of each hex, -1 outside. Faces: low and high first, second and third direction.
std::vector<std::array<int, 6>> find_face_neighbors(const HexSet& hexes);

struct SurfaceQuad {
  std::array<int, 4> node; // of the body's HexSet, counter-clockwise from outside
  int hex = 0;             // of the HexSet
};
std::vector<SurfaceQuad> find_surface(const HexSet& hexes);

std::array<Point, 4> corners_of(const HexSet& hexes, const SurfaceQuad& quad);
// Outward, as long as the quad's area.
Point area_of(const HexSet& hexes, const SurfaceQuad& quad);

} // namespace swarf
