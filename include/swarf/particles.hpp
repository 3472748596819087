// The particles of the SPH zone.
#pragma once
#include "swarf/material.hpp"

namespace swarf {

// Rows of every field:  [0, count)              particles
//                       [count, count + tied)   tied particles: they live inside hexes and move with them
//                       [count + tied, listed)  asleep, of both kinds (sleep.hpp): neighbours only
//                       [listed, stored)        asleep, far from all that moves: in no list
//                       [stored, total)         images of the rows before, across periodic and mirror planes
// Only rows [0, count) are integrated in time. Sorted in space at every neighbour rebuild.
struct Particles {
  MaterialPoints points; // points.count == count + tied
  int count = 0;
  int tied = 0;
  int listed = 0, stored = 0;
  int total = 0;
  int whole = 0; // particles awake and asleep: those whose identity is less; the others are tied

  VectorField position;        // m
  VectorField velocity;        // m/s
  VectorField force;           // N, rows [0, count + tied)
  ScalarField inverse_support; // 1/m, 1 / (2 h): a pair takes the sum of two, and divides by nothing
  ScalarField volume;          // m3

  TensorField deformation_gradient; // F, rows [0, count + tied); 0 rows in the current frame

  // What a neighbour needs in the force sum (prepare_pair_state); and D, in points.velocity_gradient.
  TensorField pair_stress;          // K_i of the corrected kernel gradient; then, in its place, sigma K, Pa
  SymmetricField artificial_stress; // Gray-Monaghan, Pa; 0 rows without it
  View<Real* [2]> heat_state;       // T (K) and k (W/(m K)), and
  SymmetricField heat_shape;        // sym K: for conduct_heat; 0 rows without conduction
  View<Real* [4]> pressure_state;   // p (Pa) and its gradient, for diffuse_pressure; 0 rows without it
  View<Real* [3]> impedance;        // mass-scaled rho c (Pa s/m) and rho (kg/m3), shear modulus (Pa)
  VectorField
      hourglass_displacement; // m, what neighbours' gradients do not explain; 0 rows without stiffness

  VectorField drift_velocity; // m/s, rows [0, count); 0 rows without XSPH
  ScalarField heat;           // J that conduction brought last, rows [0, count + tied); 0 rows without it
  ScalarField damping;        // 1/s, where sleep begins (sleep.hpp), rows [0, count); 0 rows without it

  // History that belongs to the particle.
  VectorField hourglass_rate;      // m/s, of hourglass_displacement
  ScalarField reference_summation; // initial sum of m W (density = "summation", else 0 rows)
  VectorField friction_force;      // N, stick-slip memory
  VectorField contact_force;       // N, of the tool on the particle, this step
  ScalarField friction_work;       // J
  ScalarField viscous_work;        // J
  ScalarField hourglass_work;      // J
  ScalarField external_work;       // J, gravity and prescribed velocities
  ScalarField contact_energy;      // J, stored in the penalty spring
  ScalarField contact_gap;         // m, half the initial spacing: where the particle's own surface lies
  ScalarField contact_area;        // m2, the face of the particle's initial cube
  IndexField identity;             // number given when the scene was built
  IndexField body;                 // row of the scene's bodies
  View<unsigned*> constraints;     // bit b: row b of the ConstraintTable

  // Visits what sorting permutes and a checkpoint stores; derived rows are recomputed.
  template <class Visitor>
  void for_each_field(Visitor&& visit) {
    points.for_each_field(visit);
    visit("position", position), visit("velocity", velocity), visit("force", force);
    visit("inverse_support", inverse_support), visit("volume", volume), visit("impedance", impedance);
    visit("reference_summation", reference_summation);
    visit("hourglass_displacement", hourglass_displacement), visit("hourglass_rate", hourglass_rate);
    visit("friction_force", friction_force), visit("contact_force", contact_force);
    visit("friction_work", friction_work), visit("viscous_work", viscous_work),
        visit("hourglass_work", hourglass_work);
    visit("external_work", external_work), visit("contact_energy", contact_energy);
    visit("contact_gap", contact_gap), visit("contact_area", contact_area);
    visit("identity", identity), visit("body", body), visit("constraints", constraints);
    visit("damping", damping);
  }

  // Visits what a neighbour reads and the step recomputes for rows that are awake: sleeping rows keep it.
  template <class Visitor>
  void for_each_pair_field(Visitor&& visit) {
    visit("pair_stress", pair_stress), visit("artificial_stress", artificial_stress);
    visit("pressure_state", pressure_state);
    visit("heat_state", heat_state), visit("heat_shape", heat_shape);
  }

  SWARF_FN Real smoothing_length(int i) const { return Real(0.5) / inverse_support(i); } // m
};

} // namespace swarf
