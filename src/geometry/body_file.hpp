// What the file of a body holds, in the scene's place: read once, however often it is asked for.
#pragma once
#include "src/geometry/closed_surface.hpp"
#include "src/geometry/lattice.hpp"

namespace swarf {

struct BodyFile {
  std::shared_ptr<const ClosedSurface> surface; // of an stl, or the outer sides of hexes
  std::shared_ptr<const FacetTree> cubes;       // about the particles of a mesh, of their volume
  PointSet points;                              // of a mesh of particles
  HexSet hexes;                                 // of a mesh of hexes
  double volume = 0;                            // m3
  Eigen::AlignedBox3d box;
  std::string contents; // its count of facets, hexes or particles, with a checksum of all of them

  double signed_distance(const Point& x) const; // as that of a Shape
};

// Throws DeckError for a file that cannot be read or used.
std::shared_ptr<const BodyFile> read_body_file(const Deck& deck, const BodyDeck& body);

// The hexes or particles of a mesh; `name` begins the messages.
BodyFile read_mesh(const BodyDeck& body, const std::string& name);
PointSet read_mesh_points(const BodyDeck& body, const std::string& name);

} // namespace swarf
