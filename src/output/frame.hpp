// One picture of the state on the host: what output writes and pictures show.
#pragma once
#include "swarf/hexes/hex_mesh.hpp"
#include "swarf/particles/particles.hpp"
#include "swarf/tool/tool.hpp"

#include <optional>
#include <vector>

namespace swarf {

// State of particles or hexes, one row each; SI. A field without rows is not written.
struct PointFields {
  std::vector<float> temperature, equivalent_plastic_strain, plastic_strain_rate;
  std::vector<float> von_mises, pressure; // Pa, pressure positive in compression
  std::vector<float> stress;              // Pa, 6 a row: xx yy zz xy yz zx
  std::vector<float> damage, volume;
  std::vector<int> material;
};

struct FrameParticles {
  std::vector<float> position, velocity, contact_force; // 3 a row
  std::vector<int> body, identity;
  std::vector<int> retired; // 1: has left for good; 2: and was met
  PointFields state;
};

struct FrameHexes {
  std::vector<float> position, velocity; // of the nodes, 3 a row
  std::vector<int> connectivity;         // 8 a row, VTK order
  std::vector<int> active;               // 0: deleted, 2: frozen
  PointFields state;
};

// Of each facet that is drawn, a patch of the tool's surface (tool_surface.hpp); empty: not known.
struct ToolFields {
  std::vector<float> temperature, contact_pressure, sliding_speed, friction_power, wear_depth; // SI
};

struct FrameData {
  double time = 0;                 // s
  std::optional<double> immersion; // deg; none for scenes without a spindle
  FrameParticles particles;
  FrameHexes hexes;
  std::vector<float> tool; // corners of its patches in the world, 9 a patch
  ToolFields tool_fields;
};

// Copies particles (without the tied ones and the ghosts), hexes and the tool where it stands. time and
// immersion are left to the caller, and what copy_tool_fields gives. The tool has 0 facets in scenes without
// one.
FrameData copy_frame(const Particles& particles, const HexMesh& hexes, const Tool& tool,
                     const ToolPose& pose);
ToolFields copy_tool_fields(const Tool& tool, double duration); // of what was gathered in it, s

} // namespace swarf
