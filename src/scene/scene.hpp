// Builds the model from the deck: the only place, with output, where array elements are touched on the host.
#pragma once
#include "src/deck/deck.hpp"
#include "swarf/core/cell_order.hpp"
#include "swarf/core/transform.hpp"
#include "swarf/hexes/body_contact.hpp"
#include "swarf/hexes/hex_mesh.hpp"
#include "swarf/hexes/tie.hpp"
#include "swarf/material/face_heat.hpp"
#include "swarf/particles/held_rows.hpp"
#include "swarf/particles/particles.hpp"
#include "swarf/tool/tool.hpp"
#include <memory>

namespace swarf {

struct HexConversion;
struct ConversionLayout;

// Everything that the step works on. Particles are allocated for count + tied rows; ghosts come later.
struct Scene {
  MaterialTable materials; // rows in the order of deck.materials
  Particles particles;     // particles.body: row of deck.bodies
  HexMesh hexes;           // all bodies of hexes in one mesh
  IndexField hex_body;     // row of deck.bodies
  Tie tie;
  ContactGroups contact_groups;         // count 0: no two bodies can meet
  std::vector<GhostPlane> ghost_planes; // host; even count, at most max_ghost_planes
  TransformTable node_transforms;       // of hexes.coupled_nodes
  ConstraintTable constraints;
  HeldRows held_rows;
  HeatedFaces heated_faces;
  HeatedNodes heated_nodes;
  std::vector<std::array<Triple, 3>> tool_facets; // in the tool's frame; empty without a tool
  int collapsed_facets = 0;                       // of the tool's file, left out
  std::vector<std::string> body_files; // what each body's file holds, with a checksum; "": it has none
  Tool tool;
  double patch_spacing = 0; // m, that its surface's patches are made for, and
  double patch_end = 0;     // s, until when it was asked where the work comes
  double heat_reach = 0;    // m, how far into the tool heat is followed; 0: it does not conduct
  double spacing = 0;       // of the finest particles, m; 0 without particles
  CellGrid lattice;         // of the finest particles: about one in each cell
  double cutoff = 0;        // largest support 2 h + skin, m
  double hex_diagonal = 0;  // of the largest hex, m; 0 without hexes
  double skin = 0;
  std::shared_ptr<const HexConversion> conversion; // null: no hex becomes particles
  std::shared_ptr<const ConversionLayout> layout;  // null: none has yet
};

// Rows of the particles, active and frozen, without the tied ones.
std::vector<int> particle_rows(const Particles& particles);

// The patches of the tool's surface for work that comes until `end`: a restart may end later than the run
// that it goes on with, and needs those of that run.
void make_patches(const Deck& deck, Scene& scene, double end);

// Throws DeckError: zero particles, bodies that overlap, a tool inside the workpiece at the start, a periodic
// slice thinner than the support, a tie that touches no hex, ...
Scene build_scene(const Deck& deck);

} // namespace swarf
