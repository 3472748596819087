#include "src/files/say.hpp"
#include "src/output/read_parts.hpp"
#include "src/surface/surface.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <unordered_set>

namespace swarf {
namespace {

std::vector<Moment> follow(const ResultsFolder& results, const std::vector<FrameEntry>& frames,
                           const std::vector<int>& identities) {
  const std::unordered_set<int> wanted(identities.begin(), identities.end());
  std::vector<Moment> history;
  for (const FrameEntry& entry : frames) {
    if (!entry.particles) continue;
    const FrameParticles p =
        read_frame(results, {entry.index, entry.time, entry.immersion, true, false, false, entry.checksums})
            .particles;
    Moment m{entry.time, 0, 0};
    int count = 0;
    for (std::size_t i = 0; i < p.identity.size(); ++i)
      if (wanted.contains(p.identity[i]))
        m.mean += p.state.temperature[i], m.hottest = std::max(m.hottest, double(p.state.temperature[i])),
                                          ++count;
    if (count > 0) m.mean /= count, history.push_back(m);
  }
  return history;
}

void write_tables(const ResultsFolder& results, const WorkSurface& w, const std::vector<Moment>& history) {
  std::string text = "depth [m],volume [m3],stress_along [Pa],stress_along_scatter [Pa],stress_across [Pa],"
                     "stress_across_scatter [Pa],stress_normal [Pa],plastic_strain [1],temperature [K]\n";
  for (const DepthLayer& l : w.layers)
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", l.depth, l.volume, l.along, l.along_scatter, l.across,
                        l.across_scatter, l.normal, l.plastic_strain, l.temperature);
  write_file(results.path / "surface.csv", text);
  text = "along [m],height [m]\n";
  for (std::size_t k = 0; k < w.strip.size(); ++k) text += fmt::format("{},{}\n", w.strip[k], w.height[k]);
  write_file(results.path / "surface_heights.csv", text);
  text = "time [s],mean_temperature [K],max_temperature [K]\n";
  for (const Moment& m : history) text += fmt::format("{},{},{}\n", m.time, m.mean, m.hottest);
  write_file(results.path / "surface_history.csv", text);
}

void write_numbers(const ResultsFolder& results, const WorkSurface& w, bool lifted) {
  Json json;
  json.set("from", w.from).set("to", w.to).set("spacing", w.spacing).set("mean_height", w.mean_height);
  json.set("Ra", w.Ra).set("Rz", w.Rz).set("burr_height", w.burr).set("burr_along", w.burr_along);
  json.set("unloaded", lifted);
  write_file(results.path / "surface.json", json.text() + "\n");
}

} // namespace

SurfaceReport describe_surface(const std::string& results_folder, double share) {
  const ResultsFolder results = open_results(results_folder);
  const Deck deck = read_deck(results.deck().string(), results.path.string());
  const MachinedSurface surface(deck);
  const auto frames = read_frame_list(results);
  if (frames.empty()) throw ResultsError(results_folder + ": has no frames, so nothing says what was left");
  const WorkSurface w = measure_surface(surface, read_frame(results, frames.back()), share);
  const bool lifted = deck.tool->lift_time && frames.back().time > *deck.tool->lift_time;
  const std::vector<Moment> history = follow(results, frames, w.outermost);
  write_tables(results, w, history);
  write_numbers(results, w, lifted);
  say("new surface from {:.4g} to {:.4g} um along the cut, spacing {:.3g} um{}\n", 1e6 * w.from, 1e6 * w.to,
      1e6 * w.spacing,
      lifted ? "" : "; the tool has not lifted off (tool.lift_time): these are no residual stresses");
  say("  {:.3g} um above the path of the tool, Ra {:.3g} um, Rz {:.3g} um, burr {:.3g} um at {:.4g} um\n",
      1e6 * w.mean_height, 1e6 * w.Ra, 1e6 * w.Rz, 1e6 * w.burr, 1e6 * w.burr_along);
  if (!w.layers.empty())
    say("  outermost layer: stress along the cut {:.4g} MPa, along the edge {:.4g} MPa, plastic strain "
        "{:.3g}\n",
        1e-6 * w.layers[0].along, 1e-6 * w.layers[0].across, w.layers[0].plastic_strain);
  return {w, history};
}

} // namespace swarf
