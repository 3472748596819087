// The parts of a scene, each made on the host from the filled bodies.
#pragma once
#include "src/scene/build_tie.hpp"
#include "src/scene/faces.hpp"
#include "src/scene/scene.hpp"

namespace swarf {

Material make_material(const MaterialDeck& deck);

bool uses(const Deck& deck, Method method); // whether the deck asks for it

// Zeros, if the deck asks for the field of this row of a table; else 0 rows.
template <class Field, auto... named>
void allocate(Field& field, const char* name, Facts<named...>, const Deck& deck, int rows) {
  field = Field(name, std::size_t(uses(deck, Facts<named...>::method) ? rows : 0));
}

// Every field of `rows` rows that the deck's methods use, zero; the counts are the caller's.
Particles allocate_particles(const Deck& deck, int rows);

// Rows: the particles of all bodies, then the tied points.
Particles make_particles(const Deck& deck, const std::vector<FilledBody>& bodies,
                         const std::vector<TiedPoint>& tied, const Faces& faces);

// All bodies of hexes. A hex's mass is its density times the volume of its straight-edged hex, an eighth of
// it goes to each node; periodic pairs share theirs equally. Throws DeckError for an inverted hex.
HexMesh make_hex_mesh(const Deck& deck, const std::vector<FilledBody>& bodies, const Faces& faces);

// The nodes on heated faces of hexes, with their share of each. A quad of the surface is of the face that all
// of its nodes are on.
HeatedNodes make_heated_nodes(const std::vector<FilledBody>& bodies, const Faces& faces);

// The surface of the hexes that a tool may touch: not where particles are tied, nor on periodic and symmetric
// planes. Rows of the scene's mesh.
struct FreeQuad {
  std::array<int, 4> node;
  int hex;
  double area; // m2
};
std::vector<FreeQuad> list_free_quads(const std::vector<FilledBody>& bodies);
// Which bodies may meet, and the sides of hexes where.
ContactGroups make_contact_groups(const Deck& deck, const std::vector<FilledBody>& bodies);
void share_masses(std::vector<double>& mass, const Faces& faces); // of periodic pairs of nodes

// Throws DeckError: a cell of one body lies in another body, by more than 5 % of a cell.
void check_overlap(const Deck& deck, const std::vector<FilledBody>& bodies);

// Throws DeckError: freezing begins where kernels of points at the active region still reach.
void check_freeze(const Deck& deck, const Scene& scene);

// Throws DeckError: particles or nodes are in contact with the tool, by more than the round-off of scenes
// that are placed to touch; their springs would give energy that nobody put in.
void check_tool_outside(const Deck& deck, const Scene& scene);

} // namespace swarf
