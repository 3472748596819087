// Hexes that become particles while the scene runs: the mesh as it was built, and which part of it is hexes,
// tied particles and particles once given hexes have converted.
#pragma once
#include "src/scene/parts.hpp"
#include "swarf/hexes/conversion.hpp"

namespace swarf {

// The scene's hexes at its start; nothing here changes. A converting hex is divided into n x n x n cells, one
// particle in each.
struct HexConversion {
  struct Lattice {
    int n = 0;          // particles along an edge; 0: the body does not convert
    double spacing = 0; // m
    int material = 0;
  };
  std::vector<Lattice> lattice;        // of deck.bodies
  std::vector<int> body;               // per hex, row of deck.bodies
  std::vector<double> mass;            // per hex, kg
  std::vector<double> gap;             // per hex, m: from its particles to their own surface
  std::vector<std::array<int, 8>> hex; // nodes
  std::vector<Point> node;             // m
  std::vector<FreeQuad> quads;         // the surface that a tool may touch
  Faces faces;                         // those of the scene
  std::vector<int> one_of_pair;        // per node, the same for all nodes of a periodic set
  std::vector<int> hex_start, hex_at;  // hexes at a node of a set: hex_at[hex_start[a] .. hex_start[a+1])
  double reach = 0;                    // m, as far as tied particles lie in the hexes
  ConversionLimits limits;
  double travel = 0; // m, of the tool, between two looks

  int count() const;         // hexes of bodies that convert
  int cells_of(int e) const; // particles that hex e becomes; 0: never
  // Shape functions of the centre of cell c in hexes of n x n x n cells.
  static std::array<double, 8> shape(int n, int c);
  Point place(int e, int c) const; // of a particle at the start
};

// Null if no body of the deck converts.
std::shared_ptr<const HexConversion> make_conversion(const Deck& deck, const std::vector<FilledBody>& bodies,
                                                     const Faces& faces, const HexMesh& mesh, double reach);

// The same, after hexes have converted: a function of which ones, not of their order.
struct ConversionLayout {
  struct Cell {
    int hex, cell;
    double weight; // of the particle: its mass over that of its cell; 1: free
  };
  int converted() const;            // hexes
  std::vector<Cell> free, tied;     // free: of the converted hexes, in order; tied: along a curve
  std::vector<double> share;        // per hex, of the stress that it carries itself
  std::vector<double> node_mass;    // kg
  std::vector<double> contact_area; // per node, m2
};
ConversionLayout lay_out(const HexConversion& of, const std::vector<bool>& converted);

} // namespace swarf
