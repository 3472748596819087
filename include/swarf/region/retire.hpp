// Spent chip: particles that are farther than `distance` from where they began, from all that the tool comes
// near to, and from the work, which is all that has moved less. They leave for good: no forces, in no list,
// never to thaw. They keep their state and fly on in a straight line, so that their mass, momentum and energy
// stay in the sums. Speed would not tell chip from work: waves move the work as fast.
#pragma once
#include "swarf/core/tensor.hpp"

namespace swarf {

// Bits of Particles::constraints: the particle has retired; it has met the tool or the work since.
inline constexpr unsigned retired_bit = 1u << 30, met_bit = 1u << 29;

struct Retire {
  Real distance = 0;
  Real reach = 0;             // one that has retired and comes as near as this to the work meets it
  Real elapsed = 0;           // s, since the retired were moved last
  VectorField first_position; // of each identity
};

} // namespace swarf
