// Faces of bodies that are held, mirrored or repeated.
#pragma once
#include "src/geometry/filled_body.hpp"
#include "swarf/core/transform.hpp"
#include "swarf/material/face_heat.hpp"

namespace swarf {

struct Faces {
  std::vector<Constraint> constraints;
  std::vector<unsigned> particle_bits, node_bits; // bit b: row b of constraints
  std::vector<int> particle_host;                 // that a particle of a held row follows, or -1
  std::vector<HeatedFace> heated;
  std::vector<unsigned> heated_bits;                     // of particles: bit b: row b of heated
  std::vector<std::pair<int, std::string>> heated_hexes; // of each row of heated: body, and face of it
  std::vector<GhostPlane> planes;                        // of particles
  std::vector<Transform> transforms;                     // of nodes: from the master's place to the slave's
  std::vector<std::array<int, 3>> coupled_nodes;         // master, slave, transform
};

// fixed, velocity: all components of the nodes on the face, or of the first layer of particles.
// A row of particles that has another behind it follows the face and that (held_rows.hpp).
// symmetric: the normal component of the nodes; a mirror for particles.
// periodic: couples of nodes; a pair of planes for particles. Each direction of a body couples all nodes of
// its two faces by one transform of its own, so that a node where periodic faces meet is coupled once per
// direction. Bodies with equal planes share them. A plane holds for all particles of the scene. Throws
// DeckError: too many faces, faces that do not match, a slice thinner than `cutoff`, particles behind a
// plane.
Faces collect_faces(const Deck& deck, const std::vector<FilledBody>& bodies, double cutoff);

} // namespace swarf
