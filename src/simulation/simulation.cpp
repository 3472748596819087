#include "src/simulation/simulation.hpp"
#include <cmath>
#include <fmt/format.h>

namespace swarf {

Motion motion_of(const Particles& p) {
  return {p.count,       p.position,      p.velocity,    p.force,
          p.points.mass, p.external_work, p.constraints, p.points.equivalent_plastic_strain};
}
Motion motion_of(const HexMesh& m) {
  return {m.nodes, m.position, m.velocity, m.force, m.mass, m.external_work, m.constraints, {}};
}

ContactPoints contact_points_of(const Particles& p) {
  return {p.count,
          p.position,
          p.velocity,
          p.points.mass,
          p.contact_gap,
          p.contact_area,
          p.force,
          p.friction_force,
          p.contact_force,
          p.friction_work,
          p.contact_energy,
          p.points.temperature,
          p.points.material,
          p.points.equivalent_plastic_strain,
          p.points.plastic_strain_rate,
          {},
          {},
          p.heat_to_tool,
          p.tool_cell,
          p.on_tool,
          p.tool_patch};
}
ContactPoints contact_points_of(const HexMesh& m) {
  return {m.nodes,         m.position,      m.velocity,       m.mass,
          m.contact_gap,   m.contact_area,  m.force,          m.friction_force,
          m.contact_force, m.friction_work, m.contact_energy, m.nodal_temperature,
          m.node_material, ScalarField(),   ScalarField(),    m.contact_heat,
          m.heat_capacity, m.heat_to_tool,  m.tool_cell,      m.on_tool,
          m.tool_patch};
}

void Simulation::step() {
  timer.restart();
  kick_half();
  move();
  timer.mark("integrate");
  if (shift_is_due()) shift();
  if (conversion.due || freezing.due) take_contact_heat(), take_surface_sums();
  const int moving = model.particles.count;
  if (conversion.due) convert();
  if (freezing.due) freeze();
  if (model.particles.count > moving) next_mode = steps; // which may be of those that have come
  if (lists_due) rebuild_lists();
  if (meeting_due) follow_bodies();
  follow_highest_mode();
  follow_hexes_and_ghosts();
  update_rates_and_stresses();
  if (deck.particles.pressure_diffusion > 0) smooth_pressure();
  compute_forces();
  press_tool();
  if (conducts) conduct();
  kick_half();
  if (deck.sleep.distance) fade_waves();
  if (wave_step > 0 && !particle_method.initial_frame && model.particles.count > 0) // it may have fallen
    step_size = std::min(step_size, deck.run.courant * wave_step);
  timer.mark("integrate");
  ++steps, moved_particles += model.particles.count;
}

void Simulation::kick_half() {
  const Real half = Real(0.5 * step_size);
  kick(motion_of(model.particles), model.constraints, gravity, Real(mass_factor), half);
  kick(motion_of(model.hexes), model.constraints, gravity, Real(mass_factor), half);
  hold_faces(model.held_rows, motion_of(model.particles), model.constraints, {Real(mass_factor), half});
  couple_nodes(model.hexes, model.node_transforms, false);
}

void Simulation::move() {
  drift(motion_of(model.particles), Real(step_size));
  drift(motion_of(model.hexes), Real(step_size));
  now += step_size; // the tool's pose is a function of time
}

// Whenever the tool, or what moves in its place, has gone a sixteenth of a spacing: no time step enters.
bool Simulation::shift_is_due() {
  if (!shifts()) return false;
  way_since_shift += shift_speed * step_size;
  if (way_since_shift < shift_way()) return false;
  way_since_shift = 0;
  return true;
}

// With the lists of where particles were; they are made anew at once, so that no look ahead counts shifts.
void Simulation::shift() {
  follow_hexes_and_ghosts();
  const Shifts found = find_shifts(model.particles, lists, model.ghost_planes, particle_method);
  transport_fields(model.particles, lists, model.ghost_planes, model.materials, found, Real(mass_factor));
  lists_due = lists_due || found.clusters() > 0;
  timer.mark("shifting");
}

void Simulation::rebuild_lists() {
  wrap_periodic(model.particles, model.ghost_planes, status);
  sort_particles(model.particles, model.lattice);
  find_held_rows(model.held_rows, model.particles);
  project_tie(model.tie, model.particles, model.hexes);
  make_ghosts(model.particles, lists, model.ghost_planes);
  find_neighbors(lists, model.particles);
  lists_due = false, meeting_due = bodies_meet();
  ++rebuild_count;
  timer.mark("neighbours");
}

void Simulation::follow_hexes_and_ghosts() {
  project_tie(model.tie, model.particles, model.hexes);
  update_ghosts(model.particles, lists, model.ghost_planes);
  timer.mark("tie and ghosts");
}

void Simulation::update_rates_and_stresses() {
  const Real dt = Real(step_size);
  if (particle_method.initial_frame)
    reference_gradient(model.particles, lists);
  else
    velocity_gradient(model.particles, lists, particle_method);
  if (has_surfaces()) correct_surface(model.particles, lists, model.ghost_planes);
  timer.mark("velocity gradient");
  hex_velocity_gradient(model.hexes, hex_status);
  timer.mark("hexes");
  update_stress(model.particles.points, model.materials, dt, status);
  if (deck.particles.density == DensityRule::summation) sum_density(model.particles, lists, model.materials);
  update_stress(model.hexes.points, model.materials, dt, hex_status, model.hexes.active);
  delete_hexes(model.hexes, hex_method);
  timer.mark("stress");
}

// As rarely as stable and smooth: sum_j of the weights is 6 delta c / h, of which a call takes 0.2.
void Simulation::smooth_pressure() {
  if (model.particles.count == 0) return;
  pressure_pace.add(step_size);
  const double delta = deck.particles.pressure_diffusion;
  if (6 * delta * pressure_pace.by_next(step_size) <= 0.2 * particle_step) return;
  diffuse_pressure(model.particles, lists, model.ghost_planes, model.materials,
                   {Real(delta), Real(pressure_pace.take()), Real(step_size),
                    deck.particles.density != DensityRule::summation});
  timer.mark("pressure");
}

void Simulation::compute_forces() {
  const Real dt = Real(step_size);
  if (deck.particles.hourglass_stiffness > 0 && !particle_method.initial_frame)
    evolve_hourglass(model.particles, model.materials, dt);
  if (has_surfaces()) surface_stress(model.particles, lists, model.ghost_planes);
  if (deck.particles.smoothing_length == SmoothingLength::evolving) evolve_smoothing_length(model.particles);
  prepare_pair_state(model.particles, model.materials, particle_method);
  update_ghost_state(model.particles, lists, model.ghost_planes);
  timer.mark("tie and ghosts");
  particle_forces(model.particles, lists, particle_method, dt);
  timer.mark("particle forces");
  hex_forces(model.hexes, model.materials, hex_method, dt);
  gather_corner_forces(model.hexes);
  timer.mark("hexes");
  gather_tie_forces(model.tie, model.particles, model.hexes);
  timer.mark("tie and ghosts");
}

void Simulation::press_tool() {
  const Real dt = Real(step_size);
  if (deck.tool) {
    const ToolPose where = pose();
    for (const ContactPoints& points : {contact_points_of(model.particles), contact_points_of(model.hexes)}) {
      tool_contact(points, model.tool, where, contact_law, model.materials, Real(mass_factor), dt);
      sum_tool_load(points, model.tool, where, dt, loads);
    }
  }
  if (bodies_meet())
    press_bodies(meeting, model.hexes, model.particles,
                 {contact_law, model.materials, Real(mass_factor), dt});
  couple_nodes(model.hexes, model.node_transforms, true);
  timer.mark("contact");
}

void Simulation::take_contact_heat() {
  if (!deck.tool && !bodies_meet()) return;
  spread_contact_heat(model.tie, model.particles, model.hexes, model.node_transforms, model.materials);
  if (!deck.tool) return;
  for (const ContactPoints& points : {contact_points_of(model.particles), contact_points_of(model.hexes)}) {
    ensure_rows(model.tool.heat.source, points.heat_to_tool.extent(0));
    gather_tool_heat(points, model.tool.heat);
  }
}

void Simulation::take_surface_sums() {
  if (!deck.tool) return;
  for (const ContactPoints& points : {contact_points_of(model.particles), contact_points_of(model.hexes)}) {
    ensure_rows(model.tool.surface.source, points.on_tool.extent(0));
    gather_tool_surface(points, model.tool.surface);
  }
}

// As rarely as its own stable step allows: many mechanical steps, or several in one under a large mass
// factor. The tool's cells are few, and take steps of their own.
void Simulation::conduct() {
  heat_pace.add(step_size);
  if (heat_pace.by_next(step_size) <= heat_step) return;
  take_contact_heat();
  const double heat_time = heat_pace.take();
  const int parts = int(std::ceil(heat_time / heat_step));
  const Real dt = Real(heat_time / parts);
  for (int k = 0; k < parts; ++k) {
    conduct_heat(model.particles, lists, model.ghost_planes, model.materials, dt);
    heat_faces(model.particles, model.heated_faces, model.materials, dt);
    hex_heat(model.hexes, model.materials, dt);
    gather_heat(model.tie, model.particles, model.hexes, model.materials);
    heat_nodes(model.hexes, model.heated_nodes, model.heated_faces, model.materials, dt);
    couple_heat(model.hexes, model.node_transforms);
    hold_temperatures(model.hexes, model.heated_nodes, model.heated_faces, model.materials);
    spread_temperature(model.tie, model.particles, model.hexes, model.materials);
  }
  const int tool_parts = int(std::ceil(heat_time / tool_heat_step)); // 0 of a tool that does not conduct
  for (int k = 0; k < tool_parts; ++k) conduct_tool(model.tool.heat, Real(heat_time / tool_parts));
  timer.mark("heat");
}

} // namespace swarf
