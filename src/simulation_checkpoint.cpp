// What a checkpoint keeps of a Simulation.
#include "src/convert_hexes.hpp"
#include "src/simulation.hpp"
#include "src/write_hdf5.hpp"
#include <algorithm>

namespace swarf {
namespace {

// Sleeping rows keep what the others make again.
bool is_kept(Life life, const Deck& deck) {
  return life == Life::history || (life == Life::pair && deck.sleep.distance);
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

} // namespace

void Simulation::write_state(CheckpointWriter& out) const {
  const Particles& p = model.particles;
  const int rows = p.stored;
  out.put("awake", p.count), out.put("awake_tied", p.tied), out.put("listed", p.listed);
  out.put("rested_at", rested_at), out.put("rest_due", int(rest_due));
  for_each_field(p, [&](const std::string& name, const auto& field, auto facts) {
    if (is_kept(facts.life, deck)) out.put("particles/" + name, first_rows(field, rows));
  });
  for_each_field(model.hexes, [&](const std::string& name, const auto& field, auto facts) {
    if (facts.life == Life::history) out.put("hexes/" + name, field);
  });
  if (model.tool.heat.cells > 0)
    out.put("tool/temperature", model.tool.heat.temperature), out.put("tool/out", model.tool.heat.out);
  out.put("lists/build_position", first_rows(lists.build_position, rows));
  const ToolLoad load = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, loads.total)();
  const Real* values = reinterpret_cast<const Real*>(&load);
  out.put("tool_load", std::vector<Real>(values, values + sizeof(ToolLoad) / sizeof(Real)));
  out.put("time", now), out.put("step_size", step_size), out.put("steps", steps);
  out.put("reference_step", contact_law.reference_step), out.put("next_check", next_check),
      out.put("rebuild_count", rebuild_count);
  out.put("particle_step", particle_step), out.put("pressure_time", pressure_time);
  out.put("heat_step", heat_step), out.put("heat_time", heat_time);
  out.put("shift_speed", shift_speed), out.put("way_since_shift", way_since_shift);
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
  // The lists are made again from the positions at which they were made, so that every sum keeps its order.
  for_each_field(p, [&](const std::string& name, auto& field, auto facts) {
    if (is_kept(facts.life, deck)) read("particles/" + name, field);
  });
  for_each_field(model.hexes, [&](const std::string& name, auto& field, auto facts) {
    if (facts.life == Life::history) read("hexes/" + name, field);
  });
  if (model.tool.heat.cells > 0)
    read("tool/temperature", model.tool.heat.temperature), read("tool/out", model.tool.heat.out);
  VectorField built;
  in.get("lists/build_position", built);
  Kokkos::deep_copy(p.position, built);
  make_images(p, lists, model.image_planes);
  find_neighbors(lists, p);
  release_freed_memory();
  VectorField current;
  in.get("particles/position", current);
  find_tied_rows(model.tie, p);
  find_held_rows(model.held_rows, p);
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
  in.get("shift_speed", shift_speed), in.get("way_since_shift", way_since_shift);
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
