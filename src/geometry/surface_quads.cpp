#include "src/geometry/surface_quads.hpp"
#include <Eigen/Geometry>
#include <algorithm>

namespace swarf {

namespace {

constexpr int side[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                            {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};

} // namespace

std::vector<std::array<int, 6>> find_face_neighbors(const HexSet& hexes) {
  struct Entry {
    std::array<int, 4> key; // sorted nodes
    int hex, side;
  };
  std::vector<Entry> entries;
  entries.reserve(6 * hexes.hex.size());
  for (int h = 0; h < int(hexes.hex.size()); ++h)
    for (int s = 0; s < 6; ++s) {
      Entry e{{}, h, s};
      for (int c = 0; c < 4; ++c) e.key[c] = hexes.hex[h][side[s][c]];
      std::sort(e.key.begin(), e.key.end());
      entries.push_back(e);
    }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
  std::vector<std::array<int, 6>> neighbors(hexes.hex.size(), {-1, -1, -1, -1, -1, -1});
  for (std::size_t e = 1; e < entries.size(); ++e) { // two hexes share every inner face
    const Entry &a = entries[e - 1], &b = entries[e];
    if (a.key == b.key) neighbors[a.hex][a.side] = b.hex, neighbors[b.hex][b.side] = a.hex;
  }
  return neighbors;
}

std::vector<SurfaceQuad> find_surface(const HexSet& hexes) {
  const auto neighbors = find_face_neighbors(hexes);
  std::vector<SurfaceQuad> surface;
  for (std::size_t h = 0; h < neighbors.size(); ++h)
    for (int s = 0; s < 6; ++s) {
      if (neighbors[h][s] >= 0) continue;
      SurfaceQuad quad{};
      for (int c = 0; c < 4; ++c) quad.node[c] = hexes.hex[h][side[s][c]];
      quad.hex = int(h);
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
