// What the tool can touch: particles, or nodes of the hexes' surface. Views of their owner's fields.
#pragma once
#include "swarf/contact_law.hpp"
#include "swarf/material.hpp"

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
  ScalarField temperature;        // added to where it has rows: friction heat
  IndexField material;
  ScalarField plastic_strain, plastic_strain_rate; // 1, 1/s; read where there are rows
};

} // namespace swarf
