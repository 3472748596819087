// The particles of the SPH zone.
#pragma once
#include "swarf/material/material.hpp"
#include "swarf/tool/tool_surface.hpp"

namespace swarf {

// Rows of every field:  [0, count)              particles
//                       [count, count + tied)   tied particles: they live inside hexes and move with them
//                       [count + tied, listed)  frozen, of both kinds (freeze.hpp): neighbours only
//                       [listed, stored)        frozen, far from all that moves: in no list
//                       [stored, total)         ghosts of the rows before, across periodic and mirror planes
// Only rows [0, count) are integrated in time. Sorted in space at every neighbour rebuild.
struct Particles {
  MaterialPoints points; // points.count == count + tied
  int count = 0;
  int tied = 0;
  int listed = 0, stored = 0;
  int total = 0;
  int whole = 0; // particles active and frozen: those whose identity is less; the others are tied

  VectorField position;        // m
  VectorField velocity;        // m/s
  VectorField force;           // N, rows [0, count + tied)
  ScalarField inverse_support; // 1/m, 1 / (2 h): a pair takes the sum of two, and divides by nothing
  ScalarField volume;          // m3

  TensorField deformation_gradient; // F, rows [0, count + tied); 0 rows in the current frame

  // What a neighbour needs in the force sum (prepare_pair_state); and D, in points.velocity_gradient.
  TensorField pair_stress;        // K_i of the corrected kernel gradient; then, in its place, sigma K, Pa
  View<Real* [2]> heat_state;     // T (K) and k (W/(m K)), and
  SymmetricField heat_shape;      // sym K, then what of it weighs pairs: for conduct_heat; 0 rows without
  View<Real* [4]> pressure_state; // p (Pa) and its gradient, for diffuse_pressure; 0 rows without it
  View<Real* [3]> impedance;      // mass-scaled rho c (Pa s/m) and rho (kg/m3), shear modulus (Pa)
  VectorField
      hourglass_displacement; // m, what neighbours' gradients do not explain; 0 rows without stiffness

  // Of particles that lack neighbours (correct_surface.cpp); 0 rows without correction.
  View<Real* [4]> surface_shift; // sum_j V_j s~.grad W_ij (-), 0 inside, and s~, m
  VectorField edge_normal;       // across s~, in an edge: the other direction in which neighbours lack
  TensorField surface_term; // what they add to L, 1/s (or F, dF/dt); then, to the stress in the forces, Pa

  ScalarField heat;    // J that conduction brought last, rows [0, count + tied); 0 rows without it
  ScalarField damping; // 1/s, where freezing begins (freeze.hpp), rows [0, count); 0 rows without it

  VectorField highest_mode; // motion of the highest frequency, length 1 in all (advance_mode.cpp)

  // History that belongs to the particle.
  VectorField hourglass_rate;         // m/s, of hourglass_displacement
  ScalarField reference_summation;    // initial sum of m W (density = "summation", else 0 rows)
  VectorField friction_force;         // N, stick-slip memory
  VectorField contact_force;          // N, of the tool on the particle, this step
  ScalarField friction_work;          // J
  ScalarField viscous_work;           // J
  ScalarField hourglass_work;         // J
  VectorField surface_normal;         // outward, of particles at a surface, else 0 (shifting.hpp)
  ScalarField shifted_strain;         // plastic strain of which the shifts have been made
  ScalarField shifting_work;          // J, that the values of a shifted particle have lost
  ScalarField external_work;          // J, gravity and prescribed velocities
  ScalarField contact_energy;         // J, stored in the penalty spring
  ScalarField body_contact_energy;    // J, in springs between bodies, and
  VectorField body_friction;          // N, their stick-slip memory; 0 rows where no bodies meet
  ScalarField contact_gap;            // m, half the initial spacing: where the particle's own surface lies
  ScalarField contact_area;           // m2, the face of the particle's initial cube
  ScalarField heat_to_tool;           // J, not yet in the tool's cells; 0 rows without cells
  IndexField tool_cell;               // of the tool, that it touched last; 0 rows without cells
  View<Real* [surface_sums]> on_tool; // not yet on the tool's surface (tool_surface.hpp); 0 rows without tool
  IndexField tool_patch;              // of the tool, that it touched last
  View<unsigned*> heated_faces;       // bit b: row b of the HeatedFaces; 0 rows without any
  ScalarField face_heat;              // J, that has come through them; 0 rows without any
  IndexField identity;                // number given when the scene was built
  IndexField body;                    // row of the scene's bodies
  View<unsigned*> constraints;        // bit b: row b of the ConstraintTable

  // The table of these fields (fields.hpp). A new one is a declaration above and a row here.
  template <class Self, class Visit>
  SWARF_FN static void list_fields(Self& p, const Visit& visit) {
    using enum Frame;
    using enum Life;
    using enum Ghosts;
    using enum Method;
    using enum Shifting;
    for_each_field(p.points, visit);
    visit("position", p.position, Facts<point, history, when_made, after_drift>());
    visit("velocity", p.velocity, Facts<vector, history, after_drift, keeps_mass_sum>());
    visit("force", p.force, Facts<vector, history>());
    visit("inverse_support", p.inverse_support, Facts<history, when_made, after_drift, before_forces>());
    visit("volume", p.volume, Facts<history, after_drift, before_forces>());
    visit("impedance", p.impedance, Facts<history, after_drift, before_forces>());
    visit("pair_stress", p.pair_stress, Facts<tensor, pair, before_forces>());
    visit("heat_state", p.heat_state, Facts<pair, in_conduct_heat, with_conduction>());
    visit("heat_shape", p.heat_shape, Facts<symmetric, pair, in_conduct_heat, with_conduction>());
    visit("pressure_state", p.pressure_state,
          Facts<scalar_and_vector, pair, in_diffuse_pressure, with_pressure_diffusion>());
    visit("surface_shift", p.surface_shift,
          Facts<scalar_and_vector, pair, in_surface_stress, with_surface_gradient>());
    visit("edge_normal", p.edge_normal, Facts<vector, pair, in_surface_stress, with_surface_gradient>());
    visit("surface_term", p.surface_term, Facts<tensor, with_surface_gradient>());
    visit("hourglass_displacement", p.hourglass_displacement,
          Facts<vector, history, before_forces, with_hourglass_stiffness, transported>());
    visit("hourglass_rate", p.hourglass_rate, Facts<vector, history, with_hourglass_stiffness>());
    visit("deformation_gradient", p.deformation_gradient,
          Facts<tensor, in_surface_gradient, in_surface_stress, before_forces, with_initial_frame>());
    visit("heat", p.heat, Facts<with_conduction>());
    visit("damping", p.damping, Facts<history, with_freeze>());
    visit("surface_normal", p.surface_normal, Facts<vector, history, in_find_shifts, with_shifting>());
    visit("shifted_strain", p.shifted_strain, Facts<history, with_shifting>());
    visit("shifting_work", p.shifting_work, Facts<history, with_shifting>());
    visit("reference_summation", p.reference_summation, Facts<history, with_summation>());
    visit("highest_mode", p.highest_mode, Facts<vector, history, in_highest_mode>());
    visit("friction_force", p.friction_force, Facts<vector, history>());
    visit("contact_force", p.contact_force, Facts<vector, history>());
    visit("friction_work", p.friction_work, Facts<history>());
    visit("viscous_work", p.viscous_work, Facts<history>());
    visit("hourglass_work", p.hourglass_work, Facts<history>());
    visit("external_work", p.external_work, Facts<history>());
    visit("contact_energy", p.contact_energy, Facts<history>());
    visit("body_contact_energy", p.body_contact_energy, Facts<history, with_body_contact>());
    visit("body_friction", p.body_friction, Facts<vector, history, with_body_contact>());
    visit("contact_gap", p.contact_gap, Facts<history>());
    visit("contact_area", p.contact_area, Facts<history>());
    visit("heat_to_tool", p.heat_to_tool, Facts<history, with_tool_heat>());
    visit("tool_cell", p.tool_cell, Facts<history, with_tool_heat>());
    visit("heated_faces", p.heated_faces, Facts<history, with_face_heat>());
    visit("face_heat", p.face_heat, Facts<history, with_face_heat>());
    visit("on_tool", p.on_tool, Facts<history, with_tool>());
    visit("tool_patch", p.tool_patch, Facts<history, with_tool>());
    visit("identity", p.identity, Facts<history>());
    visit("body", p.body, Facts<history>());
    visit("constraints", p.constraints, Facts<history>());
  }

  SWARF_FN Real smoothing_length(int i) const { return Real(0.5) / inverse_support(i); } // m
};

} // namespace swarf
