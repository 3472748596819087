// The line that a user watches while a run goes on.
#pragma once
#include "src/simulation/simulation.hpp"
#include <chrono>

namespace swarf {

class Progress {
 public:
  Progress(const Deck& deck, double end_time);
  // Prints at most once a second on a terminal, every ten seconds in a log.
  void show(const Simulation& simulation, const HistorySample& sample);
  void finish();
  double seconds() const; // of wall time since the start

 private:
  using Clock = std::chrono::steady_clock;
  double end = 0;
  bool spindle = false, terminal = false;
  Clock::time_point start, last;
  double start_time = -1, initial_kinetic = 0;
};

} // namespace swarf
