// What cells of a body cost.
#pragma once

namespace swarf {

// What a run needs for a particle (fields, lists, tie) and a hex, measured on the shipped decks; rounded down
// so that nothing is refused that would run.
constexpr double bytes_per_cell = 1000;

} // namespace swarf
