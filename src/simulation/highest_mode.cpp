// The stable step of the particles as they lie: Belytschko's bound 2 / omega, omega the highest frequency of
// their own operator, found by power iteration (Benson 1998, J. Comput. Phys. 147; Abaqus/Explicit's global
// estimator does the same). Nothing simpler holds: h / c bounds neither a sheet of two rows nor rows that
// disorder has brought near.
#include "src/simulation/simulation.hpp"
#include "swarf/hexes/hex8.hpp"
#include <cmath>

namespace swarf {

// A mode at the tool changes while the tool goes by a spacing, which are hundreds of steps; where material
// tears it changes within a few. While a look finds the step shorter by more than two parts in a thousand,
// the next step looks again.
void Simulation::follow_highest_mode() {
  if (steps < next_mode || particle_method.initial_frame || model.particles.count == 0) return;
  const double before = wave_step;
  const bool known = before > 0 && std::isfinite(before); // not where the first particles have just come
  find_highest_mode(known ? 1 : first_iterations);
  mode_interval = wave_step < 0.998 * before ? 1 : std::min(2 * mode_interval, most_steps_between_modes);
  next_mode = steps + mode_interval;
}

// The kernels of the step do it, on the mode in the place of the velocity and with the stress that Hooke's
// law makes of it; what they write beside is made again by the step. Pairs' own terms have a bound of their
// own (stable_step.cpp). What is tied or frozen does not move.
void Simulation::find_highest_mode(int iterations) {
  if (model.particles.count == 0) return;
  project_tie(model.tie, model.particles, model.hexes);
  Particles trial = model.particles;
  trial.velocity = model.particles.highest_mode;
  trial.points.stress = SymmetricField("elastic_stress", trial.points.stress.extent(0));
  ParticleMethod waves = particle_method;
  waves.viscosity_quadratic = waves.hourglass_stiffness = 0;
  waves.initial_frame = false; // nothing has moved where it is true
  const Real reference = contact_law.reference_step;
  const Real contact = reference > Real(0) ? contact_law.stiffness / (reference * reference) : Real(0);
  ModeRates rates;
  for (int k = 0; k < iterations; ++k) {
    update_ghosts(trial, lists, model.ghost_planes);
    velocity_gradient(trial, lists, waves);
    if (has_surfaces()) correct_surface(trial, lists, model.ghost_planes);
    elastic_stress(trial.points, model.materials);
    if (has_surfaces()) surface_stress(trial, lists, model.ghost_planes);
    prepare_pair_state(trial, model.materials, waves);
    update_ghost_state(trial, lists, model.ghost_planes);
    trial.viscous_work = ScalarField("viscous_work", trial.force.extent(0));
    particle_forces(trial, lists, waves, Real(1));
    rates = advance_mode(trial, {Real(mass_factor), contact}, steps + k);
  }
  wave_step = double(damped_step(rates.stiffness, rates.damping));
  timer.mark("stable step");
}

} // namespace swarf
