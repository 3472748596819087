// Windows of a pass, each an ordinary run of its own deck in a process of its own.
#pragma once
#include "src/run/run.hpp"

namespace swarf {

struct WindowsOptions {
  int jobs = 1;    // side by side
  int threads = 0; // of each; 0: one if there are several jobs, else the deck's
};

// Of a deck with [windows]. Exit status: 0 all complete, 3 some failed (named in the report; the others are
// joined), 130 interrupted. Windows that are complete already, of the same deck, are kept; `resume` goes on
// from the others' checkpoints. Throws DeckError, ResultsError.
int run_windows(const Deck& deck, const RunOptions& options, const WindowsOptions& how);

} // namespace swarf
