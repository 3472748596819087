// Everything about a Simulation that is not the step: construction, checks, samples.
#include "src/simulation/simulation.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace swarf {
namespace {

Vector3 to_vector(const Triple& t) { return {Real(t[0]), Real(t[1]), Real(t[2])}; }

ParticleMethod particle_method_of(const Deck& deck) {
  ParticleMethod m;
  m.correction = deck.particles.correction;
  m.correct_forces = deck.particles.correct_forces;
  m.viscosity_linear = Real(deck.particles.viscosity_linear);
  m.viscosity_quadratic = Real(deck.particles.viscosity_quadratic);
  m.hourglass_stiffness = Real(deck.particles.hourglass_stiffness);
  m.spacing_ratio = Real(1 / deck.particles.smoothing_ratio);
  m.mass_factor = Real(deck.run.mass_factor);
  m.initial_frame = deck.particles.kernel_frame == KernelFrame::initial;
  return m;
}

HexMethod hex_method_of(const Deck& deck) {
  HexMethod m;
  m.hourglass = deck.hexes.hourglass == HourglassMethod::viscous ? HourglassControl::viscous
                                                                 : HourglassControl::stiffness;
  m.hourglass_coefficient = Real(deck.hexes.hourglass_coefficient);
  m.viscosity_linear = Real(deck.hexes.viscosity_linear);
  m.viscosity_quadratic = Real(deck.hexes.viscosity_quadratic);
  m.delete_failed = deck.hexes.delete_failed;
  m.delete_at_strain = Real(deck.hexes.delete_at_strain.value_or(0));
  m.mass_factor = Real(deck.run.mass_factor);
  return m;
}

double length(const Triple& v) { return std::hypot(v[0], v[1], v[2]); }

// Of tool and held faces: what a scene at rest will soon move at.
std::vector<double> driving_speeds_of(const Deck& deck, const Scene& scene) {
  std::vector<double> speeds;
  for (const BodyDeck& body : deck.bodies)
    for (const FaceDeck& face : body.faces) speeds.push_back(length(face.velocity));
  if (!deck.tool) return speeds;
  const ToolPose pose = tool_pose(*deck.tool, 0);
  double radius = 0;
  for (const auto& facet : scene.tool_facets)
    for (const Triple& corner : facet) radius = std::max(radius, std::hypot(corner[0], corner[1]));
  speeds.push_back(double(norm(pose.velocity)) + std::abs(double(pose.angular_velocity)) * radius);
  return speeds;
}

double fastest_body(const Deck& deck) {
  double fastest = 0;
  for (const BodyDeck& body : deck.bodies) fastest = std::max(fastest, length(body.velocity));
  return fastest;
}

// Of all that is meant to move, bodies at their first velocity among it.
double slowest_of(const Deck& deck, std::vector<double> speeds) {
  for (const BodyDeck& body : deck.bodies) speeds.push_back(length(body.velocity));
  double slowest = std::numeric_limits<double>::infinity();
  for (const double speed : speeds)
    if (speed > 0) slowest = std::min(slowest, speed);
  return speeds.empty() || std::isinf(slowest) ? 0 : slowest;
}

double mass_of(const Scene& scene) {
  const auto of_particles = host_copy(scene.particles.points.mass), of_nodes = host_copy(scene.hexes.mass);
  double sum = 0;
  for (int i : particle_rows(scene.particles)) sum += double(of_particles(i));
  for (int a = 0; a < scene.hexes.nodes; ++a) sum += double(of_nodes(a));
  return sum;
}

} // namespace

Simulation::Simulation(const Deck& from)
    : deck(from), model(build_scene(from)), particle_method(particle_method_of(from)),
      hex_method(hex_method_of(from)), gravity(to_vector(from.run.gravity)), status("status"),
      hex_status("hex_status"), conducts(conducts_heat(from)), mass_factor(from.run.mass_factor) {
  if (deck.retire.distance) {
    first_position = VectorField("first_position", model.particles.stored);
    Kokkos::deep_copy(first_position, model.particles.position);
  }
  const std::vector<double> drives = driving_speeds_of(deck, model);
  driving_speed = drives.empty() ? 0 : *std::max_element(drives.begin(), drives.end());
  shift_speed = std::max(driving_speed, fastest_body(deck));
  slowest_drive = slowest_of(deck, drives);
  driven_energy = 0.5 * mass_factor * mass_of(model) * driving_speed * driving_speed;
  elastic_scale = elastic_scale_of(model.particles.points, model.materials) +
                  elastic_scale_of(model.hexes.points, model.materials);
  contact_law.friction = Real(deck.contact.friction);
  contact_law.shear_limit = Real(deck.contact.shear_limit.value_or(0));
  contact_law.stiffness = Real(deck.contact.stiffness);
  contact_law.heat_to_workpiece = Real(deck.contact.heat_to_workpiece.value_or(0.5));
  if (deck.contact.conductance) contact_law.heat_resistance = Real(1 / *deck.contact.conductance);
  tool_heat_step = double(stable_heat_step(model.tool.heat));
  lists.cutoff = Real(model.cutoff), lists.skin = Real(model.skin);
  initial_heat = double(sum_heats().work);
  loads = make_tool_load_sums(std::max(model.particles.count, model.hexes.nodes));
  Kokkos::deep_copy(status, no_fault), Kokkos::deep_copy(hex_status, no_fault);
}

// glibc keeps what building the scene has freed: a quarter of what the fields take.
void release_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

void Simulation::start() {
  timer.restart();
  convert();
  energy.lost_in_conversion = 0; // the run begins with what it has now
  rebuild_lists();
  if (meeting_due) follow_bodies();
  find_highest_mode(first_iterations);
  release_freed_memory();
  step_size = 0; // rates and forces of the initial state; nothing moves, no history is made
  follow_hexes_and_ghosts();
  update_rates_and_stresses();
  compute_forces();
  // The penalty stays as it is when the step changes, and does not wait for points that come or thaw.
  const double first_dt = deck.run.courant * double(limit_step().dt);
  contact_law.reference_step = Real(std::min(first_dt, step_of_new_particles()));
  if (deck.sleep.distance) freeze_at_start();
  steps = steps_at_sample = 0;
  check();
  energy.begin();
}

// What is frozen shows its neighbours what the forces have just prepared.
void Simulation::freeze_at_start() {
  kick_half(); // over no time: driven faces take up their speed, and stay active
  freeze();
  rebuild_lists();
  follow_hexes_and_ghosts();
  update_rates_and_stresses();
  compute_forces();
}

StableStep Simulation::limit_step() {
  const StableStep particle_limit =
      stable_step(model.particles, lists, model.materials, {particle_method, Real(wave_step)});
  StableStep hex_limit = stable_step(model.hexes, model.materials, hex_method);
  particle_step = double(particle_limit.dt);
  const bool hexes_limit =
      hex_limit.limiter >= 0 && (particle_limit.limiter < 0 || hex_limit.dt < particle_limit.dt);
  limiting_row = hexes_limit ? model.particles.total + hex_limit.limiter : particle_limit.limiter;
  step_limiter = fmt::format("{} {}", hexes_limit ? "hex" : "particle",
                             hexes_limit ? hex_limit.limiter : particle_limit.limiter);
  hex_limit.approach = particle_limit.approach;
  return hexes_limit ? hex_limit : particle_limit;
}

void Simulation::check() {
  timer.restart();
  check_status();
  if ((deck.tool || bodies_meet()) && !conducts)
    take_contact_heat(); // else conduct() does, before it moves on
  take_surface_sums();
  const StableStep limit = limit_step();
  if (limit.limiter < 0) fail("every hex that is active has failed, and no particle is");
  step_size = deck.run.courant * double(limit.dt);
  if (conducts)
    heat_step = double(std::min(stable_heat_step(model.particles, model.materials),
                                stable_heat_step(model.hexes, model.materials)));
  const bool lists_age = model.particles.count > 0 && !particle_method.initial_frame;
  const double room = 0.5 * (double(lists.skin) - double(limit.approach)); // of each of a pair
  if (lists_age && room < 0) fail(Fault::skin_exceeded, "");
  const int active = model.particles.count + model.particles.tied;
  if (energy.others_frozen)
    energy.frozen = sum_particles(model.particles, Real(mass_factor), active, model.particles.stored);
  energy.others_frozen = false;
  energy.particles = sum_particles(model.particles, Real(mass_factor), 0, active);
  energy.particles.add(energy.frozen);
  energy.hexes = sum_hexes(model.hexes, Real(mass_factor));
  const double speed = double(std::max(energy.particles.max_speed, energy.hexes.max_speed));
  if (driving_speed == 0 && fastest_body(deck) == 0) shift_speed = speed;
  const double whole = 0.5 * double(lists.skin);
  // A free flight may be faster than the waves: no step may use up the skin.
  if (lists_age && speed > 0) step_size = std::min(step_size, 0.9 * whole / speed);
  long interval = std::min<long>(deck.output.history_steps, most_unseen_steps);
  // Twice the present speed, or the tool's, is allowed for until the next look, and what gravity adds.
  const double fall = double(norm(gravity)) * step_size * double(interval);
  const double reach = 2 * (std::max(speed, driving_speed) + fall) * step_size;
  if (lists_age && reach * interval > 0.5 * whole) interval = std::max(1L, long(0.5 * whole / reach));
  if (bodies_meet()) interval = plan_body_contact(reach, interval);
  lists_due = lists_age && room < reach * double(interval);
  next_check = steps + interval;
  plan_freeze(speed);
  plan_conversion();
  timer.mark("checks");
}

HistorySample Simulation::take_sample() {
  timer.restart();
  HistorySample s;
  s.time = now, s.immersion = immersion_deg(), s.step = double(steps), s.dt = step_size;
  const ToolLoad load = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, loads.total)();
  energy.take_tool_work(load.work);
  energy.fill(s);
  const double taken = std::max(1.0, double(steps - steps_at_sample));
  const double scale = deck.output.force_scale / taken;
  s.force = {scale * load.force.x, scale * load.force.y, scale * load.force.z};
  s.torque = scale * load.moment.z;
  for (int k = 0; k < max_teeth; ++k)
    s.tooth_force[k] = {scale * load.tooth_force[k].x, scale * load.tooth_force[k].y,
                        scale * load.tooth_force[k].z};
  s.particles_in_contact = load.contacts / taken;
  book_heat(s);
  const PointSums &a = energy.particles, &b = energy.hexes;
  s.max_temperature = double(std::max(a.max_temperature, b.max_temperature));
  s.max_plastic_strain = double(std::max(a.max_plastic_strain, b.max_plastic_strain));
  s.max_velocity = double(std::max(a.max_speed, b.max_speed));
  Kokkos::deep_copy(loads.total, ToolLoad{});
  steps_at_sample = steps;
  timer.mark("samples");
  check_energy(s);
  return s;
}

// Counted from one temperature, so that small rises keep their digits in the sums.
HeatSums Simulation::sum_heats() const {
  const Real reference = Real(deck.bodies.front().temperature);
  HeatSums sums = sum_heat(model.particles, model.materials, reference);
  sums.add(sum_heat(model.hexes, model.materials, reference));
  sums.add(sum_heat(model.tool.heat));
  return sums;
}

// What a tool without a material is given is lost, and counts as its heat.
void Simulation::book_heat(HistorySample& s) const {
  const HeatSums sums = sum_heats();
  const double lost = model.tool.heat.cells > 0 ? 0 : 1 - double(contact_law.heat_to_workpiece);
  s.plastic_heat = double(sums.plastic), s.heat_out = double(sums.out);
  s.work_heat = double(sums.work) - initial_heat;
  s.tool_heat = double(sums.tool) - initial_tool_heat + lost * s.frictional;
  if (sums.hottest_cell >= 0) {
    const auto at = host_copy(model.tool.heat.centre);
    s.tool_hottest = double(sums.tool_hottest);
    for (int d = 0; d < 3; ++d) s.tool_hottest_at[std::size_t(d)] = double(at(sums.hottest_cell, d));
  }
  s.heat_residual = s.work_heat + s.tool_heat + s.heat_out - s.plastic_heat - s.frictional;
}

int Simulation::leaked_particles() const {
  if (!deck.tool || model.particles.count == 0) return 0;
  ContactPoints points = contact_points_of(model.particles);
  return count_points_inside(points, model.tool, pose(), Real(0.25 * model.spacing));
}

int Simulation::leaked_nodes() const {
  if (!deck.tool || model.hexes.nodes == 0) return 0;
  const double edge = model.hex_diagonal / std::sqrt(3.0);
  return count_points_inside(contact_points_of(model.hexes), model.tool, pose(), Real(0.25 * edge));
}

// Two steps of half the rest rather than one and a sliver.
void Simulation::cut_step(double end) {
  const double left = end - now;
  if (left <= step_size)
    step_size = left;
  else if (left < 2 * step_size)
    step_size = 0.5 * left;
  while (now + step_size > end && step_size > 0) step_size = std::nextafter(step_size, 0.0); // round-off
}

} // namespace swarf
