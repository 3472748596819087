// swarf mechanistic and swarf identify: the model of the mill beside the simulation.
#pragma once
#include <string>
#include <vector>

namespace swarf {

struct MechanisticOptions {
  std::string deck, output, coefficients, measurements; // files and a folder; empty: not given
  bool pictures = true;
};
// Writes mechanistic.csv into the folder, draws it, beside the run's forces if there are some, and says what
// the cut is. Throws DeckError, ResultsError.
void show_mechanistic(const MechanisticOptions& options);

struct IdentifyOptions {
  std::vector<std::string> folders;
  std::string output; // empty: on the screen only
};
void show_identified(const IdentifyOptions& options);

} // namespace swarf
