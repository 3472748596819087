// The hexahedral bulk: 8 nodes, one integration point, lumped mass.
#pragma once
#include "swarf/material.hpp"

namespace swarf {

enum class HourglassControl : int { viscous, stiffness };

struct HexMesh {
  MaterialPoints points; // one per hex; points.count hexes
  int nodes = 0;

  View<int* [8]> connectivity;     // nodes of a hex, VTK order (0-3 bottom counter-clockwise, 4-7 above)
  ScalarField volume;              // m3
  ScalarField share;               // of the volume that carries stress: tied particles carry the rest
  View<Real* [8][3]> gradient;     // B_aj = dN_a/dx_j at the centre, 1/m
  View<Real* [8][3]> corner_force; // N, before the gather
  View<Real* [4][3]> hourglass;    // generalised hourglass force of the stiffness control, N
  ScalarField hourglass_work;      // J
  ScalarField viscous_work;        // J, bulk viscosity
  View<int*> active;               // hex_deleted, hex_active or hex_asleep (sleep.hpp)

  VectorField position, velocity, force;     // nodes
  ScalarField mass;                          // lumped, kg, not mass-scaled
  ScalarField heat_capacity;                 // lumped, J/K
  ScalarField nodal_temperature, nodal_heat; // K; J of the last conduction. 0 rows without conduction
  View<Real* [8]> corner_heat;               // J, before the gather
  VectorField friction_force, contact_force; // nodes on the surface that may touch the tool
  ScalarField friction_work, external_work, contact_energy;
  ScalarField contact_gap;     // m, 0: the node lies on the surface
  ScalarField contact_area;    // m2, share of the surface; 0 for nodes inside: no contact
  View<unsigned*> constraints; // bit b: row b of the ConstraintTable
  ScalarField damping;         // 1/s, where sleep begins; 0 rows without it

  // Gather: corners of node a are corner_of_node[corner_start[a] .. corner_start[a+1]), each 8 * hex +
  // corner.
  IndexField corner_start, corner_of_node;
  // Periodic pairs: node slave follows node master; rows (master, slave, transform).
  View<int* [3]> coupled_nodes;

  template <class Visitor>
  void for_each_field(Visitor&& visit) {
    points.for_each_field(visit);
    visit("volume", volume), visit("hourglass", hourglass), visit("hourglass_work", hourglass_work);
    visit("viscous_work", viscous_work), visit("active", active);
    visit("position", position), visit("velocity", velocity), visit("force", force);
    visit("friction_force", friction_force), visit("contact_force", contact_force);
    visit("friction_work", friction_work), visit("external_work", external_work);
    visit("contact_energy", contact_energy), visit("nodal_temperature", nodal_temperature);
    visit("constraints", constraints), visit("damping", damping);
  }
};

} // namespace swarf
