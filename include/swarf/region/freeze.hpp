// Points far from the active region are frozen: they keep their state and take no part in the step. They
// insulate against heat; diffuse_pressure sees them as they were frozen.
#pragma once
#include "swarf/core/tensor.hpp"

namespace swarf {

// The active region: points that the tool may touch soon, and points that move fast. With d the distance of a
// point from the nearest of them, and lengths in m:
//   d <= distance                     moves; over the last `ramp` of it velocities are damped, so that waves
//                                     which run outwards do not come back
//   distance < d <= distance + margin is held if it is within `reach` of what moves: its stress follows the
//                                     motion of its neighbours, so that the energy of the rest closes as if
//                                     it were a fixed face. Farther out than distance + reach that is only
//                                     what is tied, which a hex may move, and what is near to that
//   beyond                            frozen; up to `reach` further it is still a neighbour of what is held
struct Freeze {
  Real distance = 0, reach = 0; // a kernel's support
  Real margin = 0;              // reach, and the length of a hex
  Real ramp = 0;
  Real damping = 0; // 1/s at d = distance
  Real near = 0;    // from the tool: what is nearer is part of the active region; at most tool.reach
  Real speed = 0;   // m/s: what is as fast is part of the active region
  Real cell = 0;    // the active region is known to cells of this size; d is at most their diagonal too short
  Real mass_factor = 1;
};

// Bit of Particles::constraints and HexMesh::constraints: the point is held at velocity 0.
inline constexpr unsigned held_bit = 1u << 31;

// Bit of Particles::constraints: a row at a held face that moves with the face and the next row
// (held_rows.hpp).
inline constexpr unsigned follows_bit = 1u << 28;

// Values of HexMesh::active.
inline constexpr int hex_deleted = 0, hex_active = 1, hex_frozen = 2;

// Quadratic in the depth into the ramp: a wave meets no step in it.
SWARF_FN Real damping_at(const Freeze& s, Real d) {
  const Real depth = (d - (s.distance - s.ramp)) / s.ramp;
  return depth > 0 ? s.damping * depth * depth : Real(0);
}

} // namespace swarf
