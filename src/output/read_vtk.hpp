// Frames read back, as the run wrote them.
#pragma once
#include "src/output/write_vtk.hpp"

namespace swarf {

// VTK's readers believe what a file says of its own lengths: only what the run wrote is shown to them. Throws
// ResultsError.
void check_frame_file(const std::filesystem::path& file, const FrameEntry& entry, const std::string& part);

// Particles and hexes with the fields that surfaces are judged by: positions, identities, volumes,
// temperatures, plastic strains and stresses; of hexes also who is active. Throws ResultsError.
FrameData read_frame(const ResultsFolder& results, const FrameEntry& entry);

} // namespace swarf
