// Closed surfaces of facets: of tools, and of bodies that are filled from one. Lengths in m.
#pragma once
#include "src/deck/deck.hpp"

namespace swarf {

// A closed surface; corners of a facet are counter-clockwise seen from outside.
struct FacetSurface {
  std::vector<Triple> vertices;
  std::vector<std::array<int, 3>> facets;
  int collapsed = 0; // facets of a file that were left out, for two of their corners were one
};

// Binary or ASCII, as programs write them; equal corners are merged, stored normals are not read. Throws
// DeckError.
FacetSurface read_stl(const std::string& file, double metres_per_unit);

// Binary, in metres, facets in order: equal surfaces give equal files. Throws ResultsError.
void write_stl(const FacetSurface& surface, const std::string& file);

// Refuses open edges, facets turned against their neighbours, facets without area and parts turned inside
// out. Throws DeckError that begins with `name` and names the facet (from 1, as in the file), its corners and
// the cure. Does not look for parts that cut through each other.
void check_surface(const FacetSurface& surface, const std::string& name);

// Refuses parts that cut through or hold each other, and a part that cuts through itself. As check_surface.
void check_parts(const FacetSurface& surface, const std::string& name);

// Of a facet, its edges 01, 12, 20 and its corners 0, 1, 2: the normals that tell inside from outside there.
using Pseudonormals = std::vector<std::array<Triple, 7>>; // order of Tool::pseudonormal
Pseudonormals find_pseudonormals(const FacetSurface& surface);

} // namespace swarf
