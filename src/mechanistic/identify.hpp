// Coefficients of the mechanistic model from forces, measured or of swarf's own runs, by least squares.
#pragma once
#include "src/mechanistic/model.hpp"

namespace swarf {

struct Identified {
  Coefficients value{},
      error{}; // standard errors of the scatter about the fit; NaN where nothing is over for it
  std::array<bool, 6> is_found{};
  int points = 0;
  double scatter = 0; // N, standard deviation of a point about the fit
  std::string how;    // one line for the user
};

// A csv of milling forces: columns immersion, force_x, force_y and perhaps force_z, and feed_per_tooth where
// it is not the deck's, each "name [unit]" in any unit of decks.
Identified identify_from_table(const std::filesystem::path& csv, const Deck& deck,
                               const MechanisticDeck& model);

// Folders of runs that differ in feed or in thickness: mills (whole runs or windows) or wedges, not both. A
// run counts as means over `blocks` equal parts, for samples near each other err together.
Identified identify_from_runs(const std::vector<std::string>& folders, MechanisticDeck model);

} // namespace swarf
