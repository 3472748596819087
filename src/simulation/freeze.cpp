// What of the model is frozen, and when that is looked at again.
#include "src/simulation/simulation.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace swarf {
namespace {

// Of all materials, with the scaled mass.
double fastest_wave(const MaterialTable& table, double mass_factor) {
  const auto materials = host_copy(table);
  double fastest = 0;
  for (std::size_t m = 0; m < materials.extent(0); ++m)
    fastest = std::max(fastest, double(longitudinal_wave_speed(materials(m)))); // 0 of a rigid one
  return fastest / std::sqrt(mass_factor);
}

// Shifts by less than a thousandth of a cell, turns of the axes by less than a thousandth of their length.
bool are_equal(const Transform& a, const Transform& b, double cell) {
  bool equal = double(norm(a.t - b.t)) < 1e-3 * cell;
  for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}})
    equal = equal && double(norm(multiply(a.R, axis) - multiply(b.R, axis))) < 1e-3;
  return equal;
}

// To where periodic faces repeat a point, and mirrors show it: the maps of each pair of faces, and what they
// make of the images of the pairs before. Particles and nodes may have the same pair.
std::vector<Transform> image_maps(const Scene& scene) {
  std::vector<std::vector<Transform>> pairs;
  for (std::size_t k = 0; k < scene.ghost_planes.size(); ++k) {
    if (k % 2 == 0) pairs.emplace_back();
    if (scene.ghost_planes[k].active) pairs.back().push_back(scene.ghost_planes[k].to_ghost);
  }
  const double cell = scene.spacing > 0 ? scene.spacing : scene.hex_diagonal;
  const auto of_nodes = host_copy(scene.node_transforms);
  for (std::size_t k = 0; k < of_nodes.extent(0); ++k) {
    const Transform map = of_nodes(k);
    const bool known = std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
      return std::any_of(pair.begin(), pair.end(),
                         [&](const Transform& m) { return are_equal(m, map, cell); });
    });
    if (!known) pairs.push_back({map, inverse(map)});
  }
  std::vector<Transform> maps;
  for (const auto& pair : pairs) {
    const std::vector<Transform> before = maps;
    for (const Transform& map : pair) {
      maps.push_back(map);
      for (const Transform& first : before) maps.push_back(compose(map, first));
    }
  }
  return maps;
}

} // namespace

// Motion is felt as far as a kernel's support; and in a hex a tied particle moves though it lies farther than
// the nodes that move.
Freeze Simulation::freeze_of() const {
  Freeze s;
  s.distance = Real(*deck.sleep.distance);
  s.ramp = Real(deck.sleep.ramp) * s.distance;
  s.margin = Real(model.cutoff + model.hex_diagonal), s.reach = Real(model.cutoff);
  // Waves of up to 0.6 ramps come back with less than 2 %; longer ones meet a fixed support
  // (tests/src/test_freeze.cpp).
  s.damping = Real(16 * fastest_wave(model.materials, mass_factor)) / s.ramp;
  s.speed = Real(deck.sleep.speed * slowest_drive);
  s.cell = s.distance / 16;
  s.near = model.tool.reach / 2;
  s.mass_factor = Real(mass_factor);
  return s;
}

// Before what is left is frozen: a chip that has gone is not of the active region.
void Simulation::retire() {
  Retire r;
  r.distance = Real(*deck.retire.distance), r.reach = Real(model.spacing);
  r.elapsed = Real(now - freezing.looked_at), r.first_position = first_position;
  const ToolAt tool{model.tool, pose()};
  const VectorField work = with_images(find_work(model.particles, model.hexes, tool, r), image_maps(model));
  retire_particles(model.particles, work, tool, r);
}

void Simulation::freeze() {
  Freeze freeze_limits = freeze_of();
  if (deck.retire.distance) retire();
  const ToolAt tool{model.tool, pose()};
  VectorField region = find_active_region(model.particles, model.hexes, tool, freeze_limits);
  if (region.extent(0) == 0) { // the tool is still on its way: where it is nearest, if it is near at all
    freeze_limits.near = model.tool.reach;
    region = find_active_region(model.particles, model.hexes, tool, freeze_limits);
  }
  region = with_images(region, image_maps(model));
  freeze_particles(model.particles, model.tie, region, freeze_limits);
  find_held_rows(model.held_rows, model.particles);
  freeze_hexes(model.hexes, model.node_transforms, region, freeze_limits);
  freezing.looked(now), energy.others_frozen = true;
  next_check = std::min(next_check, steps + 1); // what thaws may ask for a shorter step
  timer.mark("freeze");
}

// Until the active region is looked for again the tool may travel a quarter of what is near to it, the rest
// being for the gap at which it touches; and what moves fastest, a fragment then, a quarter of the distance
// to which all around it is active. Without a tool a wave runs ahead of the points that it moves: these may
// go as far as the active region is known to. What has retired is looked for a spacing around.
void Simulation::plan_freeze(double speed) {
  if (!deck.sleep.distance) return;
  const Freeze s = freeze_of();
  const bool has_tool = model.tool.facets > 0;
  double way = has_tool ? 0.25 * double(s.distance) : double(s.cell);
  if (model.spacing > 0 && (deck.retire.distance || !has_tool)) way = std::min(way, model.spacing);
  const double tool_way = has_tool ? 0.25 * double(s.near) : std::numeric_limits<double>::infinity();
  freezing.plan(now - freezing.looked_at + step_size * double(next_check - steps), {driving_speed, speed},
                {tool_way, way});
  lists_due = lists_due || (freezing.due && model.particles.stored > 0);
}

void Simulation::fade_waves() {
  const Real dt = Real(step_size);
  absorb_waves(motion_of(model.particles), model.particles.damping, Real(mass_factor), dt);
  absorb_waves(motion_of(model.hexes), model.hexes.damping, Real(mass_factor), dt);
}

} // namespace swarf
