// Particle shifting: by how much a particle moves towards an even order. Lengths in m.
//   d = -D h^2 sum_j V_j [1 + b (W_ij / W(spacing))^4] grad W_ij
// down the gradient of the particles' concentration (Lind, Xu, Stansby & Rogers 2012, J. Comput. Phys. 231);
// the bracket keeps particles from pairing (Monaghan 2000). What no plastic strain has brought out of order
// does not move: all in all a particle goes no farther than it has flowed.
#pragma once
#include "swarf/material/material.hpp"

namespace swarf {

// Chosen on the orthogonal cut at 6.67 um, by the order of its particles, and kept at all other spacings.
inline constexpr Real shift_coefficient = Real(0.3); // D
inline constexpr Real shift_pairing = Real(0.2);     // b
inline constexpr Real shift_per_strain = 2; // spacings per plastic strain: rows that shear pass by one
inline constexpr Real largest_shift =
    Real(0.05);                                // spacings at once: neighbours tell what the fields are there
inline constexpr Real value_reach = Real(1.3); // h: those neighbours
inline constexpr Real surface_openness =
    Real(0.72); // n.A n in the outer row of a lattice is 0.5, in the next 0.94
inline constexpr Real surface_gradient = Real(0.29); // of the concentration, over 1/spacing: three fifths of
                                                     // that in the outer row; a row with less has come off
inline constexpr Real surface_seen = Real(0.03);     // |sum V W n| from which on a surface is near

// Sums over the neighbours of one particle.
struct ShiftSums {
  Vector3 gradient; // sum V_j grad W, 1/m
  Vector3 pairing;  // sum V_j (W / W(spacing))^4 grad W, 1/m
  Symmetric3 A;     // sum V_j (x_j - x_i) (x) grad W: 1 where there are neighbours all around
  Vector3 surface;  // V_i sum W n_j of the neighbours that are at a surface
};

struct ShiftPoint {
  Real h, spacing;
  Real allowed;    // m, that the particle may still go
  Vector3 pressed; // N, normal force of the tool; zero where it does not touch
};

struct Shift {
  Vector3 displacement; // m
  Vector3 normal;       // outward, of a particle at a surface; else zero
};

// A surface stays where it is: what touches the tool or lies at a free surface moves along it, and inwards
// only where the row has come off what is below; what lies below does not push it out.
SWARF_FN Shift shift_of(const ShiftSums& s, const ShiftPoint& at) {
  const Real size = shift_coefficient * at.h * at.h;
  Vector3 d = -size * (s.gradient + Real(shift_pairing) * s.pairing);
  Vector3 normal{0, 0, 0};
  const Real pressed = norm(at.pressed), steep = norm(s.gradient), seen2 = dot(s.surface, s.surface);
  const Vector3 out = steep > 0 ? (Real(-1) / steep) * s.gradient : Vector3{0, 0, 0};
  if (pressed > 0) {
    normal = (Real(-1) / pressed) * at.pressed;
    d = d - dot(d, normal) * normal;
    const Vector3 side =
        s.gradient - dot(s.gradient, normal) * normal; // steep where a free surface meets the tool
    const Real along = norm(side);
    if (along * at.spacing > Real(0.5) * surface_gradient)
      d = d - (Kokkos::min(Real(0), dot(d, side)) / (along * along)) * side;
  } else if (dot(out, multiply(s.A, out)) < surface_openness) {
    normal = out;
    const Real outward = dot(d, out);
    d = d + (Kokkos::min(Real(0), outward - size * surface_gradient / at.spacing) - outward) * out;
  } else if (seen2 > surface_seen * surface_seen) {
    d = d - (Kokkos::max(Real(0), dot(d, s.surface)) / seen2) * s.surface;
  }
  const Real length = norm(d), most = Kokkos::min(largest_shift * at.spacing, at.allowed);
  return {length > most ? (most / length) * d : d, normal};
}

// V (s:s / 4G + p^2 / 2K): J stored in an elastic volume V.
SWARF_FN Real elastic_energy(const Material& mat, const Symmetric3& stress, Real volume) {
  const Symmetric3 s = deviator(stress);
  const Real mean = trace(stress) / Real(3);
  return volume *
         (contract(s, s) / (Real(4) * mat.shear_modulus) + mean * mean / (Real(2) * mat.bulk_modulus));
}

} // namespace swarf
