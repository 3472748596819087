// What a checkpoint keeps of a Simulation.
#include "src/output/write_hdf5.hpp"
#include "src/scene/convert_hexes.hpp"
#include "src/simulation/checkpoint_checks.hpp"
#include "src/simulation/simulation.hpp"
#include "swarf/region/freeze.hpp"
#include "swarf/region/retire.hpp"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace swarf {
namespace {

// Frozen rows keep what the others make again.
bool is_kept(Life life, const Deck& deck) {
  return life == Life::history || (life == Life::pair && deck.sleep.distance);
}

// Rows that a checkpoint keeps: ghosts are made again.
template <class Field>
Field first_rows(const Field& field, int rows) {
  if (int(field.extent(0)) <= rows) return field;
  Field copy = Kokkos::create_mirror(ExecSpace::memory_space{}, field);
  Kokkos::deep_copy(copy, field);
  Kokkos::resize(copy, rows);
  return copy;
}

template <class Field>
bool all_within(const Field& field, int rows, long least, long most) {
  const auto values = host_copy(field);
  for (int i = 0; i < std::min(rows, int(values.extent(0))); ++i)
    if (long(values(i)) < least || long(values(i)) > most) return false;
  return true;
}

// A number for each row, and none twice.
bool is_permutation(const IndexField& field, int rows) {
  const auto values = host_copy(field);
  std::vector<bool> seen(std::size_t(rows), false);
  for (int i = 0; i < rows; ++i) {
    if (values(i) < 0 || values(i) >= rows || seen[std::size_t(values(i))]) return false;
    seen[std::size_t(values(i))] = true;
  }
  return true;
}

// What indexes something must stay within it, before anything is indexed by it.
void check_indices(const CheckpointReader& in, const Scene& scene, const Deck& deck) {
  const Particles& p = scene.particles;
  const HexMesh& m = scene.hexes;
  const int materials = int(deck.materials.size()) - 1, bodies = int(deck.bodies.size()) - 1;
  const unsigned holds = (1u << std::min<std::size_t>(scene.constraints.extent(0), 28)) - 1;
  const auto bits_are_known = [&](const View<unsigned*>& field, int rows) {
    const auto bits = host_copy(field);
    for (int i = 0; i < rows; ++i)
      if ((bits(i) & ~(holds | held_bit | retired_bit | met_bit | follows_bit)) != 0) return false;
    return true;
  };
  in.require(is_permutation(p.identity, p.stored), "particles/identity");
  in.require(all_within(p.body, p.stored, 0, bodies), "particles/body");
  in.require(all_within(p.points.material, p.stored, 0, materials), "particles/material");
  in.require(all_within(m.points.material, m.points.count, 0, materials), "hexes/material");
  const int cells = scene.tool.heat.cells; // without any, there are no rows
  in.require(all_within(p.tool_cell, int(p.tool_cell.extent(0)), 0, cells - 1), "particles/tool_cell");
  in.require(all_within(m.tool_cell, int(m.tool_cell.extent(0)), 0, cells - 1), "hexes/tool_cell");
  const int patches = scene.tool.surface.patches;
  in.require(all_within(p.tool_patch, int(p.tool_patch.extent(0)), 0, patches - 1), "particles/tool_patch");
  in.require(all_within(m.tool_patch, int(m.tool_patch.extent(0)), 0, patches - 1), "hexes/tool_patch");
  in.require(all_within(m.active, m.points.count, 0, 2), "hexes/active");
  in.require(bits_are_known(p.constraints, p.stored), "particles/constraints");
  if (p.heated_faces.extent(0) > 0) {
    const auto bits = host_copy(p.heated_faces);
    const std::size_t faces = scene.heated_faces.extent(0); // 32 at most
    bool known = true;
    for (int i = 0; i < p.stored; ++i) known = known && (std::uint64_t(bits(i)) >> faces) == 0;
    in.require(known, "particles/heated_faces");
  }
  in.require(bits_are_known(m.constraints, m.nodes), "hexes/constraints");
}

} // namespace

template <class Self, class Visit>
void Simulation::visit_state(Self& s, const Visit& visit) {
  visit("time", s.now), visit("step_size", s.step_size), visit("steps", s.steps);
  visit("next_check", s.next_check), visit("rebuild_count", s.rebuild_count), visit("lists_due", s.lists_due);
  visit("steps_at_sample", s.steps_at_sample), visit("reference_step", s.contact_law.reference_step);
  visit("particle_step", s.particle_step), visit("wave_step", s.wave_step);
  visit("mode_interval", s.mode_interval), visit("next_mode", s.next_mode);
  visit("pressure_time", s.pressure_pace.waited);
  visit("heat_step", s.heat_step), visit("heat_time", s.heat_pace.waited);
  visit("shift_speed", s.shift_speed), visit("way_since_shift", s.way_since_shift);
  visit("freeze_due", s.freezing.due), visit("frozen_at", s.freezing.looked_at);
  visit("initial_energy", s.energy.initial), visit("tool_work", s.energy.tool_work);
  visit("initial_tool_heat", s.initial_tool_heat);
  if (s.deck.tool) visit("shown_since", s.shown_since);
  if (!s.model.conversion) return;
  visit("conversion_due", s.conversion.due), visit("looked_at", s.conversion.looked_at);
  visit("lost_in_conversion", s.energy.lost_in_conversion);
}

void Simulation::write_state(CheckpointWriter& out) const {
  visit_state(*this, [&](const char* name, const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, bool>)
      out.put(name, int(value));
    else
      out.put(name, value);
  });
  const Particles& p = model.particles;
  const int rows = p.stored;
  out.put("active", p.count), out.put("active_tied", p.tied), out.put("listed", p.listed);
  for_each_field(p, [&](const std::string& name, const auto& field, auto facts) {
    if (is_kept(facts.life, deck)) out.put("particles/" + name, first_rows(field, rows));
  });
  for_each_field(model.hexes, [&](const std::string& name, const auto& field, auto facts) {
    if (facts.life == Life::history) out.put("hexes/" + name, field);
  });
  if (model.tool.heat.cells > 0)
    out.put("tool/temperature", model.tool.heat.temperature), out.put("tool/out", model.tool.heat.out);
  if (deck.tool) {
    out.put("tool/surface", model.tool.surface.sums);
    out.put("patch_end", model.patch_end);
  }
  out.put("lists/build_position", first_rows(lists.build_position, rows));
  if (bodies_meet()) write_body_contact(out);
  const ToolLoad load = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, loads.total)();
  const Real* values = reinterpret_cast<const Real*>(&load);
  out.put("tool_load", std::vector<Real>(values, values + sizeof(ToolLoad) / sizeof(Real)));
  out.put("status", value_of(status)), out.put("hex_status", value_of(hex_status));
}

void Simulation::read_state(const CheckpointReader& in) {
  Particles& p = model.particles;
  const auto read = [&](const std::string& name, auto& field, int rows) {
    auto stored = std::decay_t<decltype(field)>();
    in.get(name, stored, std::min(field.extent(0), std::size_t(rows)));
    if (stored.extent(0) > 0) Kokkos::deep_copy(field, stored);
  };
  int active = 0, tied = 0, listed = 0;
  in.get("active", active), in.get("active_tied", tied), in.get("listed", listed);
  const int most = model.conversion ? std::numeric_limits<int>::max() / 2 : p.stored;
  in.require(active >= 0 && active <= most, "active"),
      in.require(tied >= 0 && tied <= most - active, "active_tied");
  in.require(listed >= active + tied && listed <= most, "listed");
  if (model.conversion) { // its fields take other rows than at the start
    in.get("hexes/active", model.hexes.active, std::uint64_t(model.hexes.points.count));
    in.require(all_within(model.hexes.active, model.hexes.points.count, 0, 2), "hexes/active");
    in.require(restore_conversion(deck, model, {active, tied}), "hexes/active");
    ensure_rows(loads.blocks, std::size_t(p.count / ToolLoadSums::block + 1));
  }
  p.count = active, p.tied = tied, p.listed = listed, p.points.count = active + tied;
  in.require(listed <= p.stored, "listed");
  // The lists are made again from the positions at which they were made, so that every sum keeps its order.
  for_each_field(p, [&](const std::string& name, auto& field, auto facts) {
    if (is_kept(facts.life, deck)) read("particles/" + name, field, p.stored);
  });
  for_each_field(model.hexes, [&](const std::string& name, auto& field, auto facts) {
    if (facts.life == Life::history) read("hexes/" + name, field, int(field.extent(0)));
  });
  if (model.tool.heat.cells > 0) {
    const int cells = model.tool.heat.cells;
    read("tool/temperature", model.tool.heat.temperature, cells),
        read("tool/out", model.tool.heat.out, cells);
  }
  if (deck.tool) {
    double end = 0;
    in.get("patch_end", end);
    in.require(end > 0 && std::isfinite(end), "patch_end");
    if (end != model.patch_end) make_patches(deck, model, end);
    read("tool/surface", model.tool.surface.sums, model.tool.surface.patches);
  }
  check_indices(in, model, deck);
  VectorField built;
  in.get("lists/build_position", built, std::uint64_t(p.stored));
  in.require(is_finite(built), "lists/build_position");
  Kokkos::deep_copy(p.position, built);
  make_ghosts(p, lists, model.ghost_planes);
  find_neighbors(lists, p);
  release_freed_memory();
  VectorField current;
  in.get("particles/position", current, std::uint64_t(p.stored));
  find_tied_rows(model.tie, p);
  find_held_rows(model.held_rows, p);
  if (bodies_meet()) read_body_contact(in);
  const auto rows = std::make_pair(0, p.stored);
  Kokkos::deep_copy(Kokkos::subview(p.position, rows, Kokkos::ALL), current);

  std::vector<Real> values;
  in.get("tool_load", values, sizeof(ToolLoad) / sizeof(Real));
  ToolLoad load;
  std::copy(values.begin(), values.end(), reinterpret_cast<Real*>(&load));
  Kokkos::deep_copy(loads.total, load);
  visit_state(*this, [&](const char* name, auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, bool>) {
      int written = 0;
      in.get(name, written);
      value = written != 0;
    } else {
      in.get(name, value);
    }
  });
  check_numbers(in);
  first_step = steps;
  unsigned long long seen = no_fault; // of steps since the last check
  in.get("status", seen), Kokkos::deep_copy(status, seen);
  in.get("hex_status", seen), Kokkos::deep_copy(hex_status, seen);
}

// Of a run that failed the state may hold anything; what counts or divides may not.
void Simulation::check_numbers(const CheckpointReader& in) const {
  const auto is_time = [](double t) { return std::isfinite(t) && t >= 0; };
  in.require(is_time(now), "time"), in.require(is_time(step_size), "step_size");
  in.require(steps >= 0, "steps"), in.require(rebuild_count >= 0, "rebuild_count");
  in.require(next_check >= steps && next_check <= steps + most_unseen_steps, "next_check");
  in.require(steps_at_sample >= 0 && steps_at_sample <= steps, "steps_at_sample");
  in.require(particle_step >= 0, "particle_step"),
      in.require(wave_step >= 0, "wave_step"); // infinity: no limit
  in.require(mode_interval >= 1 && mode_interval <= most_steps_between_modes, "mode_interval");
  in.require(next_mode >= 0 && next_mode <= steps + mode_interval, "next_mode");
  in.require(is_time(pressure_pace.waited), "pressure_time");
  in.require(is_time(shown_since) && shown_since <= now, "shown_since");
  in.require(std::isfinite(initial_tool_heat), "initial_tool_heat");
  in.require(is_time(heat_pace.waited), "heat_time"), in.require(heat_step >= 0, "heat_step");
  in.require(!conducts || heat_pace.waited <= 1e6 * heat_step, "heat_step");
  in.require(double(contact_law.reference_step) >= 0, "reference_step");
}

} // namespace swarf
