// What a run says about itself while it goes on and at its end: an energy balance that does not close, a step
// that has fallen far, a tool that has touched nothing.
#pragma once
#include "src/simulation/simulation.hpp"

namespace swarf {

class RunWatch {
 public:
  explicit RunWatch(const Deck& of) : deck(of) {}

  // After each check(). Warns once of each fault; throws SimulationFault where the balance is off by more
  // than run.energy_limit.
  void look(const Simulation& simulation, const HistorySample& sample);
  // At the end: what is still to be said.
  void close(bool complete);

  double worst_balance() const { return worst; } // residual over what was given, where it was judged
  bool touched() const { return has_touched; }
  const std::vector<std::string>& warnings() const { return said; }

  void write_state(CheckpointWriter&) const;
  void read_state(const CheckpointReader&);

 private:
  void warn(const std::string& text);
  void judge_energy(const Simulation& simulation, const HistorySample& sample);
  void watch_step(const Simulation& simulation);

  const Deck& deck;
  double most_work = 0, last_residual = 0, off_at_end = 0, worst = 0, first_step = 0;
  bool has_touched = false, warned_of_energy = false, warned_of_step = false;
  std::vector<std::string> said;
};

} // namespace swarf
