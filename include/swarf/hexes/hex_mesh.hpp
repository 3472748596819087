// The hexahedral bulk: 8 nodes, one integration point, lumped mass.
#pragma once
#include "swarf/material/material.hpp"
#include "swarf/tool/tool_surface.hpp"

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
  View<int*> active;               // hex_deleted, hex_active or hex_frozen (freeze.hpp)

  VectorField position, velocity, force;     // nodes
  ScalarField mass;                          // lumped, kg, not mass-scaled
  ScalarField heat_capacity;                 // lumped, J/K; of a table of specific heat, where that is least
  IndexField node_material;                  // row of the MaterialTable; 0 rows without such tables
  ScalarField nodal_temperature;             // K; 0 rows without conduction
  ScalarField nodal_heat;                    // J, of the last conduction, or of the contact
  ScalarField contact_heat;                  // J, that the contact has brought and no temperature shows yet
  ScalarField face_heat;                     // J, that has come through heated faces; 0 rows without any
  View<Real* [8]> corner_heat;               // J, before the gather
  VectorField friction_force, contact_force; // nodes on the surface that may touch the tool
  ScalarField friction_work, external_work, contact_energy;
  ScalarField body_contact_energy;    // J, in springs between bodies; 0 rows where none meet
  ScalarField heat_to_tool;           // J, not yet in the tool's cells; 0 rows without cells
  IndexField tool_cell;               // of the tool, that the node touched last; 0 rows without cells
  View<Real* [surface_sums]> on_tool; // not yet on the tool's surface (tool_surface.hpp); 0 rows without tool
  IndexField tool_patch;              // of the tool, that the node touched last
  ScalarField contact_gap;            // m, 0: the node lies on the surface
  ScalarField contact_area;           // m2, share of the surface; 0 for nodes inside: no contact
  View<unsigned*> constraints;        // bit b: row b of the ConstraintTable
  ScalarField damping;                // 1/s, where freezing begins; 0 rows without it

  // Gather: corners of node a are corner_of_node[corner_start[a] .. corner_start[a+1]), each 8 * hex +
  // corner.
  IndexField corner_start, corner_of_node;
  // Periodic pairs: node slave follows node master; rows (master, slave, transform).
  View<int* [3]> coupled_nodes;

  // The table of these fields (fields.hpp): all but what says which nodes are whose.
  template <class Self, class Visit>
  SWARF_FN static void list_fields(Self& m, const Visit& visit) {
    using enum Frame;
    using enum Life;
    using enum Method;
    using enum Per;
    for_each_field(m.points, visit);
    visit("volume", m.volume, Facts<history>());
    visit("share", m.share, Facts<>());
    visit("gradient", m.gradient, Facts<vector>());
    visit("corner_force", m.corner_force, Facts<vector>());
    visit("hourglass", m.hourglass, Facts<vector, history>());
    visit("hourglass_work", m.hourglass_work, Facts<history>());
    visit("viscous_work", m.viscous_work, Facts<history>());
    visit("active", m.active, Facts<history>());
    visit("corner_heat", m.corner_heat, Facts<with_conduction>());
    visit("position", m.position, Facts<per_node, point, history>());
    visit("velocity", m.velocity, Facts<per_node, vector, history>());
    visit("force", m.force, Facts<per_node, vector, history>());
    visit("nodal_mass", m.mass, Facts<per_node>());
    visit("heat_capacity", m.heat_capacity, Facts<per_node>());
    visit("node_material", m.node_material, Facts<per_node, with_heat_tables>());
    visit("face_heat", m.face_heat, Facts<per_node, history, with_face_heat>());
    visit("nodal_temperature", m.nodal_temperature, Facts<per_node, history, with_conduction>());
    visit("nodal_heat", m.nodal_heat, Facts<per_node>());
    visit("contact_heat", m.contact_heat, Facts<per_node, history>());
    visit("heat_to_tool", m.heat_to_tool, Facts<per_node, history, with_tool_heat>());
    visit("tool_cell", m.tool_cell, Facts<per_node, history, with_tool_heat>());
    visit("on_tool", m.on_tool, Facts<per_node, history, with_tool>());
    visit("tool_patch", m.tool_patch, Facts<per_node, history, with_tool>());
    visit("friction_force", m.friction_force, Facts<per_node, vector, history>());
    visit("contact_force", m.contact_force, Facts<per_node, vector, history>());
    visit("friction_work", m.friction_work, Facts<per_node, history>());
    visit("external_work", m.external_work, Facts<per_node, history>());
    visit("contact_energy", m.contact_energy, Facts<per_node, history>());
    visit("body_contact_energy", m.body_contact_energy, Facts<per_node, history, with_body_contact>());
    visit("contact_gap", m.contact_gap, Facts<per_node>());
    visit("contact_area", m.contact_area, Facts<per_node>());
    visit("constraints", m.constraints, Facts<per_node, history>());
    visit("damping", m.damping, Facts<per_node, history, with_freeze>());
  }
};

} // namespace swarf
