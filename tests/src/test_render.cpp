#include "src/pictures/render.hpp"
#include "src/plots/display.hpp"
#include "support/pixels.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace fs = std::filesystem;
using namespace swarf;
using ::testing::HasSubstr;

namespace {

constexpr float um = 1e-6f;
constexpr float spacing = 2 * um;

void add_particle(FrameData& frame, float x, float y, float z, float temperature) {
  FrameParticles& p = frame.particles;
  p.position.insert(p.position.end(), {x, y, z});
  p.velocity.insert(p.velocity.end(), {0.42f * float(temperature > 700), 0, 0});
  const float pressed = std::abs(x) < 3 * um && std::abs(y) < 4 * um ? 1e-3f : 0;
  p.contact_force.insert(p.contact_force.end(), {pressed, 0, 0});
  p.state.temperature.push_back(temperature);
  p.state.volume.push_back(spacing * spacing * spacing);
}

// A bar of hexes of edge 4 um below y = -30 um.
void add_hexes(FrameData& frame) {
  FrameHexes& h = frame.hexes;
  const int nx = 40, ny = 5;
  const auto node = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        h.position.insert(h.position.end(), {(4 * i - 100) * um, (4 * j - 51) * um, k * 8 * um});
        h.velocity.insert(h.velocity.end(), {0, 0, 0});
      }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int c[8] = {node(i, j, 0), node(i + 1, j, 0), node(i + 1, j + 1, 0), node(i, j + 1, 0),
                        node(i, j, 1), node(i + 1, j, 1), node(i + 1, j + 1, 1), node(i, j + 1, 1)};
      h.connectivity.insert(h.connectivity.end(), c, c + 8);
      h.active.push_back(1);
      h.state.temperature.push_back(298);
    }
}

// A closed prism of the polygon (x, y), from z0 to z1: the tool.
void add_prism(FrameData& frame, const std::vector<std::array<float, 2>>& xy, float z0, float z1) {
  const auto facet = [&](std::array<float, 3> a, std::array<float, 3> b, std::array<float, 3> c) {
    for (const auto& p : {a, b, c}) frame.tool.insert(frame.tool.end(), p.begin(), p.end());
  };
  const std::size_t n = xy.size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto a = xy[k], b = xy[(k + 1) % n];
    facet({a[0], a[1], z0}, {b[0], b[1], z0}, {b[0], b[1], z1});
    facet({a[0], a[1], z0}, {b[0], b[1], z1}, {a[0], a[1], z1});
    if (k == 0 || k + 1 == n) continue;
    facet({xy[0][0], xy[0][1], z1}, {a[0], a[1], z1}, {b[0], b[1], z1});
    facet({xy[0][0], xy[0][1], z0}, {b[0], b[1], z0}, {a[0], a[1], z0});
  }
}

// Orthogonal cutting of a slice, drawn by hand: the wedge moves to +x, a chip of `turn` rad curls over it.
FrameData chip_frame(float turn, double immersion) {
  FrameData frame;
  frame.time = immersion * 1.6667e-5, frame.immersion = immersion;
  for (int k = 0; k < 4; ++k) {
    const float z = (0.5f + float(k)) * spacing;
    for (float y = -30 * um; y < 10 * um; y += spacing)
      for (float x = -99 * um; x < 60 * um; x += spacing)
        if (x > 24 * um || y < 0)
          add_particle(frame, x, y, z,
                       298 + 500 * std::exp(-std::abs(y) / (3 * um)) *
                                 (x < 0 ? std::exp(x / (40 * um)) : std::exp(-x / (6 * um))));
    const float inner = 25 * um; // of the curl
    for (float r = inner; r < inner + 14 * um; r += spacing)
      for (float a = 0.25f; a < 0.25f + turn; a += spacing / (inner + 7 * um))
        add_particle(frame, inner + 10 * um - r * std::cos(a), 3 * um + r * std::sin(a), z,
                     500 + 500 * (1 - (r - inner) / (14 * um)));
  }
  add_hexes(frame);
  add_prism(frame, {{0, 0}, {-10 * um, 80 * um}, {-80 * um, 80 * um}, {-80 * um, 8 * um}}, -20 * um, 60 * um);
  return frame;
}

ResultsFolder write_run(const fs::path& folder, int frames) {
  const ResultsFolder results = create_results(folder);
  FrameSeries series(results);
  for (int k = 0; k < frames; ++k) series.write(chip_frame(0.3f + 0.6f * float(k), 20 + 15 * k));
  return results;
}

bool is_hot(int r, int g, int b) { return r > 200 && g > 60 && b < 120; }
bool is_bulk(int r, int g, int b) { return b > 70 && r < 60 && g < 60; }
bool is_tool(int r, int g, int b) {
  return r > 120 && r < 230 && std::abs(r - g) < 25 && b >= r && b < r + 40;
}

} // namespace

TEST(Render, strip_shows_bulk_chip_and_tool_in_each_view) {
  if (const std::string why_not = open_display(); !why_not.empty()) GTEST_SKIP() << why_not;
  const TemporaryFolder folder;
  const auto results = write_run(folder / "run", 4);
  const fs::path png = picture(folder, "chip.png");
  draw_frames(results, read_frame_list(results), {}, png);
  const Pixels pixels(png);
  ASSERT_EQ(pixels.width(), 4 * 640);
  int hot_before = 0;
  for (int view = 0; view < 4; ++view) {
    const int from = 640 * view, to = from + 640;
    EXPECT_GT(pixels.count_if(from, to, is_bulk), 20000) << view;
    EXPECT_GT(pixels.count_if(from, to, is_tool), 10000) << view;
    const int hot = pixels.count_if(from, to, is_hot, 130); // above the colour bar
    EXPECT_GT(hot, hot_before) << "the chip grows from view to view";
    hot_before = hot;
  }
}

TEST(Render, oblique_view_of_strain_and_hexes_alone) {
  if (const std::string why_not = open_display(); !why_not.empty()) GTEST_SKIP() << why_not;
  const TemporaryFolder folder;
  const auto results = write_run(folder / "run", 5);
  PictureOptions options;
  options.view = {0.4, -0.5, 0.8}, options.field = "velocity";
  const fs::path png = picture(folder, "oblique.png");
  draw_frames(results, read_frame_list(results), options, png);
  EXPECT_EQ(Pixels(png).width(), 3 * 640);
  EXPECT_EQ(Pixels(png).height(), 2 * 560 + 130);

  FrameData bar;
  add_hexes(bar);
  FrameSeries(create_results(folder / "hexes")).write(bar);
  const fs::path alone = picture(folder, "hexes.png");
  draw_frames({folder / "hexes"}, read_frame_list({folder / "hexes"}), {}, alone);
  EXPECT_GT(Pixels(alone).count_if(0, 640, is_bulk), 20000);
}

TEST(Render, nearest_frames_are_chosen_once_and_in_order) {
  std::vector<FrameEntry> frames;
  for (int k = 0; k < 10; ++k) frames.push_back({k, 0.1 * k, 10.0 * k, true, false, true});
  const auto indices = [](const std::vector<FrameEntry>& list) {
    std::vector<int> out;
    for (const auto& f : list) out.push_back(f.index);
    return out;
  };
  EXPECT_EQ(indices(choose_frames(frames, {61, 18, 22, 500}, {})), (std::vector<int>{2, 6, 9}));
  EXPECT_EQ(indices(choose_frames(frames, {}, {0.31})), (std::vector<int>{3}));
  EXPECT_EQ(indices(choose_frames(frames, {}, {})), (std::vector<int>{2, 4, 6, 9}));
  frames.resize(2);
  EXPECT_EQ(indices(choose_frames(frames, {}, {})), (std::vector<int>{0, 1}));
  EXPECT_TRUE(choose_frames({}, {10}, {}).empty());
}

TEST(Render, says_what_cannot_be_drawn) {
  if (const std::string why_not = open_display(); !why_not.empty()) GTEST_SKIP() << why_not;
  const TemporaryFolder folder;
  const auto results = write_run(folder / "run", 1);
  const auto error = [&](const PictureOptions& options) {
    return message_of<ResultsError>(
        [&] { draw_frames(results, read_frame_list(results), options, folder / "x.png"); });
  };
  PictureOptions options;
  options.field = "colour";
  EXPECT_THAT(error(options), AllOf(HasSubstr("no field 'colour'"), HasSubstr("temperature")));
  write_file(frame_file(results, 0, "particles"), "<VTKFile");
  EXPECT_THAT(error({}), AllOf(HasSubstr("frame_0000_particles.vtu"), HasSubstr("damaged")));
  fs::remove(frame_file(results, 0, "particles"));
  EXPECT_THAT(error({}), HasSubstr("is missing, though frames.csv lists it"));
  EXPECT_THAT(message_of<ResultsError>([&] { draw_frames(results, {}, {}, folder / "x.png"); }),
              HasSubstr("has no frames"));
}

// Nothing may abort where no display can be had: VTK itself would.
TEST(Render, no_display_is_a_message) {
  const char* path = std::getenv("PATH");
  const char* display = std::getenv("DISPLAY");
  const std::string old_path = path ? path : "", old_display = display ? display : "";
  setenv("PATH", "/nowhere", 1), setenv("DISPLAY", ":4711", 1);
  {
    const Display none;
    EXPECT_FALSE(none.ready());
    EXPECT_THAT(none.reason(), AllOf(HasSubstr("Xvfb"), HasSubstr("install the package xvfb")));
  }
  setenv("PATH", old_path.c_str(), 1);
  if (display)
    setenv("DISPLAY", old_display.c_str(), 1);
  else
    unsetenv("DISPLAY");
}
