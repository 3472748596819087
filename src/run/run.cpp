#include "src/run/run.hpp"
#include "src/accuracy/accuracy.hpp"
#include "src/check/cost.hpp"
#include "src/check/scene.hpp"
#include "src/files/folder_lock.hpp"
#include "src/files/results.hpp"
#include "src/files/say.hpp"
#include "src/mechanistic/model.hpp"
#include "src/pictures/pictures.hpp"
#include "src/run/progress.hpp"
#include "src/run/recorder.hpp"
#include "src/run/signals.hpp"
#include "src/run/summary.hpp"
#include "src/windows/windows.hpp"
#include <memory>
#include <optional>

namespace swarf {
namespace {

// The steps, until the end, a signal or --stop-after.
struct Going { // a run, and what looks at it on the way
  Simulation& simulation;
  Recorder& recorder;
  Progress& progress;
  const SignalWatch& signals;
  double end; // s
};
void go(const Going& run, const RunOptions& options, RunEnding& ending) {
  const auto& [simulation, recorder, progress, signals, end] = run;
  while (simulation.time() < end && signals.received() == 0) {
    simulation.cut_step(end);
    simulation.step();
    const bool last = simulation.time() >= end; // is looked at as well: its faults must not pass
    if (simulation.steps_to_check() > 0 && !last) continue;
    simulation.check();
    const HistorySample sample = simulation.take_sample();
    recorder.record(sample);
    progress.show(simulation, sample);
    if (options.stop_after > 0 && simulation.step_count() >= options.stop_after) break;
  }
  if (simulation.time() >= end) {
    recorder.write_frame();
    recorder.write_tool_heat();
  } else if (signals.received() != 0) {
    ending = {130, "interrupted", signal_name(signals.received())};
    recorder.write_checkpoint();
  } else {
    ending = {0, "stopped", fmt::format("--stop-after {}", options.stop_after)};
    recorder.write_checkpoint(); // before the frame, which a run that goes on does not have
    recorder.write_frame();
  }
}

// What can still be saved of a run that has failed; the reason for its end stays the first one.
void save_rest(Recorder& recorder, RunEnding& ending, bool with_frame) {
  try {
    if (with_frame) recorder.write_frame();
    recorder.write_checkpoint();
    ending.why += " A last checkpoint has been written.";
  } catch (const std::exception& error) {
    ending.why += fmt::format(" No last checkpoint: {}.", error.what());
  }
}

// What check would have said of the bodies, for those who did not ask.
void speak_of_bodies(const Deck& deck, const Scene& scene) {
  const BodyReport bodies = look_at_bodies(deck, scene);
  for (const std::string& pair : bodies.joined) say("{}\n", pair);
  for (const std::string& pair : bodies.met) say("{}\n", pair);
  for (const std::string& warning : bodies.warnings) complain("warning: {}.", warning);
}

void warn_of_retired(const Simulation& simulation) {
  if (const RetiredCount left = count_retired(simulation.scene().particles); left.met > 0)
    complain(
        "warning: {} of {} particles that left came back to the tool or the work, which did not feel them. "
        "If the force matters there, make retire.distance larger.",
        left.met, left.all);
}

std::vector<std::string> inputs_of(const Deck& deck) {
  std::vector<std::string> inputs{deck.file};
  if (deck.tool && !deck.tool->file.empty()) inputs.push_back(deck.tool->file);
  for (const BodyDeck& body : deck.bodies)
    if (body.has_file()) inputs.push_back(body.file);
  return inputs;
}

// Refuses what must not be written before the scene, which may take minutes, is built.
std::unique_ptr<FolderLock> look_at_folder(const std::string& where, const Deck& deck,
                                           const RunOptions& options) {
  std::unique_ptr<FolderLock> lock;
  if (options.resume) open_results(where);
  std::error_code ignored;
  if (std::filesystem::is_directory(where, ignored)) lock = std::make_unique<FolderLock>(where);
  if (!options.resume) check_free(where, inputs_of(deck), options.overwrite);
  return lock;
}

} // namespace

std::string default_output(const std::string& deck_file) {
  return (std::filesystem::path("results") / std::filesystem::path(deck_file).stem()).string();
}

Deck deck_to_run(const RunOptions& options) {
  const std::string where = options.output.empty() ? default_output(options.deck) : options.output;
  Deck deck = read_deck(options.deck, options.resume ? where : "");
  if (options.whole) deck.windows.reset();
  if (options.windows)
    deck.windows = read_windows_option(*options.windows, deck.windows.value_or(WindowsDeck()));
  return apply_accuracy(deck);
}

int run_deck(const Deck& deck, const RunOptions& options) {
  say("{}", show_pick(deck));
  const std::string where = options.output.empty() ? default_output(options.deck) : options.output;
  std::unique_ptr<FolderLock> lock = look_at_folder(where, deck, options);
  const double end = end_time_of(deck);
  Simulation simulation(deck);
  if (!options.resume) simulation.take_tool_temperature(); // what it refuses leaves no folder behind
  if (!lock) lock = std::make_unique<FolderLock>(where);
  if (simulation.scene().collapsed_facets > 0)
    say("facets of the tool: {}\n", describe_facets(simulation.scene()));
  if (!options.resume) speak_of_bodies(deck, simulation.scene());
  const ResultsFolder folder =
      options.resume ? open_results(where) : create_results(where, options.overwrite);
  Recorder recorder(deck, simulation, folder);
  std::optional<SignalWatch> signals(std::in_place);
  Progress progress(deck, end);
  RunEnding ending;
  try {
    options.resume ? recorder.resume() : recorder.begin();
    refuse_endless(deck, simulation);
    go({simulation, recorder, progress, *signals, end}, options, ending);
  } catch (const SimulationFault& fault) {
    ending = {3, "failed", fault.what()};
    save_rest(recorder, ending, true);
  } catch (const ResultsError& error) { // a full disk
    if (!recorder.has_begun()) throw;
    ending = {1, "failed", fmt::format("{}.", error.what())};
    save_rest(recorder, ending, false);
  }
  progress.finish();
  recorder.watch.close(ending.how == "complete");
  try {
    write_history_results(folder, deck.output.filter_frequency);
    write_summary({folder, deck, simulation, recorder, ending}, progress.seconds());
  } catch (const std::exception&) {
    if (ending.status == 0) throw;
  }
  if (deck.mechanistic) write_table(run_model(deck, *deck.mechanistic), folder.mechanistic());
  signals.reset(); // pictures may be cut short
  report(simulation, progress.seconds());
  warn_of_retired(simulation);
  if (ending.how == "failed") complain("{}", ending.why);
  if (ending.how == "interrupted")
    say("interrupted by {}, checkpoint written; continue with: swarf run {}{} --output {} --resume\n",
        ending.why, options.deck, options.whole ? " --whole" : "", where);
  if (options.pictures && (ending.status == 0 || ending.status == 3)) draw_all(where);
  return ending.status;
}

} // namespace swarf
