#include "src/run/recorder.hpp"
#include "src/geometry/flat_facets.hpp"
#include "src/output/restart_deck.hpp"
#include "src/output/write_hdf5.hpp"
#include <cmath>
#include <fmt/ranges.h>

namespace swarf {
namespace {

double frame_interval_of(const Deck& deck) {
  if (deck.output.frame_time) return *deck.output.frame_time;
  if (deck.output.frame_immersion) return *deck.output.frame_immersion / deck.tool->spindle_speed;
  return end_time_of(deck) / 20;
}

} // namespace

Recorder::Recorder(const Deck& from, Simulation& of, const ResultsFolder& into)
    : watch(from), deck(from), simulation(of), folder(into), frame_interval(frame_interval_of(from)),
      checkpoint_interval(from.output.checkpoint_time.value_or(frame_interval)),
      teeth(from.tool ? std::max(1, from.tool->flutes) : 1) {}

double Recorder::next_after(double time, double interval) const {
  return (std::floor(time / interval * (1 + 1e-12)) + 1) * interval;
}

// The folder has all that plots, pictures and restarts need: it may be moved, the deck and its files may go.
void Recorder::keep_deck() const {
  Deck kept = deck;
  if (kept.tool && kept.tool->kind == ToolKind::stl) kept.tool->file = folder.tool().filename().string();
  for (int row = 0; row < int(kept.bodies.size()); ++row)
    if (BodyDeck& body = kept.bodies[std::size_t(row)]; body.has_file())
      body.file = folder.body(row, word_of(body.shape)).filename().string();
  write_file(folder.deck(), resolved_deck(kept));
}

void Recorder::keep_tool() const {
  if (deck.tool && deck.tool->kind == ToolKind::stl)
    write_file(folder.tool(), read_stl_bytes(deck.tool->file)); // to the last bit, in the file's own unit
  else if (deck.tool)
    write_stl(make_tool_surface(*deck.tool, ""), folder.tool().string());
}

// To the last bit, in their own units.
void Recorder::keep_bodies() const {
  for (int row = 0; row < int(deck.bodies.size()); ++row)
    if (const BodyDeck& body = deck.bodies[std::size_t(row)]; body.has_file())
      write_file(folder.body(row, word_of(body.shape)),
                 body.shape == BodyShape::stl ? read_stl_bytes(body.file) : read_text(body.file));
}

void Recorder::begin() {
  keep_deck();
  keep_tool();
  keep_bodies();
  history = std::make_unique<HistoryFile>(folder.history(), teeth); // before start(), which may find a fault
  frames = std::make_unique<FrameSeries>(folder);
  simulation.start();
  record(simulation.take_sample());
}

void Recorder::check_deck_of(const CheckpointReader& in) const {
  const std::string now = restart_text(deck, simulation.scene());
  if (in.deck() == now) return;
  std::vector<std::string> changes = list_restart_changes(in.deck(), now);
  if (changes.empty()) changes = {"the order of its sections"};
  const bool is_end = changes.size() == 1 && changes[0].find("end_") != std::string::npos;
  throw ResultsError(
      fmt::format("{}: belongs to another deck. What a restart must not change has changed: {}{}. "
                  "Resume with the values it was written with (deck.toml in the folder has them), "
                  "or start anew with --overwrite.",
                  folder.checkpoint().string(), fmt::join(changes, "; "),
                  is_end ? ", by which the cells of the tool that conducts heat are laid out" : ""));
}

void Recorder::resume() {
  const CheckpointReader in(folder.checkpoint());
  check_deck_of(in);
  long rows = 0;
  int written = 0;
  double reached = 0, old_frames = 0, old_checkpoints = 0;
  in.get("time", reached), in.get("history_rows", rows), in.get("frames", written);
  in.require(rows >= 0, "history_rows"), in.require(written >= 0, "frames");
  in.require(reached >= 0 && std::isfinite(reached), "time");
  const double end = end_time_of(deck);
  if (end < reached * (1 - 1e-9))
    throw ResultsError(fmt::format(
        "{}: has reached t = {:.6g} s, and run.{} asks for an end at {:.6g} s. Give a "
        "later end, or start anew with --overwrite.",
        folder.checkpoint().string(), reached, deck.run.end_time ? "end_time" : "end_immersion", end));
  simulation.read_state(in);
  watch.read_state(in);
  in.get("next_frame", next_frame), in.get("next_checkpoint", next_checkpoint);
  in.get("frame_interval", old_frames), in.get("checkpoint_interval", old_checkpoints);
  if (old_frames != frame_interval) next_frame = next_after(reached, frame_interval);
  if (old_checkpoints != checkpoint_interval) next_checkpoint = next_after(reached, checkpoint_interval);
  in.get("leaked", leaks.particles), in.get("leaked_nodes", leaks.nodes), in.get("last_frame", last_frame);
  history = std::make_unique<HistoryFile>(folder.history(), teeth, rows);
  frames = std::make_unique<FrameSeries>(folder, written);
  if (!is_same_file(deck.file, folder.deck()) && is_resolved_deck(folder.deck())) keep_deck();
}

void Recorder::record(const HistorySample& sample) {
  history->append(sample);
  watch.look(simulation, sample);
  if (sample.time >= next_frame) {
    write_frame();
    next_frame = next_after(sample.time, frame_interval);
  }
  if (sample.time >= next_checkpoint) {
    next_checkpoint = next_after(sample.time, checkpoint_interval);
    write_checkpoint();
  }
}

void Recorder::write_frame() {
  if (last_frame == simulation.time()) return;
  FrameData frame = copy_frame(simulation.scene().particles, simulation.scene().hexes,
                               simulation.scene().tool, simulation.pose());
  if (!deck.retire.distance) frame.particles.retired.clear();
  frame.tool_fields = simulation.take_tool_fields();
  frame.time = simulation.time();
  if (deck.tool && deck.tool->spindle_speed > 0) frame.immersion = simulation.immersion_deg();
  frames->write(frame);
  last_frame = simulation.time();
  leaks.particles = std::max(leaks.particles, simulation.leaked_particles());
  leaks.nodes = std::max(leaks.nodes, simulation.leaked_nodes());
}

void Recorder::write_checkpoint() const {
  CheckpointWriter out(folder.checkpoint(), restart_text(deck, simulation.scene()));
  simulation.write_state(out);
  watch.write_state(out);
  out.put("history_rows", history->rows()), out.put("frames", frames->count());
  out.put("next_frame", next_frame), out.put("next_checkpoint", next_checkpoint);
  out.put("frame_interval", frame_interval), out.put("checkpoint_interval", checkpoint_interval);
  out.put("leaked", leaks.particles), out.put("leaked_nodes", leaks.nodes), out.put("last_frame", last_frame);
  out.finish();
}

} // namespace swarf
