// Frames read back, as the run wrote them.
#pragma once
#include "src/output/write_vtk.hpp"

namespace swarf {

// Particles and hexes with the fields that surfaces are judged by: positions, identities, volumes,
// temperatures, plastic strains and stresses; of hexes also who is active. Throws ResultsError.
FrameData read_frame(const ResultsFolder& results, const FrameEntry& entry);

} // namespace swarf
