#include "src/surface_quads.hpp"
#include <Eigen/Geometry>
#include <algorithm>

namespace swarf {

std::vector<SurfaceQuad> find_surface(const HexSet& hexes) {
  static constexpr int side[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                     {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  struct Entry {
    std::array<int, 4> key; // sorted nodes
    std::size_t place;      // 6 * hex + side
  };
  std::vector<Entry> entries;
  entries.reserve(6 * hexes.hex.size());
  for (std::size_t h = 0; h < hexes.hex.size(); ++h)
    for (std::size_t s = 0; s < 6; ++s) {
      Entry e{{}, 6 * h + s};
      for (int c = 0; c < 4; ++c) e.key[c] = hexes.hex[h][side[s][c]];
      std::sort(e.key.begin(), e.key.end());
      entries.push_back(e);
    }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
  std::vector<std::size_t> single; // two hexes share every inner face
  for (std::size_t e = 0; e < entries.size();) {
    const bool shared = e + 1 < entries.size() && entries[e + 1].key == entries[e].key;
    if (!shared) single.push_back(entries[e].place);
    e += shared ? 2 : 1;
  }
  std::sort(single.begin(), single.end());
  std::vector<SurfaceQuad> surface;
  for (std::size_t place : single) {
    SurfaceQuad quad{};
    for (int c = 0; c < 4; ++c) quad.node[c] = hexes.hex[place / 6][side[place % 6][c]];
    surface.push_back(quad);
  }
  return surface;
}

std::array<Point, 4> corners_of(const HexSet& hexes, const SurfaceQuad& quad) {
  return {hexes.node[quad.node[0]], hexes.node[quad.node[1]], hexes.node[quad.node[2]],
          hexes.node[quad.node[3]]};
}

Point area_of(const HexSet& hexes, const SurfaceQuad& quad) {
  const auto x = corners_of(hexes, quad);
  return 0.5 * (x[2] - x[0]).cross(x[3] - x[1]);
}

} // namespace swarf
