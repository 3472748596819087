// Wall time of each phase of the step, for the closing report.
#pragma once
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace swarf {

class PhaseTimer {
 public:
  // Time since the last mark goes to `phase`. A fence belongs before it on a GPU; on a CPU launches return
  // done.
  void mark(const char* phase) {
    const auto current = Clock::now();
    const double seconds = std::chrono::duration<double>(current - last).count();
    last = current;
    for (auto& [name, sum] : phases)
      if (name == phase) {
        sum += seconds;
        return;
      }
    phases.emplace_back(phase, seconds);
  }
  void restart() { last = Clock::now(); }
  const std::vector<std::pair<std::string, double>>& totals() const { return phases; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last = Clock::now();
  std::vector<std::pair<std::string, double>> phases;
};

} // namespace swarf
