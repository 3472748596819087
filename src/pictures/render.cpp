#include "src/pictures/render.hpp"

#include "src/files/say.hpp"
#include "src/pictures/captions.hpp"
#include "src/pictures/render_view.hpp"
#include "src/plots/display.hpp"
#include "src/plots/png.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

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

// What pictures of the same frames share.
struct Look {
  ShownField field;
  Camera camera;
  int labels;
  vtkNew<vtkLookupTable> colours;
};

std::vector<LoadedFrame> load_frames(const ResultsFolder& results, const std::vector<FrameEntry>& entries,
                                     const ShownField& field) {
  if (const std::string why_not = open_display(); !why_not.empty()) throw ResultsError(why_not);
  std::vector<LoadedFrame> frames;
  for (const FrameEntry& entry : entries)
    if (entry.particles || entry.hexes) frames.push_back(load_frame(results, entry, field));
  if (frames.empty())
    throw ResultsError(results.path.string() + ": has no frames to draw; set output.frame_time or "
                                               "output.frame_immersion in the deck and run it again");
  return frames;
}

Look find_look(const std::vector<LoadedFrame>& frames, const ShownField& field,
               const PictureOptions& options) {
  ColourRange range = find_range(shown_parts(frames));
  const int labels = count_labels(range);
  return {field, aim_camera(options, frames), labels, make_colours(range.least, range.most)};
}

struct Shown { // the frames from first to last, of all, which the camera follows
  const std::vector<LoadedFrame>& frames;
  std::size_t first, last;
};
// Views side by side.
void draw_views(const Shown& shown, const Look& look, const fs::path& png) {
  const auto& [frames, first, last] = shown;
  const Camera& camera = look.camera;
  const int n = int(last - first) + 1, columns = n <= 4 || n * camera.width <= 2600 ? n : (n + 1) / 2;
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
    const std::size_t at = first + std::size_t(k);
    const auto view = make_view(frames[at], camera, find_focus(camera, frames, at), look.colours);
    const double left = k % columns * camera.width + (width - views_width) / 2.0;
    const double bottom = height - (k / columns + 1.0) * camera.height, gap = 3; // white, between views
    view->SetViewport((left + gap) / width, (bottom + gap) / height, (left + camera.width - gap) / width,
                      (bottom + camera.height - gap) / height);
    add_text(view, {frame_label(frames[at].entry), 30, 20, double(camera.height - 50)});
    window->AddRenderer(view);
  }
  const auto bar = make_colour_bar(look.colours, look.field.title, look.labels, width);
  add_scale_bar(bar, 2 * camera.half_height / camera.height / units_per_metre);
  bar->SetViewport(0, 0, 1, double(bar_height) / height);
  window->AddRenderer(bar);
  write_png(window, png);
}

// Without those that are missing or damaged, which are said.
std::vector<FrameEntry> list_sound(const ResultsFolder& results, std::vector<FrameEntry> frames) {
  std::erase_if(frames, [&](const FrameEntry& entry) {
    try {
      check_frame(results, entry);
      return false;
    } catch (const ResultsError& error) {
      complain("warning: no picture of frame {}: {}", entry.index, error.what());
      return true;
    }
  });
  return frames;
}

PictureOptions options_of(const Deck& deck) {
  return {word_of(deck.output.picture_field), deck.output.picture_view, 0};
}

// Debian's ffmpeg, from numbered pictures; "" or what went wrong.
std::string make_film(const fs::path& pictures, int per_second, const fs::path& film) {
  const std::string rate = std::to_string(per_second), pattern = (pictures / "%04d.png").string();
  std::vector<std::string> words{
      "ffmpeg",     "-y",         "-loglevel", "error",   "-framerate",
      rate,         "-i",         pattern,     "-vf",     "pad=ceil(iw/2)*2:ceil(ih/2)*2",
      "-c:v",       "libx264",    "-pix_fmt",  "yuv420p", "-movflags",
      "+faststart", film.string()};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, "ffmpeg", nullptr, nullptr, arguments.data(), environ) != 0)
    return "there is no ffmpeg; install it (Debian: ffmpeg)";
  int status = 0;
  if (waitpid(child, &status, 0) != child || status != 0) return "ffmpeg could not make it, see above";
  return "";
}

} // namespace

void draw_frames(const ResultsFolder& results, const std::vector<FrameEntry>& entries,
                 const PictureOptions& options, const fs::path& png) {
  const ShownField field = describe_field(options.field);
  const std::vector<LoadedFrame> frames = load_frames(results, entries, field);
  draw_views({frames, 0, frames.size() - 1}, find_look(frames, field, options), png);
}

void render_film(const std::string& results_folder) {
  const ResultsFolder results = open_results(results_folder);
  const PictureOptions options = options_of(read_deck(results.deck().string(), results.path.string()));
  const ShownField field = describe_field(options.field);
  const std::vector<LoadedFrame> frames =
      load_frames(results, list_sound(results, read_frame_list(results)), field);
  const Look look = find_look(frames, field, options);
  const fs::path single = results.pictures() / "film", film = results.pictures() / "chip.mp4";
  make_folder(single);
  for (std::size_t k = 0; k < frames.size(); ++k)
    draw_views({frames, k, k}, look, single / fmt::format("{:04d}.png", k));
  const int per_second = std::clamp(int(frames.size()) / 8, 4, 25); // about eight seconds
  const std::string why_not = make_film(single, per_second, film);
  fs::remove_all(single);
  if (!why_not.empty()) throw ResultsError(fmt::format("{}: no film: {}", film.string(), why_not));
  say("film: {}, {} frames, {} a second\n", film.string(), frames.size(), per_second);
}

bool render_strip(const std::string& results_folder) {
  const ResultsFolder results = open_results(results_folder);
  const Deck deck = read_deck(results.deck().string(), results.path.string());
  if (const std::string why_not = open_display(); !why_not.empty()) {
    complain("no pictures of the chip: {}", why_not);
    return false;
  }
  make_folder(results.pictures());
  std::vector<double> angles = deck.output.picture_immersion;
  for (double& angle : angles) angle *= 180 / M_PI;
  const auto wanted = choose_frames(read_frame_list(results), angles, deck.output.picture_time);
  const auto chosen = list_sound(results, wanted);
  if (chosen.empty() && !wanted.empty())
    throw ResultsError(fmt::format("{}: not one of the frames to draw is whole", results.frames().string()));
  const PictureOptions options = options_of(deck);
  draw_frames(results, chosen, options, results.pictures() / "chip.png");
  for (const FrameEntry& entry : chosen)
    if (entry.particles || entry.hexes)
      draw_frames(results, {entry}, options,
                  results.pictures() / fmt::format("chip_{:04d}.png", entry.index));
  return chosen.size() == wanted.size();
}

} // namespace swarf
