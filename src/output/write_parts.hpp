// The files of a frame, by VTK. A build without it (SWARF_PICTURES=OFF) has without_vtk.cpp in its place.
#pragma once
#include "src/output/frame.hpp"
#include <filesystem>
#include <string>

namespace swarf {

bool can_write_frames(); // says once if it cannot

// The part "particles", "hexes" or "tool" of a frame, and the checksum of its file. Throws ResultsError.
std::string write_part(const std::filesystem::path& file, const std::string& part, const FrameData& frame);

} // namespace swarf
