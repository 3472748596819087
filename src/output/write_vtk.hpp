// Frames for ParaView: binary .vtu and .vtp files, and a .pvd that ties them to the time.
#pragma once
#include "src/files/results.hpp"
#include "src/output/frame.hpp"

#include <map>

namespace swarf {

struct FrameEntry {
  int index = 0;
  double time = 0;                                     // s
  std::optional<double> immersion;                     // deg
  bool particles = false, hexes = false, tool = false; // which files it has
  std::map<std::string, std::string> checksums = {};   // of these files, by part; none in lists of old runs
};

std::filesystem::path frame_file(const ResultsFolder& results, int index, const std::string& part);

// frames/frame_NNNN_particles.vtu, _hexes.vtu, _tool.vtp; frames.csv lists them, frames.pvd opens them in
// ParaView. Each file is replaced as a whole and carries no time of day, so equal states give equal files.
// Errors are ResultsError.
class FrameSeries {
 public:
  explicit FrameSeries(const ResultsFolder& folder) : results(folder) {}
  // Restart: keeps the first `frames`, removes the rest, and says which files of the first are missing.
  FrameSeries(const ResultsFolder& folder, int frames);
  void write(const FrameData& frame);
  int count() const { return int(entries.size()); }

 private:
  void write_lists() const;
  ResultsFolder results;
  std::vector<FrameEntry> entries;
};

// What frames.csv lists.
std::vector<FrameEntry> read_frame_list(const ResultsFolder& results);

// VTK's readers believe what a file says of its own lengths: only what the run wrote is shown to them. Throws
// ResultsError.
void check_frame_file(const std::filesystem::path& file, const FrameEntry& entry, const std::string& part);

} // namespace swarf
