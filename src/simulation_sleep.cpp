// What of the model sleeps, and when that is looked at again.
#include "src/simulation.hpp"
#include "swarf/retire.hpp"
#include <algorithm>
#include <cmath>

namespace swarf {
namespace {

// Of all materials, with the scaled mass.
double fastest_wave(const MaterialTable& table, double mass_factor) {
  const auto materials = host_copy(table);
  double fastest = 0;
  for (std::size_t m = 0; m < materials.extent(0); ++m)
    fastest = std::max(fastest, double(longitudinal_wave_speed(materials(m))));
  return fastest / std::sqrt(mass_factor);
}

// To where periodic faces repeat a point, and mirrors show it.
std::vector<Transform> image_maps(const Scene& scene) {
  std::vector<Transform> maps;
  for (const ImagePlane& plane : scene.image_planes)
    if (plane.active) maps.push_back(plane.to_image);
  const auto of_nodes = host_copy(scene.node_transforms);
  for (std::size_t k = 0; k < of_nodes.extent(0); ++k) {
    const Tensor3 back = transpose(of_nodes(k).R);
    maps.push_back(of_nodes(k));
    maps.push_back({back, Real(-1) * multiply(back, of_nodes(k).t)});
  }
  return maps;
}

} // namespace

// Held points reach as far as the motion of a moving one is felt: a kernel's support, and a hex, in which a
// tied particle moves though it lies farther than the nodes that move.
Sleep Simulation::sleep_of() const {
  Sleep s;
  s.distance = Real(*deck.sleep.distance);
  s.ramp = Real(deck.sleep.ramp) * s.distance;
  s.margin = Real(model.cutoff + model.hex_diagonal), s.reach = Real(model.cutoff);
  // Waves of up to 0.6 ramps come back with less than 2 %; longer ones meet a fixed support
  // (tests/src/test_sleep.cpp).
  s.damping = Real(16 * fastest_wave(model.materials, mass_factor)) / s.ramp;
  s.speed = Real(deck.sleep.speed * slowest_drive);
  s.cell = s.distance / 16;
  s.mass_factor = Real(mass_factor);
  return s;
}

// Before what is left is put to sleep: a chip that has gone is no action.
void Simulation::retire() {
  Retire r;
  r.distance = Real(*deck.retire.distance), r.reach = Real(model.spacing);
  r.elapsed = Real(now - rested_at), r.first_position = first_position;
  const ToolAt tool{model.tool, pose()};
  const VectorField work = with_images(find_work(model.particles, model.hexes, tool, r), image_maps(model));
  retire_particles(model.particles, work, tool, r);
}

void Simulation::rest() {
  const Sleep sleep = sleep_of();
  if (deck.retire.distance) retire();
  const VectorField action =
      with_images(find_action(model.particles, model.hexes, {model.tool, pose()}, sleep), image_maps(model));
  rest_particles(model.particles, model.tie, action, sleep);
  rest_hexes(model.hexes, model.node_transforms, action, sleep);
  rest_due = false, rested_at = now;
  next_check = std::min(next_check, steps + 1); // what wakes may ask for a shorter step
  timer.mark("sleep");
}

// The tool, or what moves fastest, may travel half a cell before the action is looked for again: what is
// nearer than two cells is found.
void Simulation::plan_rest(double speed) {
  if (!deck.sleep.distance) return;
  const double cell = model.spacing > 0 ? model.spacing : model.hex_diagonal / std::sqrt(3.0);
  rest_due = std::max(speed, driving_speed) * (now - rested_at) >= 0.5 * cell;
  lists_due = lists_due || (rest_due && model.particles.stored > 0);
}

void Simulation::fade_waves() {
  const Real dt = Real(step_size);
  absorb_waves(motion_of(model.particles), model.particles.damping, Real(mass_factor), dt);
  absorb_waves(motion_of(model.hexes), model.hexes.damping, Real(mass_factor), dt);
}

} // namespace swarf
