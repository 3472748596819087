// The program: swarf COMMAND; --help lists the commands.
#include "src/app/check.hpp"
#include "src/app/mechanistic.hpp"
#include "src/app/python.hpp"
#include "src/deck/library.hpp"
#include "src/files/folder_lock.hpp"
#include "src/files/results.hpp"
#include "src/files/say.hpp"
#include "src/pictures/pictures.hpp"
#include "src/pictures/render.hpp"
#include "src/run/child_process.hpp"
#include "src/run/run.hpp"
#include "src/run/run_windows.hpp"
#include "src/run/signals.hpp"
#include "src/simulation/simulation.hpp"
#include "src/surface/surface.hpp"
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <limits>
#include <thread>
#include <unistd.h>
#ifdef KOKKOS_ENABLE_OPENMP
#include <omp.h>
#endif

namespace {

// A stream that was closed at the start would become the first file that is opened, and progress go into it.
void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", stream == STDIN_FILENO ? O_RDONLY : O_WRONLY) < 0)
      std::_Exit(1);
}

// How long a waiting thread of GNU's OpenMP spins before it sleeps is read before main: the program starts
// itself again with less than the usual 300 000 turns, in which a busy machine does nothing else for
// milliseconds.
void shorten_spinning(char** argv) {
  if (std::getenv("GOMP_SPINCOUNT") || std::getenv("OMP_WAIT_POLICY")) return;
  setenv("GOMP_SPINCOUNT", "1000", 1);
  execv("/proc/self/exe", argv); // where there is none the usual count stays
}

// Threads that wait for each other must share no core, and more cannot compute: results do not depend on
// them.
int usable_threads(int asked) {
#ifdef KOKKOS_ENABLE_OPENMP
  const int cores = omp_get_num_procs(); // of this process, also where its first thread is bound to one
#else
  const int cores = std::max(1, int(std::thread::hardware_concurrency()));
#endif
  if (asked > cores)
    swarf::complain("warning: {} threads are asked for, {} cores are there: taking {}.", asked, cores, cores);
  return std::min(asked, cores);
}

// Kokkos starts after the deck is known to be sound, with the threads that the user or the deck asks for.
template <class Work>
int with_kokkos(int threads, const Work& work) {
  Kokkos::InitializationSettings settings;
  settings.set_disable_warnings(true);
  if (threads > 0) settings.set_num_threads(usable_threads(threads));
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

// So that a mistyped name makes no folder.
const std::string& existing(const std::string& folder) {
  if (!std::filesystem::is_directory(folder)) swarf::open_results(folder); // says what is wrong
  return folder;
}

} // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  shorten_spinning(argv);
  CLI::App app("swarf: micro end milling by particles and hexes");
  app.set_version_flag("--version", SWARF_VERSION);
  app.require_subcommand(1);
  swarf::RunOptions options;
  int threads = 0;
  bool no_pictures = false;
  swarf::WindowsOptions windows;
  std::string windows_text;

  CLI::App* run = app.add_subcommand("run", "run a deck");
  run->add_option("deck", options.deck, "the deck, a TOML file")->required();
  run->add_option("-o,--output", options.output, "results folder (default results/NAME of the deck)");
  run->add_option("-t,--threads", threads, "threads (default: the deck's, else all cores)")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));
  run->add_option("--stop-after", options.stop_after, "stop after so many steps")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));
  CLI::Option* resume = run->add_flag("--resume", options.resume, "continue from the folder's checkpoint");
  run->add_flag("--overwrite", options.overwrite, "replace the results that the folder holds")
      ->excludes(resume);
  run->add_flag("--no-pictures", no_pictures, "draw nothing at the end");
  CLI::Option* spread =
      run->add_option("--windows", windows_text,
                      "run short windows of immersion first:last:step, deg, instead of the whole pass");
  run->add_option("--jobs", windows.jobs, "windows side by side, of one thread each if there are several")
      ->check(CLI::Range(1, swarf::ChildProcesses::most));
  run->add_flag("--whole", options.whole, "run the whole pass, though the deck has [windows]")
      ->excludes(spread);

  CLI::App* check = app.add_subcommand("check", "build the scene, say what it costs and whether it is fit");
  check->add_option("deck", options.deck, "the deck")->required();
  check->add_option("-t,--threads", threads, "threads")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));

  std::string picture;
  CLI::Option* draw = check
                          ->add_option("--picture", picture,
                                       "draw bodies and the tool's way to this PNG (default NAME_scene.png)")
                          ->expected(0, 1);

  CLI::App* keys = app.add_subcommand("keys", "print the reference of all deck keys");

  CLI::App* materials = app.add_subcommand("materials", "list the library of materials, with sources");

  std::string folder;
  CLI::App* plot = app.add_subcommand("plot", "draw force and energy plots of a results folder again");
  plot->add_option("results", folder, "results folder")->required();
  CLI::App* render = app.add_subcommand("render", "draw the chip pictures of a results folder again");
  render->add_option("results", folder, "results folder")->required();
  bool of_tool = false;
  std::string field;
  CLI::Option* tool_flag = render->add_flag("--tool", of_tool, "the tool's rake and flank instead");
  render
      ->add_option(
          "--field", field,
          "that colours them: temperature, contact_pressure, sliding_speed, friction_power, wear_depth")
      ->needs(tool_flag);

  CLI::App* surface = app.add_subcommand("surface", "what the cut has left on the work: tables and plots");
  double skip = 20;
  surface->add_option("results", folder, "results folder")->required();
  surface->add_option("--skip", skip, "of the length that was cut, left out at each end, % (20)")
      ->check(CLI::Range(0.0, 49.0));
  bool film = false;
  render->add_flag("--film", film, "all frames as a film, pictures/chip.mp4 (needs ffmpeg), instead");

  swarf::MechanisticOptions model;
  CLI::App* mechanistic =
      app.add_subcommand("mechanistic", "forces over a turn of the mill from coefficients, in no time");
  mechanistic->add_option("deck", model.deck, "the deck")->required();
  mechanistic->add_option("-o,--output", model.output, "folder (default results/NAME of the deck)");
  CLI::Option* from_file = mechanistic->add_option("--coefficients", model.coefficients,
                                                   "a file with [mechanistic], as identify writes it");
  mechanistic
      ->add_option("--measurements", model.measurements, "a csv of forces that the coefficients fit best")
      ->excludes(from_file);
  mechanistic->add_flag("--no-pictures", no_pictures, "draw nothing");
  swarf::IdentifyOptions identified;
  CLI::App* identify = app.add_subcommand("identify", "coefficients of the mechanistic model from runs");
  identify->add_option("results", identified.folders, "folders of runs, of three feeds or chip thicknesses")
      ->required();
  identify->add_option("-o,--output", identified.output,
                       "file for the coefficients, a section [mechanistic]");

  // Their words are those of the Python package, which reads them.
  for (const auto& [name, what] : swarf::python_commands)
    app.add_subcommand(name, what)->prefix_command()->set_help_flag();

  CLI11_PARSE(app, argc, argv);
  try {
    if (*keys) return fmt::print("{}", swarf::key_reference()), 0;
    if (*materials) return fmt::print("{}", swarf::list_materials()), 0;
    if (*plot || *render || *surface) {
      const swarf::FolderLock lock(existing(folder));
      if (*surface) return swarf::draw_surface(folder, swarf::describe_surface(folder, skip / 100)), 0;
      if (*plot) return swarf::draw_plots(folder), 0;
      if (of_tool) return swarf::render_tool(folder, field), 0;
      if (film) return swarf::render_film(folder), 0;
      return swarf::render_strip(folder) ? 0 : 1;
    }
    model.pictures = !no_pictures;
    if (*mechanistic) return swarf::show_mechanistic(model), 0;
    if (*identify) return swarf::show_identified(identified), 0;
    for (const auto& command : swarf::python_commands)
      if (const CLI::App* python = app.get_subcommand(command.first); *python)
        return swarf::run_python(command.first, python->remaining());
    if (*run) swarf::survive_failed_writes();
    if (spread->count() > 0) options.windows = windows_text;
    options.pictures = !no_pictures, windows.threads = threads;
    if (*run) return ::run(options, windows);
    if (draw->count() > 0 && picture.empty())
      picture = std::filesystem::path(options.deck).stem().string() + "_scene.png";
    const int asked = threads > 0 ? threads : swarf::read_deck(options.deck).run.threads;
    return with_kokkos(asked, [&] { return swarf::check_deck(options.deck, picture), 0; });
  } catch (const std::exception& error) {
    swarf::complain("{}", error.what());
    return 1;
  }
  return 0;
}
