// One run of a deck: the loop over time, what is written when, how it ends.
#pragma once
#include "src/deck/deck.hpp"

namespace swarf {

struct RunOptions {
  std::string deck;                   // file
  std::string output;                 // folder; empty: results/<name of the deck file>
  bool resume = false;                // continue from the folder's checkpoint
  bool overwrite = false;             // the results that the folder holds
  bool pictures = true;               // draw them at the end
  long stop_after = 0;                // steps; 0: the deck's end. For trials of large scenes
  std::optional<std::string> windows; // first:last:step; not given: as in the deck
  bool whole = false;                 // the whole pass, though the deck has [windows]
};

// The deck as `run` takes it: with [windows] as the options say, and the settings that run.accuracy picks.
// Throws DeckError.
Deck deck_to_run(const RunOptions& options);

// How it ended, as summary.json says it.
struct RunEnding {
  int status = 0;
  std::string how = "complete"; // complete | stopped | interrupted | failed
  std::string why;              // of the last three: the option, the signal, the fault
};

// Exit status: 0 done or stopped as asked, 1 the results cannot be written, 3 the computation became unstable
// or its energy balance is off (last frame and checkpoint written), 130 interrupted by a signal (checkpoint
// written). Throws DeckError, ResultsError. Kokkos must be initialised.
int run_deck(const Deck& deck, const RunOptions& options);

// "results/<stem of the deck file>"
std::string default_output(const std::string& deck_file);

} // namespace swarf
