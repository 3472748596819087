#include "src/app/mechanistic.hpp"
#include "src/files/folder_lock.hpp"
#include "src/files/results.hpp"
#include "src/files/say.hpp"
#include "src/mechanistic/identify.hpp"
#include "src/pictures/pictures.hpp"
#include "src/run/run.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace swarf {
namespace {

constexpr double degree = std::numbers::pi / 180;

void show_coefficients(const Identified& found) {
  say("{}; a point is off by {:.3g} N (standard deviation)\n", found.how, found.scatter);
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [scale, unit] = k < 3 ? std::pair(1e-6, "N/mm2") : std::pair(1e-3, "N/mm");
    if (found.is_found[k])
      say("  {} = {:8.4g} +- {:.2g} {}\n", coefficient_names[k], scale * found.value[k],
          scale * found.error[k], unit);
    else
      say("  {} is not told by these forces: 0\n", coefficient_names[k]);
  }
  for (std::size_t k = 0; k < 6; ++k)
    if (found.is_found[k] && found.error[k] > 0.5 * std::abs(found.value[k]))
      return complain("warning: {} is known to {:.0f} % only: the chips are too much alike. Give forces at "
                      "three feeds or "
                      "thicknesses, or over more of the immersion.",
                      coefficient_names[k], 100 * found.error[k] / std::abs(found.value[k]));
}

MechanisticDeck choose_coefficients(const Deck& deck, const MechanisticOptions& options) {
  if (!options.coefficients.empty()) return read_mechanistic(options.coefficients);
  MechanisticDeck model;
  model.exit = std::numbers::pi;
  if (deck.mechanistic) model = *deck.mechanistic;
  if (!options.measurements.empty()) {
    const Identified found = identify_from_table(options.measurements, deck, model);
    show_coefficients(found);
    set_coefficients(found.value, model);
  } else if (!deck.mechanistic) {
    throw DeckError(deck.file +
                    ": has no [mechanistic] section with coefficients. Add one (swarf keys), or give "
                    "--coefficients FILE of swarf identify, or --measurements FILE.csv.");
  }
  return model;
}

void say_cut(const MillCut& cut) {
  say("depth of cut {:.4g} um, feed {:.4g} um per tooth = {:.4g} mm/min, helix {:.4g} deg: a lag of {:.2f} "
      "deg\n",
      1e6 * cut.depth, 1e6 * cut.tool.feed_per_tooth, 6e4 * cut.feed_speed(), cut.helix / degree,
      cut.lag() / degree);
  MillCut end_face = cut;
  end_face.helix = 0, end_face.minimum_chip = 0;
  const MillEdge edge(end_face);
  for (int tooth = 0; tooth < (cut.tool.runout > 0 ? cut.tool.flutes : 1); ++tooth) {
    const auto chip = [&](double at) {
      return 1e6 * edge.look(tooth, 0, at * degree + tooth * cut.pitch()).chip;
    };
    say("uncut chip of tooth {} at 10, 30, 90 deg: {:.3f}, {:.3f}, {:.3f} um\n", tooth + 1, chip(10),
        chip(30), chip(90));
  }
}

void say_forces(const HistoryTable& table) {
  const auto &planar = table.at("force_planar"), &immersion = table.at("immersion");
  const std::size_t peak = std::size_t(std::max_element(planar.begin(), planar.end()) - planar.begin());
  double mean = 0;
  for (const double force : planar) mean += force / double(planar.size());
  say("planar resultant: peak {:.3f} N at {:.1f} deg, mean of the turn {:.3f} N\n", planar[peak],
      immersion[peak], mean);
}

} // namespace

void show_mechanistic(const MechanisticOptions& options) {
  const Deck deck = read_deck(options.deck);
  const MechanisticDeck model = choose_coefficients(deck, options);
  const ResultsFolder folder{options.output.empty() ? default_output(options.deck) : options.output};
  say_cut(find_cut(deck, model));
  const HistoryTable table = run_model(deck, model);
  make_folder(folder.path);
  const FolderLock lock(folder.path);
  write_table(table, folder.mechanistic());
  say_forces(table);
  say("curves: {}\n", folder.mechanistic().string());
  if (!options.pictures) return;
  try {
    draw_plots(folder.path.string());
    say("pictures: {}\n", folder.pictures().string());
  } catch (const std::exception& error) {
    complain("no pictures: {}", error.what());
  }
}

void show_identified(const IdentifyOptions& options) {
  MechanisticDeck model;
  model.exit = std::numbers::pi;
  const Identified found = identify_from_runs(options.folders, model);
  show_coefficients(found);
  set_coefficients(found.value, model);
  if (options.output.empty()) return;
  write_file(options.output, fmt::format("# {}.\n{}", found.how, write_mechanistic(model)));
  say("written: {}\n", options.output);
}

} // namespace swarf
