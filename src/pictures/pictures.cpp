#include "src/pictures/pictures.hpp"
#include "src/files/say.hpp"
#include "src/pictures/render.hpp"
#include "src/plots/plot.hpp"
#include "src/windows/join_windows.hpp"

namespace swarf {

void draw_windows(const std::string& results) {
  try {
    const PassFolder folder{results};
    plot_windows(folder, read_deck(folder.deck().string()).output.published);
    say("picture: {}\n", folder.picture().string());
  } catch (const std::exception& error) {
    complain("no picture: {}", error.what());
  }
}

void draw_plots(const std::string& results) {
  const ResultsFolder any{results};
  const bool has_windows = std::filesystem::exists(PassFolder{results}.table());
  if (!has_windows && std::filesystem::exists(any.mechanistic()) && !std::filesystem::exists(any.history())) {
    make_folder(any.pictures());
    plot_mechanistic(any, any.pictures() / "mechanistic.png", {});
    return;
  }
  if (has_windows) draw_windows(results);
  if (has_windows && !std::filesystem::exists(ResultsFolder{results}.history())) return;
  const ResultsFolder folder = open_results(results);
  const Deck deck = read_deck(folder.deck().string(), folder.path.string());
  make_folder(folder.pictures());
  plot_forces(folder, folder.pictures() / "force.png", deck.output.published, deck.output.filter_frequency);
  plot_energies(folder, folder.pictures() / "energy.png");
  plot_heat(folder, folder.pictures() / "heat.png");
}

void draw_all(const std::string& results) {
  try {
    draw_plots(results);
    render_strip(results);
    say("pictures: {}\n", open_results(results).pictures().string());
  } catch (const std::exception& error) {
    complain("no pictures: {}", error.what());
  }
}

} // namespace swarf
