// What `swarf surface` says of work whose surface, stresses and strains are known; and of a short cut.
#include "src/files/results.hpp"
#include "src/surface/surface.hpp"
#include "tests/src/scene_decks.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/small_deck.hpp"
#include "tests/support/temporary_folder.hpp"
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double dx = 5 * um;

Deck wedge_deck() {
  Deck deck = empty_deck();
  deck.bodies = {block("work", "particles", {0, -50 * um, 0}, {300 * um, 50 * um, 10 * um}, dx)};
  ToolDeck tool(ToolKind::wedge);
  tool.velocity = {1, 0, 0};
  deck.tool = tool;
  return deck;
}

struct Known {
  double stress_xx, stress_zz, strain; // Pa
};

void add(FrameData& frame, const Triple& x, const Known& known) {
  FrameParticles& p = frame.particles;
  for (const double c : x) p.position.push_back(float(c));
  p.identity.push_back(int(p.identity.size()));
  for (const double s : {known.stress_xx, 0.0, known.stress_zz, 0.0, 0.0, 0.0})
    p.state.stress.push_back(float(s));
  p.state.equivalent_plastic_strain.push_back(float(known.strain));
  p.state.temperature.push_back(300), p.state.volume.push_back(float(dx * dx * dx));
}

// Strips of 5 um whose tops are by turns 1 um above and below the path of the tool; the stress falls by 100
// MPa a layer. A chip flies above, and a burr of three particles stands where the cut began.
FrameData known_work() {
  FrameData frame;
  frame.time = 200e-6; // 200 um
  for (int i = 0; i < 60; ++i)
    for (int layer = 0; layer < 10; ++layer)
      for (int k = 0; k < 2; ++k) {
        const double top = layer == 0 ? (i % 2 ? 1 : -1) * um : 0;
        add(frame, {(i + 0.5) * dx, -(layer + 0.5) * dx + top, (k + 0.5) * dx},
            {(100.0 * layer - 500) * 1e6, 200e6, 1.0 / (layer + 1)});
      }
  for (int k = 0; k < 3; ++k) add(frame, {1.5 * dx, (k + 0.5) * dx + um, 0.5 * dx}, {0, 0, 3});
  for (int i = 0; i < 60; ++i) add(frame, {(i + 0.5) * dx, 40 * um, 0.5 * dx}, {9e9, 9e9, 9});
  return frame;
}

} // namespace

TEST(Surface, MeasuresWhatIsKnown) {
  const WorkSurface w = measure_surface(MachinedSurface(wedge_deck()), known_work(), 0.2);
  EXPECT_NEAR(w.spacing, dx, 1e-6 * dx);
  EXPECT_NEAR(w.from, 2.5 * um + 0.2 * 197.5 * um, 0.01 * um);
  EXPECT_NEAR(w.to, 200 * um - 0.2 * 197.5 * um, 0.01 * um);
  EXPECT_NEAR(w.mean_height, 0, 0.05 * um);
  EXPECT_NEAR(w.Ra, 1 * um, 0.01 * um);
  EXPECT_NEAR(w.Rz, 2 * um, 0.01 * um);
  EXPECT_NEAR(w.burr, 16 * um, 0.01 * um);
  EXPECT_NEAR(w.burr_along, 7.5 * um, 0.01 * um);
  ASSERT_EQ(w.layers.size(), 10u);
  for (int k = 0; k < 10; ++k) {
    const DepthLayer& l = w.layers[std::size_t(k)];
    EXPECT_NEAR(l.depth, (k + 0.5) * dx, 0.06 * um) << k;
    EXPECT_NEAR(l.along, (100.0 * k - 500) * 1e6, 1e3) << k;
    EXPECT_NEAR(l.across, 200e6, 1e3) << k;
    EXPECT_NEAR(l.normal, 0, 1e3) << k;
    EXPECT_NEAR(l.along_scatter, 0, 1e6) << k;
    EXPECT_NEAR(l.plastic_strain, 1.0 / (k + 1), 1e-6) << k;
  }
  EXPECT_EQ(w.outermost.size(), 2 * w.strip.size());
}

// The tip of tooth 0 lies in the surface, as far along as it has come; the work is outside.
TEST(Surface, OfAMillIsWhereTheTipHasBeen) {
  const TemporaryFolder folder;
  const Deck deck = read_deck(folder.write("deck.toml", small_deck));
  const MachinedSurface surface(deck);
  const MillMotion mill{*deck.tool, deck.bodies.front().origin};
  for (const double degrees : {85.0, 86.0}) {
    const double immersion = degrees * degree;
    const Triple centre = mill.position(immersion);
    const Eigen::Vector3d tip(centre[0] + 400 * um * std::sin(immersion),
                              centre[1] + 400 * um * std::cos(immersion), 0);
    const SurfacePlace at = surface.place(tip), in_work = surface.place(tip * (1 + 5 * um / tip.norm()));
    EXPECT_NEAR(at.above, 0, 1e-3 * um);
    EXPECT_NEAR(at.along, surface.passed((immersion - deck.tool->start_angle) / deck.tool->spindle_speed),
                1e-3 * um);
    EXPECT_NEAR(in_work.above, -5 * um, 1e-3 * um);
    EXPECT_LT(at.normal.dot(tip), 0) << "out of the work, towards the axis";
    EXPECT_LT(at.direction.y(), 0) << "clockwise";
  }
}

TEST(Surface, DescribesAShortCut) {
  const TemporaryFolder folder;
  const std::string deck = folder.write(
      "cut.toml",
      edit_small_deck({{"start_angle = \"84.8 deg\"\n",
                        "start_angle = \"84.8 deg\"\nlift_time = \"60 us\"\nlift_velocity = [\"-5 m/s\", "
                        "\"0 m/s\", \"0 m/s\"]\n"},
                       {"end_immersion = \"86.5 deg\"", "end_immersion = \"89 deg\""}}));
  const Ended run = run_program(run_arguments(deck, folder / "cut"));
  ASSERT_EQ(run.status, 0) << run.output;
  const Ended end = run_program({"surface", (folder / "cut").string(), "--skip", "10"});
  EXPECT_EQ(end.status, 0) << end.output;
  EXPECT_EQ(end.output.find("has not lifted off"), std::string::npos) << end.output;
  const std::string table = read_text(folder / "cut" / "surface.csv");
  EXPECT_GT(std::count(table.begin(), table.end(), '\n'), 4) << table;
  EXPECT_TRUE(table.starts_with("depth [m],volume [m3],stress_along [Pa]")) << table;
  EXPECT_TRUE(std::filesystem::exists(folder / "cut" / "surface_history.csv"));
}

TEST(Surface, RefusesToolsWithoutACut) {
  Deck deck = wedge_deck();
  deck.tool->kind = ToolKind::wall;
  EXPECT_NE(message_of<ResultsError>([&] { MachinedSurface{deck}; }).find("only a wedge and an end mill"),
            std::string::npos);
}
