// What a run would cost, before it is begun: refused where it would never end.
#pragma once
#include "src/simulation/simulation.hpp"

namespace swarf {

double count_steps(const Deck& deck, const Simulation& simulation);
// Steps of conduction in one of mechanics; 0 without.
double count_heat_steps(const Deck& deck, const Simulation& simulation);

// Throws DeckError that names the key: more steps than a run of years, or a mechanical step that conduction
// divides into thousands. After Simulation::start().
void refuse_endless(const Deck& deck, const Simulation& simulation);

} // namespace swarf
