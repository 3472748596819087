// Turns hexes of a running scene into particles.
#pragma once
#include "src/scene/scene.hpp"

namespace swarf {

// Hexes `chosen`, rows of the mesh, become particles, and the tied particles around them are set anew. Mass,
// linear momentum, heat, internal and plastic work, plastic strain and the integral of the stress over the
// volume are kept to round-off. Each particle takes its share of its hex and moves as the hex's shape
// functions say, so the kinetic energy falls by that of motion between the particles. Lists and ghosts are
// the caller's to make anew.
void convert_hexes(const Deck& deck, Scene& scene, const std::vector<int>& chosen);

// The same scene from a checkpoint: hexes.active has been read, the particles' fields get their rows.
struct ParticleCounts {
  int free, tied;
};
bool restore_conversion(const Deck& deck, Scene& scene, const ParticleCounts& counts);

} // namespace swarf
