// Rows of particles at held and driven faces.
#pragma once
#include "swarf/core/tensor.hpp"

namespace swarf {

// A face has the prescribed velocity v_f; the outermost particles lie half a spacing inside, the next a whole
// one further. The velocity between is linear: v = v_f + held_share (v_host - v_f), so that a body of n
// layers is strained over n spacings, not over n - 1. What the row's particles feel passes by the same lever:
// a part to the hosts, the rest to the face, whose work it is. Where held faces meet, and in bodies of fewer
// than three layers, the row itself is held, as it is on faces without a host (rings of a cylinder, spheres).
inline constexpr Real held_share = Real(1) / Real(3);

// A host that flows goes elsewhere, and is shifted: from this plastic strain on the row takes the face's
// velocity.
inline constexpr Real follows_until = Real(0.02);

struct HeldRows {
  int groups = 0;         // of the particles that follow one host
  IndexField host, start; // identity of the host; its particles are start(g) .. start(g + 1) - 1
  IndexField held, face;  // identity; row of the ConstraintTable
  IndexField row;         // of the particle of each identity
};

} // namespace swarf
