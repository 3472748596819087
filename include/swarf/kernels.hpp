// Every launch of swarf, one line each: the table of contents of kernels/. The file, the function, the label
// of the launch, the test and the benchmark share one name.
#pragma once
#include "swarf/core/cell_order.hpp"
#include "swarf/core/status.hpp"
#include "swarf/hexes/body_contact.hpp"
#include "swarf/hexes/conversion.hpp"
#include "swarf/hexes/hex_mesh.hpp"
#include "swarf/hexes/tie.hpp"
#include "swarf/material/face_heat.hpp"
#include "swarf/particles/held_rows.hpp"
#include "swarf/particles/neighbors.hpp"
#include "swarf/particles/particles.hpp"
#include "swarf/region/retire.hpp"
#include "swarf/tool/contact_points.hpp"
#include "swarf/tool/tool_load.hpp"
#include <vector>

namespace swarf {

// Choices of the particle sums that hold for a whole run.
struct ParticleMethod {
  bool correction = true;     // Randles-Libersky gradient correction
  bool correct_forces = true; // the adjoint of it in the forces
  Real viscosity_linear = 0;  // times Z: damps motion that the velocity gradient does not see
  Real viscosity_quadratic = 0;
  Real hourglass_stiffness = 0; // times the shear modulus: resists the same motion
  Real spacing_ratio = 0;       // spacing / h of the initial lattice
  Real mass_factor = 1;
  bool initial_frame = false; // kernels, lists and volumes of the initial positions: total Lagrangian
};

struct HexMethod {
  HourglassControl hourglass = HourglassControl::stiffness;
  Real hourglass_coefficient = 0;
  Real viscosity_linear = 0, viscosity_quadratic = 0;
  Real delete_at_strain = 0; // 0: never
  bool delete_failed = false;
  Real mass_factor = 1;
};

// --- neighbours and ghosts
using GhostPlanes = std::vector<GhostPlane>; // on the host: a launch for each plane
void wrap_periodic(const Particles&, const GhostPlanes&, const Status&); // back through the partner plane
void sort_particles(Particles&, const CellGrid& lattice);     // rows [0, count) along a Hilbert curve
void make_ghosts(Particles&, Neighbors&, const GhostPlanes&); // rows [stored, total)
void find_neighbors(Neighbors&, const Particles&);            // clusters and their lists
void update_ghosts(const Particles&, const Neighbors&, const GhostPlanes&);      // position, velocity
void update_ghost_state(const Particles&, const Neighbors&, const GhostPlanes&); // what the force sum needs

// --- particles
void velocity_gradient(const Particles&, const Neighbors&, const ParticleMethod&); // L_i and K_i
void reference_gradient(const Particles&, const Neighbors&);                  // the same in the initial frame
void correct_surface(const Particles&, const Neighbors&, const GhostPlanes&); // of second order
void surface_stress(const Particles&, const Neighbors&, const GhostPlanes&);  // its adjoint
void sum_density(const Particles&, const Neighbors&, const MaterialTable&);   // density by summation
void evolve_smoothing_length(const Particles&);                               // before the next
void prepare_pair_state(const Particles&, const MaterialTable&, const ParticleMethod&);
void evolve_hourglass(const Particles&, const MaterialTable&, Real dt); // hourglass_displacement
void particle_forces(const Particles&, const Neighbors&, const ParticleMethod&, Real dt);
struct PressureDiffusion {
  Real coefficient; // delta
  Real time;        // s since the last call
  Real step;        // s, the last step
  bool density;     // goes along; false where it is a sum over neighbours
};
void diffuse_pressure(const Particles&, const Neighbors&, const GhostPlanes&, const MaterialTable&,
                      const PressureDiffusion&);

struct Shifts {             // slot pack_width k + lane is row first(cluster(k)) + lane
  IndexField cluster;       // of the lists: those that have flowed
  VectorField displacement; // m
  VectorField corrected;    // m, K_i of it
  VectorField normal;       // outward, of particles at a surface, else 0
  int clusters() const { return int(cluster.extent(0)); }
};
Shifts find_shifts(const Particles&, const Neighbors&, const GhostPlanes&, const ParticleMethod&);
void transport_fields(const Particles&, const Neighbors&, const GhostPlanes&, const MaterialTable&,
                      const Shifts&,
                      Real mass_factor); // and moves the particles

// --- hexes
void hex_velocity_gradient(const HexMesh&, const Status&); // B, volume, L at the centre
void hex_forces(const HexMesh&, const MaterialTable&, const HexMethod&, Real dt); // corner forces
void gather_corner_forces(const HexMesh&); // node force = sum of its corners
void delete_hexes(const HexMesh&, const HexMethod&);
void couple_nodes(const HexMesh&, const TransformTable&,
                  bool forces);                          // periodic pairs: forces in, or velocities out
void couple_heat(const HexMesh&, const TransformTable&); // periodic pairs share nodal_heat

// --- both
// active: of hexes, frozen ones are left out; empty: all points.
void update_stress(const MaterialPoints&, const MaterialTable&, Real dt, const Status&,
                   const View<int*>& active = {});
void tool_contact(const ContactPoints&, const Tool&, const ToolPose&, const ContactLaw&, const MaterialTable&,
                  Real mass_factor, Real dt);

// --- bodies that meet
void find_body_contact(BodyContact&, const HexMesh&, const Particles&, const ContactGroups&);
// The second half of it: of the faces and particles that `key` and `row` name, as a restart does.
void list_body_contact(BodyContact&, const HexMesh&, const Particles&, const ContactGroups&);
Real way_since(const BodyContact&, const HexMesh&, const Particles&); // m, of the farthest since the lists
struct PressStep {
  const ContactLaw& law;
  const MaterialTable& materials;
  Real mass_factor, dt;
};
void press_bodies(const BodyContact&, const HexMesh&, const Particles&, const PressStep&);

// --- tie
void project_tie(const Tie&, const Particles&, const HexMesh&);       // x, v of tied particles from nodes
void gather_tie_forces(const Tie&, const Particles&, const HexMesh&); // to the nodes of the hosts

// --- heat
void conduct_heat(const Particles&, const Neighbors&, const GhostPlanes&, const MaterialTable&, Real dt);
void hex_heat(const HexMesh&, const MaterialTable&, Real dt);                         // to the corners
void gather_heat(const Tie&, const Particles&, const HexMesh&, const MaterialTable&); // to the nodes
// Of nodes, hexes, tied particles.
void spread_temperature(const Tie&, const Particles&, const HexMesh&, const MaterialTable&);
// What the contact has brought to nodes: into their hexes and the particles tied there.
void spread_contact_heat(const Tie&, const Particles&, const HexMesh&, const TransformTable&,
                         const MaterialTable&);
// Through faces of bodies: after conduct_heat; into nodal_heat through films before nodes are coupled, and
// where temperatures are held after that.
void heat_faces(const Particles&, const HeatedFaces&, const MaterialTable&, Real dt);
void heat_nodes(const HexMesh&, const HeatedNodes&, const HeatedFaces&, const MaterialTable&, Real dt);
void hold_temperatures(const HexMesh&, const HeatedNodes&, const HeatedFaces&, const MaterialTable&);
void gather_tool_heat(const ContactPoints&, const ToolHeat&); // what points have brought, to the tool's cells
void conduct_tool(const ToolHeat&, Real dt);

// --- the tool's surface
void gather_tool_surface(const ContactPoints&, const ToolSurface&); // what points have done to its patches
View<Real* [shown_on_tool]> show_tool_surface(const Tool&, Real duration); // of what was gathered in it, s

// --- the tool, before the run
View<Real* [4]> distance_to_tool(const Tool&,
                                 const VectorField& x); // signed, and outward normal, of points x

// --- the active region, and what is frozen
struct ToolAt { // 0 facets: no tool
  const Tool& tool;
  ToolPose pose;
};
VectorField find_active_region(const Particles&, const HexMesh&, const ToolAt&, const Freeze&); // points [n]
VectorField with_images(const VectorField& region, const std::vector<Transform>&);
void freeze_particles(Particles&, const Tie&, const VectorField& region, const Freeze&);
void freeze_hexes(const HexMesh&, const TransformTable&, const VectorField& region, const Freeze&);
void find_tied_rows(const Tie&, const Particles&);                                     // tie.row
VectorField find_work(const Particles&, const HexMesh&, const ToolAt&, const Retire&); // of retire.hpp
void retire_particles(const Particles&, const VectorField& work, const ToolAt&,
                      const Retire&); // before they are frozen; puts no row elsewhere

// --- conversion
IndexField choose_hexes(const HexMesh&, const ConversionLimits&, const ToolPose&); // 1: is to convert

// --- time
struct Motion { // a set of points that Newton's law moves: particles or nodes
  int count = 0;
  VectorField position, velocity, force;
  ScalarField mass, external_work;
  View<unsigned*> constraints;
  ScalarField plastic_strain; // of particles, for hold_faces
};
void kick(const Motion&, const ConstraintTable&, const Vector3& gravity, Real mass_factor, Real dt);
void find_held_rows(const HeldRows&, const Particles&); // held.row
struct Kick {                                           // that was the last
  Real mass_factor, dt;
};
void hold_faces(const HeldRows&, const Motion&, const ConstraintTable&, const Kick&);
void drift(const Motion&, Real dt);
void absorb_waves(const Motion&, const ScalarField& damping, Real mass_factor, Real dt);

// --- sums and extremes: fixed blocks, so that the sum does not depend on the number of threads
// Adds the load of this step to sums.total and the tool's work to it; no copy to the host.
void sum_tool_load(const ContactPoints&, const Tool&, const ToolPose&, Real dt, const ToolLoadSums&);
int count_points_inside(const ContactPoints&, const Tool&, const ToolPose&,
                        Real depth); // deeper than depth, m
struct ClosestPoint {
  Real depth = -Kokkos::Experimental::infinity_v<Real>; // m, of contact; negative: so far from it
  int row = -1;                                         // none within the tool's reach
};
ClosestPoint find_closest_point(const ContactPoints&, const Tool&, const ToolPose&);

struct PointSums {
  Real kinetic = 0, internal = 0, plastic = 0, external = 0, friction = 0, viscous = 0, hourglass = 0,
       contact = 0, shifting = 0;
  Vector3 momentum{0, 0, 0};
  Real max_temperature = 0, max_plastic_strain = 0, max_speed = 0;
  int hottest = -1;

  KOKKOS_INLINE_FUNCTION void add(const PointSums& o) {
    kinetic += o.kinetic, internal += o.internal, plastic += o.plastic, external += o.external;
    friction += o.friction, viscous += o.viscous, hourglass += o.hourglass, contact += o.contact;
    shifting += o.shifting;
    momentum = momentum + o.momentum;
    if (o.max_temperature > max_temperature) max_temperature = o.max_temperature, hottest = o.hottest;
    max_plastic_strain = Kokkos::max(max_plastic_strain, o.max_plastic_strain);
    max_speed = Kokkos::max(max_speed, o.max_speed);
  }
};
PointSums sum_particles(const Particles&, Real mass_factor, int begin, int end); // of rows [begin, end)
inline PointSums sum_particles(const Particles& p, Real mass_factor) {
  return sum_particles(p, mass_factor, 0, p.stored);
}
PointSums sum_hexes(const HexMesh&, Real mass_factor);

struct HeatSums {             // J, above the temperature `reference`
  Real work = 0, plastic = 0; // stored in the work; made there by plastic work
  Real tool = 0, out = 0;     // stored in the tool, or on its way there; gone into what is held
  Real tool_hottest = 0;      // K
  int hottest_cell = -1;      // of the tool

  KOKKOS_INLINE_FUNCTION void add(const HeatSums& o) {
    work += o.work, plastic += o.plastic, tool += o.tool, out += o.out;
    if (o.tool_hottest > tool_hottest) tool_hottest = o.tool_hottest, hottest_cell = o.hottest_cell;
  }
};
HeatSums sum_heat(const Particles&, const MaterialTable&, Real reference);
HeatSums sum_heat(const HexMesh&, const MaterialTable&, Real reference);
HeatSums sum_heat(const ToolHeat&);

struct StableStep {
  Real dt = 0; // s, at Courant number 1
  int limiter = -1;
  Real approach = 0; // m, that two particles may have come nearer by since the lists were built
};
void elastic_stress(const MaterialPoints&, const MaterialTable&); // of a motion, by Hooke's law
struct Oscillators {
  Real mass_factor;
  Real contact; // 1/s2, at most, of the springs between the tool and the particles that touch it
};
struct ModeRates {
  Real stiffness = 0, damping = 0; // 1/s2, 1/s
};
// Towards the mode of the highest frequency.
ModeRates advance_mode(const Particles&, const Oscillators&, long seed);
struct ParticleStep {
  const ParticleMethod& method;
  Real of_waves; // s, from the highest mode; in the initial frame, undeformed
};
StableStep stable_step(const Particles&, const Neighbors&, const MaterialTable&, const ParticleStep&);
StableStep stable_step(const HexMesh&, const MaterialTable&, const HexMethod&);
Real stable_heat_step(const Particles&, const MaterialTable&); // s; infinite without conduction
Real stable_heat_step(const HexMesh&, const MaterialTable&);
Real stable_heat_step(const ToolHeat&);

} // namespace swarf
