// What run.accuracy may choose from and what it chose, as text.
#include "src/accuracy/accuracy.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace swarf {
namespace {

// [particles] of most choices.
ParticlesDeck usual_method(const AccuracyPlan& plan) {
  const auto alike = [&](const Choice& choice) {
    return std::count_if(plan.choices.begin(), plan.choices.end(),
                         [&](const Choice& other) { return other.deck.particles == choice.deck.particles; });
  };
  return std::max_element(plan.choices.begin(), plan.choices.end(),
                          [&](const Choice& a, const Choice& b) { return alike(a) < alike(b); })
      ->deck.particles;
}

// Where the point's method is not that of most.
std::string describe_method(const ChartPoint& point, const Choice& choice, const AccuracyPlan& plan) {
  Deck usual = choice.deck;
  usual.particles = usual_method(plan);
  std::vector<std::string> parts;
  for (const KeyChange& change : list_changes(usual, choice.deck))
    parts.push_back(fmt::format("{} = {}", change.key, change.now));
  if (point.sleep_rows > 0)
    parts.push_back(fmt::format("frozen beyond {:.3g} um", 1e6 * *choice.deck.sleep.distance));
  if (!point.bulk) parts.push_back("no hexes");
  if (choice.windows) parts.push_back("in windows");
  return fmt::format("{}", fmt::join(parts, ", "));
}

} // namespace

std::string show_choices(const AccuracyPlan& plan, double scale) {
  std::string text = fmt::format("choices for accuracy = \"{:.4g} %\", measured in {} ({}):\n",
                                 100 * plan.asked, plan.chart->deck, plan.chart->title);
  text += fmt::format("  {:<24} {:>10} {:>9} {:>6} {:>8} {:>8} {:>13} {:>17} {:>8}\n", "point", "spacing/um",
                      "per chip", "slice", "mass", "courant", "core-seconds", "error", "at most");
  for (std::size_t k = 0; k < plan.choices.size(); ++k) {
    const Choice& choice = plan.choices[k];
    const ChartPoint& p = *choice.point;
    const std::string slice = plan.cut.is_slice ? std::to_string(p.slice_rows) : "kept";
    const std::string error = fmt::format("{:+.1f} % +- {:.1f} %", 100 * p.error, 100 * p.standard_error);
    text +=
        fmt::format("{} {:<24} {:10.3g} {:9.3g} {:>6} {:8.3g} {:8.3g} {:13.3g} {:>17} {:>7.1f}%  {}\n",
                    int(k) == plan.picked ? '>' : ' ', p.label, 1e6 * plan.cut.chip / p.chip_rows,
                    p.chip_rows, slice, choice.deck.run.mass_factor, p.courant, scale * choice.core_seconds,
                    error, 100 * level_of(choice, *plan.chart), describe_method(p, choice, plan));
  }
  return text +
         fmt::format(
             "  at most: error and standard error here and at all finer spacings; no less than the {:.1f} "
             "% that the reference is known to; in windows, what these miss on top\n",
             100 * plan.chart->uncertainty);
}

std::string show_pick(const Deck& deck) {
  if (!deck.picked) return "";
  std::string text = fmt::format("accuracy {:.4g} %: {}\n", deck.picked->asked, deck.picked->why);
  for (const std::string& change : deck.picked->changes) text += "  " + change + "\n";
  return text + (deck.picked->changes.empty() ? "  the deck has these settings already\n" : "");
}

} // namespace swarf
