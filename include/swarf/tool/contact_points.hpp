// What the tool can touch: particles, or nodes of the hexes' surface. Views of their owner's fields.
#pragma once
#include "swarf/material/material.hpp"
#include "swarf/tool/contact_law.hpp"
#include "swarf/tool/tool_surface.hpp"

namespace swarf {

struct ContactPoints {
  int count = 0;
  VectorField position, velocity; // read
  ScalarField mass, gap, area;    // read; a point with area 0 is inside and never touches
  VectorField force;              // added to
  VectorField friction_force;     // read and written: stick-slip memory, N
  VectorField contact_force;      // written: force of the tool on the point, N
  ScalarField friction_work;      // added to: dissipated, J
  ScalarField contact_energy;     // written: stored in normal and tangential springs, J
  ScalarField temperature;        // K; added to, unless `heat` takes what the contact brings
  IndexField material;
  ScalarField plastic_strain, plastic_strain_rate; // 1, 1/s; read where there are rows
  ScalarField heat{};          // nodes: added to, J that their hexes do not show yet; 0 rows: particles
  ScalarField heat_capacity{}; // nodes: J/K; a particle's follows from its mass
  ScalarField heat_to_tool{};  // added to where the tool conducts, J
  IndexField tool_cell{};      // written there: cell of the tool that the point touches
  View<Real* [surface_sums]> on_tool {}; // added to: what the point has done to the tool; 0 rows: not kept
  IndexField tool_patch{};               // written with it: patch that the point touches
};

} // namespace swarf
