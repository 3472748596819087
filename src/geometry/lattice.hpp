// The particles and hexes that fill a shape.
#pragma once
#include "src/geometry/shape.hpp"
#include <map>

namespace swarf {

// Members of a named face: particles of the first layer, or nodes on the face. Opposite faces list theirs in
// the same order.
using FaceMembers = std::map<std::string, std::vector<int>>;

// One particle in the centre of each cell.
// block: cubic. ring: polar, every cell's volume exact. cylinder: concentric rings of cells as wide as high,
// about 2 pi r / dr to a ring, so that the surface is round and the mass exact. sphere: cubic cells whose
// centres lie in the shell, their volume scaled by at most some per cent for the exact mass. stl: the same,
// of cells that fit its box. mesh: as its file has them.
struct PointSet {
  std::vector<Point> position; // m
  std::vector<double> volume;  // m3
  std::vector<double> gap;     // m, from the particle to its own surface
  FaceMembers faces;
  FaceMembers behind; // of those members, in the same order: the next inwards; -1: there is none
  double spacing = 0; // m, cube root of the mean volume
};
PointSet fill_points(const Shape& shape);

// The cells of the same lattice around the shape, `layers` deep, outside it. No faces, no gaps.
PointSet continue_points(const Shape& shape, int layers);

struct HexSet {
  std::vector<Point> node;             // m
  std::vector<std::array<int, 8>> hex; // VTK order
  FaceMembers faces;
};
// block, ring: the lattice's cells. cylinder: a square core in the middle of four mapped blocks, extruded.
// sphere: six mapped blocks (cubed sphere), equal angles. stl: the cells whose centres lie inside. mesh: as
// its file has them.
HexSet fill_hexes(const Shape& shape);

// Of an stl. Throws DeckError: no cell, other pieces than the surface has, a held side without a cell.
PointSet fill_points_of_stl(const Shape& shape);
HexSet fill_hexes_of_stl(const Shape& shape);

// Of a mesh. Throw DeckError: a face that is no set of the file; a tied one that is no lattice.
PointSet fill_points_of_mesh(const Shape& shape);
HexSet fill_hexes_of_mesh(const Shape& shape);
PointSet continue_points_of_mesh(const Shape& shape, int layers);

} // namespace swarf
