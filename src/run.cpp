#include "src/run.hpp"
#include "src/accuracy.hpp"
#include "src/frame.hpp"
#include "src/pictures.hpp"
#include "src/progress.hpp"
#include "src/results.hpp"
#include "src/summary.hpp"
#include "src/windows.hpp"
#include "src/write_hdf5.hpp"
#include "src/write_vtk.hpp"
#include <cmath>
#include <csignal>
#include <fmt/format.h>
#include <memory>
#include <numbers>

namespace swarf {
namespace {

volatile std::sig_atomic_t interrupted = 0;
void on_interrupt(int) { interrupted = 1; }

double frame_interval_of(const Deck& deck, double end) {
  if (deck.output.frame_time) return *deck.output.frame_time;
  if (deck.output.frame_immersion) return *deck.output.frame_immersion / deck.tool->spindle_speed;
  return end / 20;
}

// The run's files and when each is due. Frames and checkpoints fall on the next check after their time.
class Recorder {
 public:
  Recorder(const Deck& from, Simulation& of, const ResultsFolder& into, double end)
      : deck(from), simulation(of), folder(into), frame_interval(frame_interval_of(from, end)),
        checkpoint_interval(from.output.checkpoint_time.value_or(frame_interval)),
        teeth(from.tool ? std::max(1, from.tool->flutes) : 1) {}

  void begin() {
    write_file(folder.deck(), resolved_deck(deck));
    if (deck.tool)
      write_stl(make_tool_surface(*deck.tool, std::filesystem::path(deck.file).parent_path().string()),
                (folder.path / "tool.stl").string());
    history =
        std::make_unique<HistoryFile>(folder.history(), teeth); // before start(), which may find a fault
    frames = std::make_unique<FrameSeries>(folder);
    simulation.start();
    record(simulation.sample());
  }

  void resume() {
    const CheckpointReader in(folder.checkpoint());
    if (in.deck_hash() != hash_scene())
      throw ResultsError(folder.checkpoint().string() +
                         ": belongs to another deck, or its tool's file has "
                         "changed since. Resume with the deck it was written with, or start anew.");
    simulation.read_state(in);
    long rows = 0;
    int written = 0;
    in.get("history_rows", rows), in.get("frames", written);
    in.get("next_frame", next_frame), in.get("next_checkpoint", next_checkpoint);
    in.get("leaked", leaked), in.get("last_frame", last_frame);
    history = std::make_unique<HistoryFile>(folder.history(), teeth, rows);
    frames = std::make_unique<FrameSeries>(folder, written);
  }

  void record(const HistorySample& sample) {
    history->append(sample);
    if (sample.time >= next_frame) {
      write_frame();
      next_frame = (std::floor(sample.time / frame_interval * (1 + 1e-12)) + 1) * frame_interval;
    }
    if (sample.time >= next_checkpoint) {
      next_checkpoint =
          (std::floor(sample.time / checkpoint_interval * (1 + 1e-12)) + 1) * checkpoint_interval;
      write_checkpoint();
    }
  }

  // The state of now, once.
  void write_frame() {
    if (last_frame == simulation.time()) return;
    last_frame = simulation.time();
    FrameData frame = copy_frame(simulation.scene().particles, simulation.scene().hexes,
                                 simulation.scene().tool, simulation.pose());
    if (!deck.retire.distance) frame.particles.retired.clear();
    frame.time = simulation.time();
    if (deck.tool && deck.tool->spindle_speed > 0) frame.immersion = simulation.immersion_deg();
    frames->write(frame);
    leaked = std::max(leaked, simulation.leaked_particles());
  }

  void write_checkpoint() const {
    CheckpointWriter out(folder.checkpoint(), hash_scene());
    simulation.write_state(out);
    out.put("history_rows", history->rows()), out.put("frames", frames->count());
    out.put("next_frame", next_frame), out.put("next_checkpoint", next_checkpoint);
    out.put("leaked", leaked), out.put("last_frame", last_frame);
    out.finish();
  }

  int most_leaked() const { return leaked; }

 private:
  // The deck, and the tool's facets, which may come from a file that the deck only names.
  std::string hash_scene() const {
    std::string text = resolved_deck(deck);
    for (const auto& facet : simulation.scene().tool_facets)
      for (const auto& corner : facet)
        text.append(reinterpret_cast<const char*>(corner.data()), 3 * sizeof(corner[0]));
    return hash_text(text);
  }

  const Deck& deck;
  Simulation& simulation;
  ResultsFolder folder;
  double frame_interval, checkpoint_interval;
  int teeth, leaked = 0;
  double next_frame = 0, next_checkpoint = 0, last_frame = -1;
  std::unique_ptr<HistoryFile> history;
  std::unique_ptr<FrameSeries> frames;
};

} // namespace

std::string default_output(const std::string& deck_file) {
  return (std::filesystem::path("results") / std::filesystem::path(deck_file).stem()).string();
}

Deck deck_to_run(const RunOptions& options) {
  Deck deck = read_deck(options.deck);
  if (options.whole) deck.windows.reset();
  if (!options.windows.empty())
    deck.windows = read_windows_option(options.windows, deck.windows.value_or(default_windows()));
  return apply_accuracy(deck);
}

int run_deck(const Deck& deck, const RunOptions& options) {
  fmt::print("{}", show_pick(deck));
  const std::string where = options.output.empty() ? default_output(options.deck) : options.output;
  const double end = end_time_of(deck);
  Simulation simulation(deck);
  const ResultsFolder folder = options.resume ? open_results(where) : create_results(where);
  Recorder recorder(deck, simulation, folder, end);
  std::signal(SIGINT, on_interrupt), std::signal(SIGTERM, on_interrupt);
  Progress progress(deck, end);
  int exit_status = 0;
  std::string ended = "complete";
  try {
    if (options.resume)
      recorder.resume();
    else
      recorder.begin();
    while (simulation.time() < end && !interrupted) {
      simulation.step();
      const bool last = simulation.time() >= end; // is looked at as well: its faults must not pass
      if (simulation.steps_to_check() > 0 && !last) continue;
      simulation.check();
      const HistorySample sample = simulation.sample();
      recorder.record(sample);
      progress.show(simulation, sample);
      if (options.stop_after > 0 && simulation.step_count() >= options.stop_after) break;
    }
    if (interrupted && simulation.time() < end)
      ended = "interrupted", exit_status = 130, recorder.write_checkpoint();
    else
      recorder.write_frame();
  } catch (const SimulationFault& fault) {
    ended = fault.what(), exit_status = 3;
    recorder.write_frame();
    recorder.write_checkpoint();
  }
  std::signal(SIGINT, SIG_DFL), std::signal(SIGTERM, SIG_DFL); // pictures may be cut short
  progress.finish();
  write_history_results(folder, deck.output.filter_frequency);
  write_summary(folder, deck, simulation, ended, progress.seconds(), recorder.most_leaked());
  report(simulation, progress.seconds());
  if (const RetiredCount left = count_retired(simulation.scene().particles); left.met > 0)
    fmt::print(
        stderr,
        "swarf: warning: {} of {} particles that left came back to the tool or the work, which did not "
        "feel them. If the force matters there, make retire.distance larger.\n",
        left.met, left.all);
  if (exit_status == 3) fmt::print(stderr, "swarf: {}\n", ended);
  if (exit_status == 130)
    fmt::print("interrupted; continue with: swarf run {}{} --output {} --resume\n", options.deck,
               options.whole ? " --whole" : "", where);
  if (options.pictures && exit_status != 130) draw_all(where);
  return exit_status;
}

} // namespace swarf
