#include "src/run/run_watch.hpp"
#include "src/files/say.hpp"
#include "src/output/write_hdf5.hpp"
#include <algorithm>
#include <cmath>
#include <sstream>

namespace swarf {

void RunWatch::warn(const std::string& text) {
  said.push_back(text);
  complain("warning: {}", text);
}

void RunWatch::look(const Simulation& simulation, const HistorySample& sample) {
  has_touched = has_touched || sample.particles_in_contact > 0;
  watch_step(simulation);
  judge_energy(simulation, sample);
}

// The residual against all that the run was ever given: its initial energy and the most work done on it. To
// that is added what the bodies would have at the speed of the tool or of driven faces: the springs of a
// first touch hold a share of it that no later balance feels, while the work so far is next to nothing. At
// the end, when there has been work, close() judges without it.
void RunWatch::judge_energy(const Simulation& simulation, const HistorySample& s) {
  most_work = std::max(most_work, std::abs(s.external)), last_residual = s.residual;
  const double own = std::abs(simulation.initial_kinetic()) + most_work,
               given = own + simulation.driven_kinetic();
  off_at_end = own > 0 ? 100 * std::abs(s.residual) / own : 0;
  if (!(given > 0)) return;
  const double off = 100 * std::abs(s.residual) / given;
  worst = std::max(worst, off / 100);
  const std::string what = fmt::format("the energy balance is off by {:.3g} %: {:.3g} J of {:.3g} J given",
                                       off, s.residual, given);
  if (off > deck.run.energy_limit)
    throw SimulationFault(fmt::format("{}, at t = {:.6g} s, step {}; the run ends at {:.3g} % "
                                      "(run.energy_limit). Try a smaller run.courant or run.mass_factor.",
                                      what, s.time, simulation.step_count(), deck.run.energy_limit));
  if (off <= deck.run.energy_tolerance || warned_of_energy) return;
  warned_of_energy = true;
  warn(fmt::format("{}, more than {:.3g} % (run.energy_tolerance) since t = {:.6g} s, step {}. A smaller "
                   "run.courant or run.mass_factor may mend it.",
                   what, deck.run.energy_tolerance, s.time, simulation.step_count()));
}

void RunWatch::watch_step(const Simulation& simulation) {
  if (first_step == 0) first_step = simulation.dt();
  if (warned_of_step || simulation.dt() * 20 > first_step) return;
  warned_of_step = true;
  warn(
      fmt::format("the time step has fallen {:.0f}-fold, from {:.3g} to {:.3g} s, at t = {:.6g} s: {} limits "
                  "it. The run takes as much longer; what is crushed there may want larger cells, "
                  "hexes.delete_at_strain, or particles.",
                  first_step / simulation.dt(), first_step, simulation.dt(), simulation.time(),
                  simulation.place_of_limiter()));
}

void RunWatch::close(bool complete) {
  if (complete && !warned_of_energy && off_at_end > deck.run.energy_tolerance)
    warn(fmt::format(
        "at the end {:.3g} J are missing in the energy balance, {:.3g} % of the work and the initial "
        "energy: more than {:.3g} % (run.energy_tolerance). A smaller run.courant or run.mass_factor "
        "may mend it.",
        last_residual, off_at_end, deck.run.energy_tolerance));
  if (complete && deck.tool && !has_touched)
    warn("the tool has touched nothing: all forces are 0. swarf check says where the tool goes and where the "
         "bodies are.");
}

void RunWatch::write_state(CheckpointWriter& out) const {
  out.put("watch/most_work", most_work), out.put("watch/worst", worst),
      out.put("watch/first_step", first_step);
  out.put("watch/has_touched", int(has_touched));
  out.put("watch/warned", int(warned_of_energy) + 2 * int(warned_of_step));
  std::vector<int> text; // a line each
  for (const std::string& line : said)
    text.insert(text.end(), line.begin(), line.end()), text.push_back('\n');
  out.put("watch/said", text);
}

void RunWatch::read_state(const CheckpointReader& in) {
  in.get("watch/most_work", most_work), in.get("watch/worst", worst), in.get("watch/first_step", first_step);
  int touched = 0, warned = 0;
  in.get("watch/has_touched", touched), in.get("watch/warned", warned);
  std::vector<int> text;
  in.get("watch/said", text);
  std::istringstream lines(std::string(text.begin(), text.end()));
  for (std::string line; std::getline(lines, line);) said.push_back(line);
  has_touched = touched != 0, warned_of_energy = (warned & 1) != 0, warned_of_step = (warned & 2) != 0;
}

} // namespace swarf
