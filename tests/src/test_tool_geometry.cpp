// Generated tools: their measures and motion.
#include "swarf/tool/signed_distance.hpp"
#include "tool_shapes.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace swarf::test {
namespace {

double enclosed_volume(const FacetSurface& s) {
  double sum = 0;
  for (const auto& [a, b, c] : s.facets) {
    const Triple &p = s.vertices[a], &q = s.vertices[b], &r = s.vertices[c];
    sum += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
           p[2] * (q[0] * r[1] - q[1] * r[0]);
  }
  return sum / 6;
}

TEST(EndMill, EdgesReachTheDiameterAtTheirImmersion) {
  for (int flutes = 1; flutes <= 6; ++flutes) {
    const ToolDeck deck = make_mill(flutes);
    const FacetSurface s = make_tool_surface(deck, "");
    double largest = 0;
    for (const Triple& v : s.vertices) largest = std::max(largest, std::hypot(v[0], v[1]));
    EXPECT_NEAR(largest, 400e-6, 1e-15);
    for (int k = 0; k < flutes; ++k) { // tooth k, k pitches counter-clockwise from +y; lagging with z
      for (const double z : {0.0, deck.length}) {
        const double angle = 2 * pi * k / flutes + std::tan(deck.helix) * z / 400e-6;
        const Triple tip{-400e-6 * std::sin(angle), 400e-6 * std::cos(angle), z};
        double nearest = 1;
        for (const Triple& v : s.vertices)
          nearest = std::min(nearest, std::hypot(v[0] - tip[0], v[1] - tip[1], v[2] - tip[2]));
        EXPECT_NEAR(nearest, 0, 1e-15) << flutes << " flutes, tooth " << k;
      }
    }
    EXPECT_LT(s.facets.size(), 20000u);
  }
}

// In the section z = 0 the rake face leaves the rounded edge at the rake angle, the clearance face at its
// own.
TEST(EndMill, EdgeIsAnArcTangentialToRakeAndClearanceFace) {
  const ToolDeck deck = make_mill();
  const FacetSurface s = make_end_mill(deck);
  const double rho = deck.edge_radius, y = 400e-6 - rho;
  int on_arc = 0;
  double first = 10, last = -10; // angles of the arc's normals
  for (const Triple& v : s.vertices)
    if (v[2] == 0 && std::abs(std::hypot(v[0], v[1] - y) - rho) < 1e-9 * rho) {
      const double angle = std::atan2(v[1] - y, v[0]);
      ++on_arc, first = std::min(first, angle), last = std::max(last, angle);
    }
  EXPECT_GE(on_arc, 13);
  EXPECT_NEAR(first, -deck.rake, 1e-9);
  EXPECT_NEAR(last, pi / 2 + deck.clearance, 1e-9);
  // The material of the tooth lies behind the rake face: the tool turns clockwise, so at +y it moves along
  // +x.
  const double depth = 50e-6, x_face = rho - depth * std::tan(deck.rake);
  EXPECT_GT(exact_distance(s, {x_face + 5e-6, 400e-6 - depth, 75e-6 * 0 + 1e-9}), 0);
  EXPECT_LT(exact_distance(s, {x_face - 5e-6, 400e-6 - depth, 1e-9}), 0);
}

TEST(EndMill, RunoutMovesTheAxis) {
  ToolDeck deck = make_mill();
  const FacetSurface centred = make_end_mill(deck);
  deck.runout = 3e-6, deck.runout_angle = 90 * degree; // towards immersion 90 deg: +x
  const FacetSurface moved = make_end_mill(deck);
  for (std::size_t v = 0; v < centred.vertices.size(); ++v) {
    EXPECT_NEAR(moved.vertices[v][0] - centred.vertices[v][0], 3e-6, 1e-15);
    EXPECT_NEAR(moved.vertices[v][1] - centred.vertices[v][1], 0, 1e-15);
  }
}

TEST(EndMill, ManyShapesAreClosedAndOutward) {
  for (const int flutes : {1, 2, 3, 4, 6})
    for (const double rake : {-15.0, 0.0, 12.0})
      for (const double edge : {0.0, 1e-6, 20e-6}) {
        ToolDeck deck = make_mill(flutes);
        deck.rake = rake * degree, deck.edge_radius = edge, deck.core_ratio = 0.6;
        EXPECT_NO_THROW(make_tool_surface(deck, ""))
            << flutes << " flutes, rake " << rake << ", edge " << edge;
      }
}

TEST(EndMill, ImpossibleShapesAreRefusedByKey) {
  const auto refused = [](ToolDeck deck, const std::string& text) {
    try {
      make_tool_surface(deck, "");
      ADD_FAILURE() << "accepted: " << text;
    } catch (const DeckError& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  ToolDeck deck = make_mill();
  deck.flutes = 9, refused(deck, "tool.flutes: expected 1 to 8, got 9");
  deck = make_mill(), deck.core_ratio = 0.05, refused(deck, "tool.core_ratio: the rake face misses the core");
  deck = make_mill(), deck.core_ratio = 0.99, refused(deck, "tool.core_ratio: leaves no flute");
  deck = make_mill(), deck.clearance = 0, refused(deck, "tool.clearance");
  deck = make_mill(), deck.edge_radius = 200e-6, refused(deck, "tool.edge_radius");
  deck = make_wedge_deck(), deck.rake = 89 * degree, refused(deck, "tool.rake");
  deck = make_wedge_deck(), deck.height = 10e-6, refused(deck, "tool.height");
  deck = make_wall_deck(), deck.normal = {0, 0, 0}, refused(deck, "tool.normal");
}

TEST(Wedge, LowestPointOfTheEdgeIsTheOriginAndTheRakeFaceLooksAlongX) {
  const ToolDeck deck = make_wedge_deck();
  const FacetSurface s = make_wedge(deck);
  double lowest = 1, x_lowest = 1;
  for (const Triple& v : s.vertices)
    if (v[1] < lowest) lowest = v[1], x_lowest = v[0];
  EXPECT_NEAR(lowest, 0, 1e-18);
  EXPECT_NEAR(x_lowest, 0, 1e-18);
  // Rake face: n . (x - C) = rho with n = (cos rake, sin rake), C = (0, rho); clearance face likewise.
  const double rho = deck.edge_radius;
  for (const double offset : {-2e-6, 2e-6}) {
    const double up = 200e-6, back = 100e-6;
    const Triple before_rake{(rho + offset) * std::cos(deck.rake) - up * std::sin(deck.rake),
                             rho + (rho + offset) * std::sin(deck.rake) + up * std::cos(deck.rake), 0};
    EXPECT_NEAR(exact_distance(s, before_rake), offset, 1e-12);
    const Triple below{-(rho + offset) * std::sin(deck.clearance) - back * std::cos(deck.clearance),
                       rho - (rho + offset) * std::cos(deck.clearance) + back * std::sin(deck.clearance), 0};
    EXPECT_NEAR(exact_distance(s, below), offset, 1e-12);
  }
}

TEST(Wall, FrontFaceLiesInTheOriginAndLooksAlongTheNormal) {
  const FacetSurface s = make_wall(make_wall_deck());
  EXPECT_NEAR(exact_distance(s, {1e-5, 2e-5, -2e-5}), 3e-5, 1e-15);
  EXPECT_NEAR(exact_distance(s, {-1e-5, -2e-5, 2e-5}), -3e-5, 1e-15);
  EXPECT_NEAR(enclosed_volume(s), 0.25e-9, 1e-15);
}

// --- motion
TEST(ToolPoseTest, TurnsClockwiseAndFeeds) {
  ToolDeck deck = make_mill();
  deck.spindle_speed = 10000 * 2 * pi / 60, deck.feed_per_tooth = 10e-6, deck.feed_direction = {2, 0, 0};
  deck.start_angle = 30 * degree, deck.position = {1e-3, 0, 0};
  const double time = 1e-3; // 60 deg
  EXPECT_NEAR(immersion(deck, time), 90, 1e-9);
  const ToolPose pose = tool_pose(deck, time);
  EXPECT_NEAR(pose.velocity.x, 3.3333333333e-3, 1e-11 * coarse); // 3.33 mm/s, as published
  EXPECT_NEAR(pose.position.x, 1e-3 + 3.3333333333e-6, 1e-14 * coarse);
  EXPECT_NEAR(pose.angular_velocity, -1047.1975512, 1e-6 * coarse);
  // Immersion 90 deg: the edge that was at +y is at +x, and moves along -y.
  const Vector3 tip = pose.position + direction_to_world(make_frame(pose), {0, Real(400e-6), 0});
  EXPECT_NEAR(tip.x - pose.position.x, 400e-6, 1e-14 * coarse);
  EXPECT_NEAR(surface_velocity(pose, tip).y, -0.41887902, 1e-7 * coarse);
}

TEST(ToolPoseTest, FeedNeedsNoSpindleForAStraightMotion) {
  ToolDeck deck = make_wedge_deck();
  deck.velocity = {0.5, 0, 0};
  EXPECT_NEAR(tool_pose(deck, 2e-3).position.x, 1e-3, 1e-15 * coarse);
  EXPECT_EQ(tool_pose(deck, 2e-3).angle, 0);
}

TEST(BuildTool, IsQuickForThePublishedMill) {
  ToolDeck deck = make_mill();
  deck.length = 2e-3;
  const FacetSurface s = make_tool_surface(deck, "");
  const auto start = std::chrono::steady_clock::now();
  const Tool tool = build_tool(s, deck, 5e-6);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_GT(tool.facets, 10000);
  EXPECT_EQ(tool.teeth, 2);
  EXPECT_LT(taken.count(), 10); // s; 0.5 measured, sanitizers and other work take their share
}

} // namespace
} // namespace swarf::test
