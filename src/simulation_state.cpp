// Everything about a Simulation that is not the step: construction, checks, samples, checkpoints.
#include "src/convert_hexes.hpp"
#include "src/simulation.hpp"
#include "src/write_hdf5.hpp"
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
  m.reconstruct_viscosity = deck.particles.viscosity_form == "reconstructed";
  m.viscosity_linear = Real(deck.particles.viscosity_linear);
  m.viscosity_quadratic = Real(deck.particles.viscosity_quadratic);
  m.hourglass_viscosity = Real(deck.particles.hourglass_viscosity);
  m.hourglass_stiffness = Real(deck.particles.hourglass_stiffness);
  m.artificial_stress = Real(deck.particles.artificial_stress);
  m.artificial_stress_exponent = int(std::lround(deck.particles.artificial_stress_exponent));
  m.spacing_ratio = Real(1 / deck.particles.smoothing_ratio);
  m.mass_factor = Real(deck.run.mass_factor);
  m.initial_frame = deck.particles.kernel_frame == "initial";
  return m;
}

HexMethod hex_method_of(const Deck& deck) {
  HexMethod m;
  m.hourglass = deck.hexes.hourglass == "viscous" ? HourglassControl::viscous : HourglassControl::stiffness;
  m.hourglass_coefficient = Real(deck.hexes.hourglass_coefficient);
  m.viscosity_linear = Real(deck.hexes.viscosity_linear);
  m.viscosity_quadratic = Real(deck.hexes.viscosity_quadratic);
  m.delete_failed = deck.hexes.delete_failed;
  m.delete_at_strain = Real(deck.hexes.delete_at_strain.value_or(0));
  m.mass_factor = Real(deck.run.mass_factor);
  return m;
}

// Rows that a checkpoint keeps: images are made again.
template <class Field>
Field first_rows(const Field& field, int rows) {
  if (int(field.extent(0)) <= rows) return field;
  Field copy = Kokkos::create_mirror(ExecSpace::memory_space{}, field);
  Kokkos::deep_copy(copy, field);
  Kokkos::resize(copy, rows);
  return copy;
}

// glibc keeps what building the scene has freed: a quarter of what the fields take.
void release_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
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

// Of all that is meant to move, bodies at their first velocity among it.
double slowest_of(const Deck& deck, std::vector<double> speeds) {
  for (const BodyDeck& body : deck.bodies) speeds.push_back(length(body.velocity));
  double slowest = std::numeric_limits<double>::infinity();
  for (const double speed : speeds)
    if (speed > 0) slowest = std::min(slowest, speed);
  return speeds.empty() || std::isinf(slowest) ? 0 : slowest;
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
  slowest_drive = slowest_of(deck, drives);
  elastic_scale = elastic_scale_of(model.particles.points, model.materials) +
                  elastic_scale_of(model.hexes.points, model.materials);
  contact_law.friction = Real(deck.contact.friction);
  contact_law.shear_limit = Real(deck.contact.shear_limit.value_or(0));
  contact_law.stiffness = Real(deck.contact.stiffness);
  contact_law.heat_to_workpiece = Real(deck.contact.heat_to_workpiece);
  lists.cutoff = Real(model.cutoff), lists.skin = Real(model.skin);
  loads = make_tool_load_sums(std::max(model.particles.count, model.hexes.nodes));
  Kokkos::deep_copy(status, no_fault), Kokkos::deep_copy(hex_status, no_fault);
}

void Simulation::start() {
  timer.restart();
  convert();
  lost_in_conversion = 0; // the run begins with what it has now
  rebuild_lists();
  release_freed_memory();
  step_size = 0; // rates and forces of the initial state; nothing moves, no history is made
  follow_hexes_and_images();
  update_rates_and_stresses();
  compute_forces();
  if (deck.sleep.distance) fall_asleep();
  steps = steps_at_sample = 0;
  check();
  // The penalty stays as it is when the step changes, and does not wait for particles that come.
  contact_law.reference_step = Real(std::min(step_size, step_of_new_particles()));
  // Less what was given up by points that fell asleep at once.
  initial_energy =
      double(of_particles.kinetic) + of_hexes.kinetic - of_particles.external - of_hexes.external;
}

// What sleeps shows its neighbours what the forces have just prepared.
void Simulation::fall_asleep() {
  kick_half(); // over no time: driven faces take up their speed, and stay awake
  rest();
  rebuild_lists();
  follow_hexes_and_images();
  update_rates_and_stresses();
  compute_forces();
}

StableStep Simulation::limit_step() {
  const StableStep particle_limit = stable_step(model.particles, lists, model.materials, particle_method);
  StableStep hex_limit = stable_step(model.hexes, model.materials, hex_method);
  particle_step = double(particle_limit.dt);
  const bool hexes_limit =
      hex_limit.limiter >= 0 && (particle_limit.limiter < 0 || hex_limit.dt < particle_limit.dt);
  step_limiter = fmt::format("{} {}", hexes_limit ? "hex" : "particle",
                             hexes_limit ? hex_limit.limiter : particle_limit.limiter);
  hex_limit.max_displacement = particle_limit.max_displacement;
  return hexes_limit ? hex_limit : particle_limit;
}

void Simulation::check() {
  timer.restart();
  check_status();
  const StableStep limit = limit_step();
  step_size = deck.run.courant * double(limit.dt);
  if (conducts)
    heat_step = double(std::min(stable_heat_step(model.particles, model.materials),
                                stable_heat_step(model.hexes, model.materials)));
  const bool lists_age = model.particles.count > 0 && !particle_method.initial_frame;
  const double room = 0.5 * double(lists.skin) - double(limit.max_displacement);
  if (lists_age && room < 0) fail(Fault::skin_exceeded, "");
  of_particles = sum_particles(model.particles, Real(mass_factor));
  of_hexes = sum_hexes(model.hexes, Real(mass_factor));
  const double speed = double(std::max(of_particles.max_speed, of_hexes.max_speed));
  // Twice the present speed, or the tool's, is allowed for until the next look.
  const double reach = 2 * std::max(speed, driving_speed) * step_size;
  const double whole = 0.5 * double(lists.skin);
  long interval = std::min<long>(deck.output.history_steps, most_unseen_steps);
  if (lists_age && reach * interval > 0.5 * whole) interval = std::max(1L, long(0.5 * whole / reach));
  lists_due = lists_age && room < reach * double(interval);
  next_check = steps + interval;
  plan_rest(speed);
  plan_conversion();
  timer.mark("checks");
}

HistorySample Simulation::sample() {
  timer.restart();
  const PointSums &a = of_particles, &b = of_hexes;
  HistorySample s;
  s.time = now, s.immersion = immersion_deg(), s.step = double(steps), s.dt = step_size;
  s.kinetic = double(a.kinetic) + b.kinetic;
  s.plastic = double(a.plastic) + b.plastic;
  s.elastic = double(a.internal) + b.internal - s.plastic;
  s.frictional = double(a.friction) + b.friction;
  s.viscous = double(a.viscous) + b.viscous;
  s.hourglass = double(a.hourglass) + b.hourglass;
  s.contact = double(a.contact) + b.contact;
  s.tie = lost_in_conversion;
  const ToolLoad load = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, loads.total)();
  tool_work += load.work;
  s.external = double(a.external) + b.external + tool_work;
  s.residual = s.kinetic + s.elastic + s.plastic + s.frictional + s.viscous + s.hourglass + s.contact +
               s.tie - initial_energy - s.external;
  const double taken = std::max(1.0, double(steps - steps_at_sample));
  const double scale = deck.output.force_scale / taken;
  s.force = {scale * load.force.x, scale * load.force.y, scale * load.force.z};
  s.torque = scale * load.moment.z;
  for (int k = 0; k < max_teeth; ++k)
    s.tooth_force[k] = {scale * load.tooth_force[k].x, scale * load.tooth_force[k].y,
                        scale * load.tooth_force[k].z};
  s.particles_in_contact = load.contacts / taken;
  s.max_temperature = double(std::max(a.max_temperature, b.max_temperature));
  s.max_plastic_strain = double(std::max(a.max_plastic_strain, b.max_plastic_strain));
  s.max_velocity = double(std::max(a.max_speed, b.max_speed));
  Kokkos::deep_copy(loads.total, ToolLoad{});
  steps_at_sample = steps;
  timer.mark("samples");
  check_energy(s);
  return s;
}

int Simulation::leaked_particles() const {
  if (!deck.tool || model.particles.count == 0) return 0;
  ContactPoints points = contact_points_of(model.particles);
  return count_points_inside(points, model.tool, pose(), Real(0.25 * model.spacing));
}

void Simulation::write_state(CheckpointWriter& out) const {
  Particles p = model.particles; // Views: shallow
  HexMesh m = model.hexes;
  const int rows = p.stored;
  out.put("awake", p.count), out.put("awake_tied", p.tied), out.put("listed", p.listed);
  out.put("rested_at", rested_at), out.put("rest_due", int(rest_due));
  if (deck.sleep.distance)
    p.for_each_pair_field(
        [&](const std::string& name, auto& field) { out.put("particles/" + name, first_rows(field, rows)); });
  p.for_each_field(
      [&](const std::string& name, auto& field) { out.put("particles/" + name, first_rows(field, rows)); });
  m.for_each_field([&](const std::string& name, auto& field) { out.put("hexes/" + name, field); });
  out.put("lists/build_position", first_rows(lists.build_position, rows));
  const ToolLoad load = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, loads.total)();
  const Real* values = reinterpret_cast<const Real*>(&load);
  out.put("tool_load", std::vector<Real>(values, values + sizeof(ToolLoad) / sizeof(Real)));
  out.put("time", now), out.put("step_size", step_size), out.put("steps", steps);
  out.put("reference_step", contact_law.reference_step), out.put("next_check", next_check),
      out.put("rebuild_count", rebuild_count);
  out.put("particle_step", particle_step), out.put("pressure_time", pressure_time);
  out.put("heat_step", heat_step), out.put("heat_time", heat_time);
  out.put("steps_at_sample", steps_at_sample), out.put("lists_due", int(lists_due));
  out.put("status", value_of(status)), out.put("hex_status", value_of(hex_status));
  out.put("initial_energy", initial_energy), out.put("tool_work", tool_work);
  if (!model.conversion) return;
  out.put("conversion_due", int(conversion_due)), out.put("looked_at", looked_at);
  out.put("lost_in_conversion", lost_in_conversion);
}

void Simulation::read_state(const CheckpointReader& in) {
  Particles& p = model.particles;
  const auto read = [&](const std::string& name, auto& field) {
    auto stored = std::decay_t<decltype(field)>();
    in.get(name, stored);
    if (stored.extent(0) > 0) Kokkos::deep_copy(field, stored);
  };
  in.get("awake", p.count), in.get("awake_tied", p.tied), in.get("listed", p.listed);
  p.points.count = p.count + p.tied;
  if (model.conversion) { // its fields take other rows than at the start
    in.get("hexes/active", model.hexes.active);
    restore_conversion(deck, model, {p.count, p.tied});
    ensure_rows(loads.blocks, std::size_t(p.count / ToolLoadSums::block + 1));
    int due = 0;
    in.get("conversion_due", due), in.get("looked_at", looked_at);
    in.get("lost_in_conversion", lost_in_conversion);
    conversion_due = due != 0;
  }
  in.get("rested_at", rested_at);
  int rests = 0;
  in.get("rest_due", rests);
  rest_due = rests != 0;
  if (deck.sleep.distance)
    p.for_each_pair_field([&](const std::string& name, auto& field) { read("particles/" + name, field); });
  // The lists are made again from the positions at which they were made, so that every sum keeps its order.
  p.for_each_field([&](const std::string& name, auto& field) { read("particles/" + name, field); });
  model.hexes.for_each_field([&](const std::string& name, auto& field) { read("hexes/" + name, field); });
  VectorField built;
  in.get("lists/build_position", built);
  Kokkos::deep_copy(p.position, built);
  make_images(p, lists, model.image_planes);
  find_neighbors(lists, p);
  release_freed_memory();
  VectorField current;
  in.get("particles/position", current);
  find_tied_rows(model.tie, p);
  const auto rows = std::make_pair(0, p.stored);
  Kokkos::deep_copy(Kokkos::subview(p.position, rows, Kokkos::ALL), current);

  std::vector<Real> values;
  in.get("tool_load", values);
  ToolLoad load;
  std::copy(values.begin(), values.end(), reinterpret_cast<Real*>(&load));
  Kokkos::deep_copy(loads.total, load);
  in.get("time", now), in.get("step_size", step_size), in.get("steps", steps);
  in.get("next_check", next_check), in.get("rebuild_count", rebuild_count);
  in.get("particle_step", particle_step), in.get("pressure_time", pressure_time);
  in.get("heat_step", heat_step), in.get("heat_time", heat_time);
  in.get("steps_at_sample", steps_at_sample), in.get("reference_step", contact_law.reference_step);
  first_step = steps;
  int due = 0;
  in.get("lists_due", due);
  lists_due = due != 0;
  unsigned long long seen = no_fault; // of steps since the last check
  in.get("status", seen), Kokkos::deep_copy(status, seen);
  in.get("hex_status", seen), Kokkos::deep_copy(hex_status, seen);
  in.get("initial_energy", initial_energy), in.get("tool_work", tool_work);
}

} // namespace swarf
