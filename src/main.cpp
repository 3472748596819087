// The program: swarf run | check | keys | plot | render.
#include "src/check.hpp"
#include "src/child_process.hpp"
#include "src/pictures.hpp"
#include "src/render.hpp"
#include "src/results.hpp"
#include "src/run.hpp"
#include "src/run_windows.hpp"
#include "src/simulation.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

// Kokkos starts after the deck is known to be sound, with the threads that the user or the deck asks for.
template <class Work>
int with_kokkos(int threads, const Work& work) {
  Kokkos::InitializationSettings settings;
  settings.set_disable_warnings(true);
  if (threads > 0) settings.set_num_threads(threads);
  const Kokkos::ScopeGuard guard(settings);
  return work();
}

int run(const swarf::RunOptions& options, const swarf::WindowsOptions& how) {
  const swarf::Deck deck = swarf::deck_to_run(options);
  if (deck.windows) return swarf::run_windows(deck, options, how);
  if (how.jobs > 1)
    throw swarf::DeckError("--jobs counts windows side by side: give --windows too, or --threads instead.");
  return with_kokkos(how.threads > 0 ? how.threads : deck.run.threads,
                     [&] { return swarf::run_deck(deck, options); });
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app("swarf: micro end milling by particles and hexes");
  app.set_version_flag("--version", SWARF_VERSION);
  app.require_subcommand(1);
  swarf::RunOptions options;
  int threads = 0;
  bool no_pictures = false;
  swarf::WindowsOptions windows;

  CLI::App* run = app.add_subcommand("run", "run a deck");
  run->add_option("deck", options.deck, "the deck, a TOML file")->required();
  run->add_option("-o,--output", options.output, "results folder (default results/NAME of the deck)");
  run->add_option("-t,--threads", threads, "threads (default: the deck's, else all cores)")
      ->check(CLI::PositiveNumber);
  run->add_option("--stop-after", options.stop_after, "stop after so many steps")->check(CLI::PositiveNumber);
  run->add_flag("--resume", options.resume, "continue from the folder's checkpoint");
  run->add_flag("--no-pictures", no_pictures, "draw nothing at the end");
  CLI::Option* spread =
      run->add_option("--windows", options.windows,
                      "run short windows of immersion first:last:step, deg, instead of the whole pass");
  run->add_option("--jobs", windows.jobs, "windows side by side, of one thread each if there are several")
      ->check(CLI::Range(1, swarf::ChildProcesses::most));
  run->add_flag("--whole", options.whole, "run the whole pass, though the deck has [windows]")
      ->excludes(spread);

  CLI::App* check = app.add_subcommand("check", "build the scene, say what it costs and whether it is fit");
  check->add_option("deck", options.deck, "the deck")->required();
  check->add_option("-t,--threads", threads, "threads")->check(CLI::PositiveNumber);

  CLI::App* keys = app.add_subcommand("keys", "print the reference of all deck keys");

  std::string folder;
  CLI::App* plot = app.add_subcommand("plot", "draw force and energy plots of a results folder again");
  plot->add_option("results", folder, "results folder")->required();
  CLI::App* render = app.add_subcommand("render", "draw the chip pictures of a results folder again");
  render->add_option("results", folder, "results folder")->required();

  CLI11_PARSE(app, argc, argv);
  try {
    if (*keys) return fmt::print("{}", swarf::key_reference()), 0;
    if (*plot) return swarf::draw_plots(folder), 0;
    if (*render) return swarf::render_strip(folder) ? 0 : 1;
    options.pictures = !no_pictures, windows.threads = threads;
    if (*run) return ::run(options, windows);
    const int asked = threads > 0 ? threads : swarf::read_deck(options.deck).run.threads;
    return with_kokkos(asked, [&] { return swarf::check_deck(options.deck), 0; });
  } catch (const std::exception& error) {
    fmt::print(stderr, "swarf: {}\n", error.what());
    return 1;
  }
  return 0;
}
