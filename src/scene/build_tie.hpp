// Places the tied particles of a scene and finds what they follow and where their forces go.
#pragma once
#include "src/geometry/surface_quads.hpp"
#include "swarf/hexes/hex_mesh.hpp"
#include "swarf/hexes/tie.hpp"

namespace swarf {

// See tie.hpp. Nodes and hexes by their rows in the scene's mesh.
struct TiedPoint {
  Point position{0, 0, 0}; // m
  double volume = 0;       // m3, the weighted part of its cell
  int body = 0;            // index of the FilledBody whose lattice it continues
  int host = 0;
  std::array<double, 8> shape{};
};

// Cells that continue the lattice of body `row` to `reach` (m) around it, where they lie in hexes of the body
// that it is tied to and outside every body of particles; sorted along a Z-order curve. Throws DeckError if
// there is none, or no face of the hexes touches the particles.
std::vector<TiedPoint> place_tied_points(const Deck& deck, const std::vector<FilledBody>& bodies, int row,
                                         double reach);

// Whether a body of particles covers this face of hexes: then it takes forces of tied particles, and no tool
// touches it.
bool touches_particles(const HexSet& hexes, const SurfaceQuad& quad, const FilledBody& particles);

Tie make_tie(const std::vector<TiedPoint>& points, const HexMesh& mesh);

// Per hex of the scene: the share of its volume that carries its own stress; tied particles carry the rest.
std::vector<double> stress_shares(const std::vector<FilledBody>& bodies, double reach);

} // namespace swarf
