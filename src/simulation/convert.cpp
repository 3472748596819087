// When hexes become particles, and what that costs.
#include "src/scene/convert_hexes.hpp"
#include "src/scene/hex_conversion.hpp"
#include "src/simulation/simulation.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace swarf {

// A particle presses another spring than the node in whose place it comes; what that makes or takes counts as
// lost in the conversion.
double Simulation::energy_in_contact() {
  const bool touches = deck.tool && contact_law.reference_step > 0; // else the run has not begun
  for (const ContactPoints& points : {contact_points_of(model.particles), contact_points_of(model.hexes)})
    if (touches)
      tool_contact(points, model.tool, pose(), contact_law, model.materials, Real(mass_factor), Real(0));
  PointSums all = sum_particles(model.particles, Real(mass_factor));
  all.add(sum_hexes(model.hexes, Real(mass_factor)));
  return double(all.kinetic) + all.internal + all.friction + all.viscous + all.hourglass + all.contact -
         all.external;
}

double Simulation::step_of_new_particles() const {
  double least = std::numeric_limits<double>::infinity();
  if (!model.conversion) return least;
  const auto materials = host_copy(model.materials);
  for (const HexConversion::Lattice& lattice : model.conversion->lattice)
    if (lattice.n > 0)
      least = std::min(least, deck.run.courant * deck.particles.smoothing_ratio * lattice.spacing *
                                  std::sqrt(mass_factor) /
                                  double(longitudinal_wave_speed(materials(lattice.material))));
  return least;
}

void Simulation::convert() {
  if (!model.conversion) return;
  conversion.looked(now);
  const auto is_chosen = host_copy(choose_hexes(model.hexes, model.conversion->limits, pose()));
  std::vector<int> chosen;
  for (int e = 0; e < model.hexes.points.count; ++e)
    if (is_chosen(e)) chosen.push_back(e);
  timer.mark("conversion");
  if (chosen.empty()) return;
  const double before = energy_in_contact();
  take_contact_heat(); // while its nodes have a capacity
  convert_hexes(deck, model, chosen);
  energy.others_frozen = true;
  energy.lost_in_conversion += before - energy_in_contact();
  ensure_rows(loads.blocks, std::size_t(model.particles.count / ToolLoadSums::block + 1));
  lists_due = true;
  next_check = std::min(next_check, steps + 1); // particles may ask for a shorter step
  timer.mark("conversion");
}

void Simulation::plan_conversion() {
  if (!model.conversion) return;
  const bool strains = std::any_of(deck.bodies.begin(), deck.bodies.end(),
                                   [](const BodyDeck& b) { return b.convert_strain.has_value(); });
  conversion.plan(now, strains, driving_speed, model.conversion->travel);
}

} // namespace swarf
