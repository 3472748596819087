// Penalty contact with incremental stick-slip Coulomb friction at one point. Pure functions.
#pragma once
#include "swarf/core/tensor.hpp"

namespace swarf {

struct ContactLaw {
  Real friction = 0;
  Real shear_limit = 0;       // Pa; 0: none
  Real stiffness = 0;         // times scaled mass / reference_step^2
  Real heat_to_workpiece = 0; // share of the friction work, where the tool does not conduct
  Real heat_resistance = 0;   // m2 K/W of the interface, where it does; 0: perfect contact
  Real reference_step = 0;    // s, the same for a whole run, so that the springs keep their energy when dt
                              // changes; 0: the dt of the step
};

// N/m, of the normal and of the tangential spring. Both oscillate at sqrt(stiffness) / reference_step.
SWARF_FN Real contact_stiffness(const ContactLaw& law, Real scaled_mass, Real dt) {
  const Real step = law.reference_step > Real(0) ? law.reference_step : dt;
  return law.stiffness * scaled_mass / (step * step);
}

// What happened to the pair of point and tool surface in one step.
struct ContactStep {
  Real penetration;       // m, gap - distance; <= 0: apart
  Vector3 normal;         // unit, from the tool to the point; not used when apart
  Vector3 slip;           // m, motion of the point relative to the tool surface in this step
  Vector3 friction_force; // N on the point, at the end of the step before
  Real shear_strength = Kokkos::Experimental::infinity_v<Real>; // Pa, of the material at the point
};

struct ContactResponse {
  Vector3 force{0, 0, 0};          // N, of the tool on the point
  Vector3 friction_force{0, 0, 0}; // N, its tangential part: the memory of the next step
  Real energy = 0;                 // J, stored in both springs
  Real dissipated = 0;             // J in this step
};

// The memory, turned into the tangent plane of `normal` without losing length (energy).
SWARF_FN Vector3 turn_into_plane(const Vector3& f, const Vector3& normal) {
  const Vector3 tangential = f - dot(f, normal) * normal;
  const Real length = norm(tangential);
  return length > Real(0) ? (norm(f) / length) * tangential : Vector3{0, 0, 0};
}

// f_n = k delta. Trial f* = f_old - k u_t; slip if |f*| > min(mu f_n, tau_max area), tau_max the least of the
// deck's limit and of what the material carries: f = f_max f* / |f*|. Dissipated: 1/2 (f_old + f) . (f* - f)
// / k, which is the work of the friction force by the trapezoidal rule (the one that leapfrog makes exact)
// less the change of the spring's energy |f|^2 / 2k. Parting is the case f_max = 0. Elastic predictor and
// slip corrector: Wriggers, Computational Contact Mechanics (2006), ch. 5.
SWARF_FN ContactResponse respond_to_contact(const ContactStep& step, const ContactLaw& law, Real stiffness,
                                            Real area) {
  const bool touching = step.penetration > Real(0);
  const Real normal_force = touching ? stiffness * step.penetration : Real(0);
  Real limit = law.friction * normal_force;
  Real shear = step.shear_strength;
  if (law.shear_limit > Real(0)) shear = Kokkos::fmin(shear, law.shear_limit);
  if (shear < Kokkos::Experimental::infinity_v<Real>) limit = Kokkos::fmin(limit, shear * area);

  Vector3 old = step.friction_force, slip = step.slip;
  if (touching) {
    old = turn_into_plane(old, step.normal);
    slip = slip - dot(slip, step.normal) * step.normal;
  }
  const Vector3 trial = old - stiffness * slip;
  const Real trial_length = norm(trial);
  const Vector3 held = trial_length > limit ? (limit / trial_length) * trial : trial;

  ContactResponse response;
  response.friction_force = held;
  if (touching) response.force = normal_force * step.normal + held;
  response.energy = (normal_force * normal_force + dot(held, held)) / (Real(2) * stiffness);
  response.dissipated = dot(old + held, trial - held) / (Real(2) * stiffness);
  return response;
}

} // namespace swarf
