#include "src/pictures/render.hpp"

#include "src/files/say.hpp"
#include "src/pictures/captions.hpp"
#include "src/pictures/display.hpp"
#include "src/pictures/png.hpp"
#include "src/pictures/render_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swarf {
namespace fs = std::filesystem;

std::vector<FrameEntry> choose_frames(const std::vector<FrameEntry>& frames,
                                      const std::vector<double>& immersion, const std::vector<double>& time) {
  std::vector<std::size_t> chosen;
  const auto take_nearest = [&](double wish, auto&& value) {
    std::size_t best = frames.size();
    for (std::size_t k = 0; k < frames.size(); ++k)
      if (std::isfinite(value(frames[k])) &&
          (best == frames.size() || std::abs(value(frames[k]) - wish) < std::abs(value(frames[best]) - wish)))
        best = k;
    if (best < frames.size()) chosen.push_back(best);
  };
  for (const double angle : immersion)
    take_nearest(angle, [](const FrameEntry& f) { return f.immersion.value_or(std::nan("")); });
  for (const double t : time) take_nearest(t, [](const FrameEntry& f) { return f.time; });
  if (chosen.empty())
    for (std::size_t k = 0, n = std::min<std::size_t>(4, frames.size()); k < n; ++k)
      chosen.push_back(n == frames.size() ? k : (k + 1) * (frames.size() - 1) / n);
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  std::vector<FrameEntry> out;
  for (const std::size_t k : chosen) out.push_back(frames[k]);
  return out;
}

namespace {

std::vector<vtkPolyData*> shown_parts(const std::vector<LoadedFrame>& frames) {
  std::vector<vtkPolyData*> parts;
  for (const LoadedFrame& frame : frames) parts.push_back(frame.particles), parts.push_back(frame.hexes);
  return parts;
}

} // namespace

void draw_frames(const ResultsFolder& results, const std::vector<FrameEntry>& entries,
                 const PictureOptions& options, const fs::path& png) {
  if (const std::string why_not = open_display(); !why_not.empty()) throw ResultsError(why_not);
  const ShownField field = describe_field(options.field);
  std::vector<LoadedFrame> frames;
  for (const FrameEntry& entry : entries)
    if (entry.particles || entry.hexes) frames.push_back(load_frame(results, entry, field));
  if (frames.empty())
    throw ResultsError(results.path.string() + ": has no frames to draw; set output.frame_time or "
                                               "output.frame_immersion in the deck and run it again");
  const Camera camera = aim_camera(options, frames);
  ColourRange range = find_range(shown_parts(frames));
  const int labels = count_labels(range);
  const auto colours = make_colours(range.least, range.most);

  const int n = int(frames.size()), columns = n <= 4 || n * camera.width <= 2600 ? n : (n + 1) / 2;
  const int rows = (n + columns - 1) / columns;
  // Room for the scale and colour bars even where one narrow view stands alone.
  const int views_width = columns * camera.width, width = std::max(views_width, 800);
  const int height = rows * camera.height + bar_height;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(4);
  window->SetSize(width, height);
  vtkNew<vtkRenderer> paper; // under all views: the last row may have a gap
  paper->SetBackground(1, 1, 1);
  window->AddRenderer(paper);
  for (int k = 0; k < n; ++k) {
    const auto view =
        make_view(frames[std::size_t(k)], camera, find_focus(camera, frames, std::size_t(k)), colours);
    const double left = k % columns * camera.width + (width - views_width) / 2.0;
    const double bottom = height - (k / columns + 1.0) * camera.height, gap = 3; // white, between views
    view->SetViewport((left + gap) / width, (bottom + gap) / height, (left + camera.width - gap) / width,
                      (bottom + camera.height - gap) / height);
    add_text(view, frame_label(frames[std::size_t(k)].entry), 30, 20, camera.height - 50);
    window->AddRenderer(view);
  }
  const auto bar = make_colour_bar(colours, field.title, labels, width);
  add_scale_bar(bar, 2 * camera.half_height / camera.height / units_per_metre);
  bar->SetViewport(0, 0, 1, double(bar_height) / height);
  window->AddRenderer(bar);
  write_png(window, png);
}

bool render_strip(const std::string& results_folder) {
  const ResultsFolder results = open_results(results_folder);
  const Deck deck = read_deck(results.deck().string(), results.tool().string());
  if (const std::string why_not = open_display(); !why_not.empty()) {
    complain("no pictures of the chip: {}", why_not);
    return false;
  }
  make_folder(results.pictures());
  std::vector<double> angles = deck.output.picture_immersion;
  for (double& angle : angles) angle *= 180 / M_PI;
  const auto chosen = choose_frames(read_frame_list(results), angles, deck.output.picture_time);
  const PictureOptions options{deck.output.picture_field, deck.output.picture_view, 0};
  draw_frames(results, chosen, options, results.pictures() / "chip.png");
  for (const FrameEntry& entry : chosen)
    if (entry.particles || entry.hexes)
      draw_frames(results, {entry}, options,
                  results.pictures() / fmt::format("chip_{:04d}.png", entry.index));
  return true;
}

} // namespace swarf
