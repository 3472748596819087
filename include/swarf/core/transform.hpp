// Rigid maps of periodic and mirror planes, and the velocity constraints of faces.
#pragma once
#include "swarf/region/freeze.hpp"

namespace swarf {

// x' = R x + t; vectors map by R, tensors by R A R^T. R may be a reflection.
struct Transform {
  Tensor3 R;
  Vector3 t;
};
SWARF_FN Vector3 apply(const Transform& map, const Vector3& x) { return multiply(map.R, x) + map.t; }
SWARF_FN Transform inverse(const Transform& map) {
  const Tensor3 back = transpose(map.R);
  return {back, Real(-1) * multiply(back, map.t)};
}
SWARF_FN Transform compose(const Transform& last, const Transform& first) { // x' = last(first(x))
  return {multiply(last.R, first.R), apply(last, first.t)};
}
using TransformTable = View<Transform*>;

// Half space n.x - offset >= 0 in which the body lies; a particle closer than the cutoff has a ghost.
// Planes 2k and 2k + 1 are the two sides of one periodic pair, or two mirrors of opposite faces; a plane
// makes ghosts of particles, of tied particles and of the ghosts that planes of earlier pairs made.
inline constexpr int max_ghost_planes = 8;
struct GhostPlane {
  Vector3 normal;
  Real offset;
  Transform to_ghost;
  bool periodic; // a particle that leaves through the plane comes back through its partner
  bool active;   // false: the missing partner of a single mirror
};
// A face that holds its nodes or particles.
struct Constraint {
  bool all = true; // all components, or only the one along `normal`
  Vector3 normal{1, 0, 0};
  Vector3 velocity{0, 0, 0};
};
using ConstraintTable = View<Constraint*>;

// Applies the constraints of `bits` to v. Faces that meet are taken in the order of their bits.
SWARF_FN Vector3 constrain(Vector3 v, unsigned bits, const ConstraintTable& table) {
  if (bits & held_bit) return {0, 0, 0};
  if (bits & follows_bit) return v; // hold_faces comes after
  for (int b = 0; bits != 0; ++b, bits >>= 1) {
    if (!(bits & 1u)) continue;
    const Constraint& c = table(b);
    if (c.all) return c.velocity;
    v = v - dot(v - c.velocity, c.normal) * c.normal;
  }
  return v;
}

} // namespace swarf
