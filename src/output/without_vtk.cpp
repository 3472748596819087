// In place of write_parts.cpp and read_parts.cpp where swarf is built without VTK.
#include "src/files/results.hpp"
#include "src/files/say.hpp"
#include "src/output/read_parts.hpp"
#include "src/output/write_parts.hpp"

namespace swarf {

bool can_write_frames() {
  static bool said = false;
  if (!said)
    complain("warning: this swarf was built without VTK (SWARF_PICTURES=OFF): the run writes its history, "
             "results.h5 and checkpoints, but no frames for ParaView and no pictures.");
  said = true;
  return false;
}

std::string write_part(const std::filesystem::path& file, const std::string&, const FrameData&) {
  throw ResultsError(file.string() + ": cannot be written, this swarf was built without VTK");
}

FrameData read_frame(const ResultsFolder& results, const FrameEntry& entry) {
  throw ResultsError(frame_file(results, entry.index, "particles").string() +
                     ": cannot be read, this swarf was built without VTK");
}

} // namespace swarf
