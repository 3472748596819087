#include "src/check/cost.hpp"
#include "src/deck/lines.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace swarf {
namespace {

constexpr double most_steps = 1e10;     // at 1 ms a step four months, and few scenes take so little
constexpr double most_heat_steps = 1e3; // in a step: all time would go there

const MaterialDeck& fastest_conductor(const Deck& deck) {
  const auto diffusivity = [](const MaterialDeck& m) { // the tool takes steps of its own
    return m.law == Law::rigid ? 0 : m.conductivity.greatest() / m.density / m.specific_heat.least();
  };
  return *std::max_element(
      deck.materials.begin(), deck.materials.end(),
      [&](const MaterialDeck& a, const MaterialDeck& b) { return diffusivity(a) < diffusivity(b); });
}

double wave_speed(const MaterialDeck& m) {
  const double E = m.youngs_modulus.greatest(), K = E / 3 / (1 - 2 * m.poissons_ratio),
               G = E / 2 / (1 + m.poissons_ratio);
  return std::sqrt((K + 4 * G / 3) / m.density);
}

// Sound is fastest in diamond, 18 km/s: what is said to be far faster is a slip of a unit, and not the run's.
void refuse_fast_waves(const Deck& deck) {
  constexpr double fastest = 1e5; // m/s
  for (const MaterialDeck& m : deck.materials) {
    if (m.law == Law::rigid || !(wave_speed(m) > fastest)) continue;
    const std::string key = m.density < 100                      ? "density"
                            : m.youngs_modulus.greatest() > 2e12 ? "youngs_modulus"
                                                                 : "poissons_ratio";
    throw DeckError(fmt::format("{}: material.{}.{}: E = {:.3g} Pa, nu = {:.6g} and density = {:.3g} kg/m3 "
                                "give waves of {:.3g} m/s, by "
                                "which the step is {:.3g} times smaller than in steel: expected less than "
                                "{:.0e} m/s. Look at the units.",
                                line_of(deck.file, "[material." + m.name + "]", key), m.name, key,
                                m.youngs_modulus.greatest(), m.poissons_ratio, m.density, wave_speed(m),
                                wave_speed(m) / 5900, fastest));
  }
}

} // namespace

double count_steps(const Deck& deck, const Simulation& simulation) {
  return std::ceil(std::max(0.0, end_time_of(deck) - simulation.time()) / simulation.dt());
}

double count_heat_steps(const Deck& deck, const Simulation& simulation) {
  const double step = simulation.heat_dt();
  return step > 0 && std::isfinite(step) ? std::ceil(std::min(simulation.dt(), end_time_of(deck)) / step) : 0;
}

void refuse_endless(const Deck& deck, const Simulation& simulation) {
  const double steps = count_steps(deck, simulation), heat = count_heat_steps(deck, simulation);
  if (!(steps <= most_steps)) {
    refuse_fast_waves(deck);
    const std::string key = deck.run.end_time ? "end_time" : "end_immersion";
    throw DeckError(fmt::format("{}: run.{}: makes {:.3g} steps of {:.3g} s, limited by {}: expected at most "
                                "{:.0e}. End earlier, or take larger cells or a larger run.mass_factor.",
                                line_of(deck.file, "[run]", key), key, steps, simulation.dt(),
                                simulation.place_of_limiter(), most_steps));
  }
  if (heat > most_heat_steps) {
    const MaterialDeck& m = fastest_conductor(deck);
    throw DeckError(fmt::format(
        "{}: material.{}.conductivity: {:.4g} W/m/K needs {:.3g} steps of conduction, of {:.3g} s, in each "
        "step "
        "of {:.3g} s: expected at most {:.0f}. Look at the unit, or take a smaller run.mass_factor.",
        line_of(deck.file, "[material." + m.name + "]", "conductivity"), m.name, m.conductivity.greatest(),
        heat, simulation.heat_dt(), simulation.dt(), most_heat_steps));
  }
}

} // namespace swarf
