#include "src/pictures.hpp"
#include "src/join_windows.hpp"
#include "src/plot.hpp"
#include "src/render.hpp"
#include <fmt/format.h>

namespace swarf {

void draw_windows(const std::string& results) {
  try {
    const PassFolder folder{results};
    plot_windows(folder, read_deck(folder.deck().string()).output.published);
    fmt::print("picture: {}\n", folder.picture().string());
  } catch (const std::exception& error) {
    fmt::print(stderr, "swarf: no picture: {}\n", error.what());
  }
}

void draw_plots(const std::string& results) {
  const bool has_windows = std::filesystem::exists(PassFolder{results}.table());
  if (has_windows) draw_windows(results);
  if (has_windows && !std::filesystem::exists(ResultsFolder{results}.history())) return;
  const ResultsFolder folder = open_results(results);
  const Deck deck = read_deck(folder.deck().string());
  std::filesystem::create_directories(folder.pictures());
  plot_forces(folder, folder.pictures() / "force.png", deck.output.published, deck.output.filter_frequency);
  plot_energies(folder, folder.pictures() / "energy.png");
}

void draw_all(const std::string& results) {
  try {
    draw_plots(results);
    render_strip(results);
    fmt::print("pictures: {}\n", open_results(results).pictures().string());
  } catch (const std::exception& error) {
    fmt::print(stderr, "swarf: no pictures: {}\n", error.what());
  }
}

} // namespace swarf
