// The files of a run and when each is due. Frames and checkpoints fall on the next check after their time.
#pragma once
#include "src/output/frame.hpp"
#include "src/output/write_vtk.hpp"
#include "src/run/run_watch.hpp"

namespace swarf {

// Most points that were seen deep inside the tool in any frame.
struct Leaks {
  int particles = 0, nodes = 0;
};

class Recorder {
 public:
  Recorder(const Deck& deck, Simulation& simulation, const ResultsFolder& folder);

  void begin();
  // From the folder's checkpoint. Throws ResultsError that names each key of the deck that must not differ.
  void resume();
  void record(const HistorySample& sample);
  void write_frame(); // the state of now, once
  void write_checkpoint() const;
  void write_tool_heat() const { simulation.write_tool_heat(folder); }
  bool has_begun() const { return frames != nullptr; } // there is a history to go on with
  const Leaks& most_leaked() const { return leaks; }
  RunWatch watch;

 private:
  void check_deck_of(const CheckpointReader& in) const;
  void keep_deck() const;
  void keep_tool() const;
  void keep_bodies() const;
  double next_after(double time, double interval) const;

  const Deck& deck;
  Simulation& simulation;
  ResultsFolder folder;
  double frame_interval, checkpoint_interval;
  int teeth;
  Leaks leaks;
  double next_frame = 0, next_checkpoint = 0, last_frame = -1;
  std::unique_ptr<HistoryFile> history;
  std::unique_ptr<FrameSeries> frames;
};

} // namespace swarf
