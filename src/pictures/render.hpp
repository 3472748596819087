// Pictures of the chip by immersion angle, from the frames of a run.
#pragma once
#include "src/deck/deck.hpp"
#include "src/files/results.hpp"
#include "src/output/write_vtk.hpp"

namespace swarf {

struct PictureOptions {
  std::string field =
      "temperature";       // or equivalent_plastic_strain, plastic_strain_rate, von_mises, velocity, ...
  Triple view{0, 0, 1};    // direction from the scene to the camera
  double window = 0;       // m across a view; 0: all particles, or where the tool cuts if they are many
  bool everything = false; // hexes and the tool as well
};

// The frame nearest to each asked angle (deg) or time (s), each once, in order of time. Nothing asked: up to
// four, spread over the run, of the frames in which the tool has come to the material, as far as they are
// known.
std::vector<FrameEntry> choose_frames(const std::vector<FrameEntry>& frames,
                                      const std::vector<double>& immersion, const std::vector<double>& time);

// One view per frame, side by side, with one scale and one colour bar. Throws ResultsError (no display, a
// frame that cannot be read, a field that it has not).
void draw_frames(const ResultsFolder& results, const std::vector<FrameEntry>& frames,
                 const PictureOptions& options, const std::filesystem::path& png);

// pictures/chip.png, the strip, and pictures/chip_NNNN.png, each of its views alone, as the deck in the
// folder says. Without a display it says so on stderr and returns false: a long run must not die of it.
bool render_strip(const std::string& results_folder);

// pictures/tool_FIELD.png: rake and flank of the tool in up to four frames, coloured by a field of its
// surface
// ("": its temperature, or the pressure where it has none). Throws ResultsError.
void render_tool(const std::string& results_folder, const std::string& field);
// pictures/chip.mp4 of all frames, with one scale, by ffmpeg. Throws ResultsError.
void render_film(const std::string& results_folder);

} // namespace swarf
