#include "src/pictures/draw_scene.hpp"
#include "src/pictures/render.hpp"
#include "src/plots/display.hpp"
#include "src/tool/geometry.hpp"
#include <cerrno>
#include <cstdlib>
#include <filesystem>

namespace swarf {
namespace fs = std::filesystem;
namespace {

// Frames go through files, as those of a run do.
class PassingFolder {
 public:
  PassingFolder() : name((fs::temp_directory_path() / "swarf_scene_XXXXXX").string()) {
    if (!mkdtemp(name.data())) fail_to(name, "make a folder for the picture's frames", errno);
  }
  ~PassingFolder() {
    std::error_code ignored;
    fs::remove_all(name, ignored);
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  std::string name;
};

} // namespace

void draw_scene(const Deck& deck, const Scene& scene, const std::string& png) {
  if (const std::string why_not = open_display(); !why_not.empty()) throw ResultsError(why_not);
  const PassingFolder folder;
  const ResultsFolder results = create_results(folder.name);
  FrameSeries frames(results);
  const int views = deck.tool ? 4 : 1;
  for (int k = 0; k < views; ++k) {
    const double time = views > 1 ? end_time_of(deck) * k / (views - 1) : 0;
    FrameData frame = copy_frame(scene.particles, scene.hexes, scene.tool,
                                 deck.tool ? tool_pose(*deck.tool, time) : ToolPose{});
    frame.time = time;
    if (deck.tool && deck.tool->spindle_speed > 0) frame.immersion = immersion(*deck.tool, time);
    frames.write(frame);
  }
  PictureOptions options{"material", deck.output.picture_view, 0};
  options.everything = true;
  draw_frames(results, read_frame_list(results), options, png);
}

} // namespace swarf
