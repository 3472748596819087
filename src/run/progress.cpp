#include "src/run/progress.hpp"
#include "src/files/say.hpp"
#include <cmath>
#include <fmt/format.h>
#include <unistd.h>

namespace swarf {

Progress::Progress(const Deck& deck, double end_time)
    : end(end_time), spindle(deck.tool && deck.tool->spindle_speed > 0), terminal(isatty(STDOUT_FILENO)),
      start(Clock::now()), last(start - std::chrono::hours(1)) {}

double Progress::seconds() const { return std::chrono::duration<double>(Clock::now() - start).count(); }

void Progress::show(const Simulation& s, const HistorySample& h) {
  if (start_time < 0) start_time = s.time(), initial_kinetic = s.initial_kinetic();
  const auto current = Clock::now();
  if (current - last < std::chrono::seconds(terminal ? 1 : 10)) return;
  last = current;
  const double wall = seconds();
  const double rate = s.particle_steps() / wall;
  const double done = s.time() - start_time;
  const double left = done > 0 ? wall * (end - s.time()) / done : 0;
  const std::string angle = spindle ? fmt::format(" {:6.2f} deg", h.immersion) : "";
  const double measure = std::max(std::abs(h.external), initial_kinetic);
  const double relative = measure > 0 ? 100 * h.residual / measure : 0;
  say("{}{:5.1f} %{} | step {} dt {:.3g} s by {} | {:.2f} M particle-steps/s | {:.0f} s left | planar "
      "{:.3g} N | hottest {:.0f} K | energy residual {:+.2f} %{}",
      terminal ? "\r" : "", 100 * s.time() / end, angle, s.step_count(), h.dt, s.limiter(), rate / 1e6, left,
      std::hypot(h.force[0], h.force[1]), h.max_temperature, relative, terminal ? "\033[K" : "\n");
}

void Progress::finish() {
  if (terminal) say("\n");
}

} // namespace swarf
