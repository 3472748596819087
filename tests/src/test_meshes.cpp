// Bodies whose hexes or particles come from a file: Abaqus' text of nodes and elements, rows of particles.
#include "src/geometry/lattice.hpp"
#include "tests/src/stl_bodies.hpp"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;
using testing::AllOf;
using testing::HasSubstr;

namespace {

const double round_off = sizeof(Real) == 8 ? 1e-12 : 1e-4;

// The hexes of a block as Abaqus writes them, with numbers that are neither dense nor sorted; edges in mm.
std::string abaqus_text(const HexSet& set, const std::string& more = "") {
  std::string text = "*Heading\n** a comment\n*Part, name=WORK\n*Node\n";
  const auto label = [&](int n) { return 3 * (int(set.node.size()) - n); };
  for (int n = 0; n < int(set.node.size()); ++n) {
    const Point& x = set.node[std::size_t(n)];
    text += fmt::format("{:7}, {:.17g}, {:.17g}, {:.17g}\n", label(n), 1e3 * x.x(), 1e3 * x.y(), 1e3 * x.z());
  }
  text += "      999999, 5., 5., 5.\n*Element, type=C3D8R\n"; // a node of no hex
  for (std::size_t h = 0; h < set.hex.size(); ++h) {
    text += fmt::format("{},", 2 * h + 1);
    for (std::size_t a = 0; a < 8; ++a)
      text += fmt::format(" {}{}", label(set.hex[h][a]), a == 7 ? "\n" : a == 4 ? ",\n" : ",");
  }
  text += "*Nset, nset=Base\n";
  const auto& base = set.faces.at("z_min");
  for (std::size_t k = 0; k < base.size(); ++k)
    text += fmt::format("{}{}", label(base[k]), k + 1 == base.size() ? "\n" : k % 16 == 15 ? ",\n" : ", ");
  return text + more + "*Elset, elset=all, generate\n 1, 9, 1\n*End Part\n";
}

HexSet block_of_hexes() {
  const Deck deck = deck_with({block("b", "hexes", {1e-3, 0, 0}, {4e-3, 2e-3, 3e-3}, 0.5e-3)});
  return fill_hexes(make_shape(deck, deck.bodies[0]));
}

BodyDeck mesh_body(const std::string& file, const std::string& fill) {
  BodyDeck b = body("m", "mesh", fill);
  b.file = file, b.file_scale = 1e-3;
  return b;
}

std::string fault_of(const std::string& text, const std::string& fill = "hexes",
                     const std::string& face = "") {
  const TemporaryFolder folder;
  BodyDeck b = mesh_body(folder.write("m.inp", text), fill);
  if (!face.empty()) b.faces = {{face, FaceKind::fixed}};
  return message_of<DeckError>([&] { build_scene(deck_with({b})); });
}

const std::string one_hex = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n"
                            "7, 1, 1, 1\n8, 0, 1, 1\n*ELEMENT, TYPE=C3D8R\n";

} // namespace

TEST(Meshes, HexesAreThoseOfTheFile) {
  const TemporaryFolder folder;
  const HexSet set = block_of_hexes();
  BodyDeck mesh = mesh_body(folder.write("m.inp", abaqus_text(set)), "hexes");
  mesh.origin = {0, 0, 7e-3};
  mesh.faces = {{"BASE", FaceKind::fixed}}; // names as Abaqus compares them
  const Scene scene = build_scene(deck_with({mesh}));
  ASSERT_EQ(scene.hexes.points.count, int(set.hex.size()));
  ASSERT_EQ(scene.hexes.nodes, int(set.node.size())) << "without the one that has no hex";
  EXPECT_NEAR(sum(scene.hexes.mass, scene.hexes.nodes) / (4430 * 24e-9), 1, round_off);
  const auto x = host_copy(scene.hexes.position);
  const auto bits = host_copy(scene.hexes.constraints);
  for (int n = 0; n < scene.hexes.nodes; ++n) {
    const Point& expected = set.node[std::size_t(n)];
    EXPECT_NEAR(x(n, 0), expected.x(), 1e-15 * coarse);
    EXPECT_NEAR(x(n, 2), expected.z() + 7e-3, 1e-15 * coarse);
    EXPECT_EQ((bits(n) & 1u) != 0, expected.z() == 0);
  }
  const Deck deck = deck_with({mesh});
  const Shape shape = make_shape(deck, deck.bodies[0]);
  EXPECT_NEAR(shape.volume() / 24e-9, 1, round_off);
  EXPECT_NEAR(shape.signed_distance({3e-3, 1e-3, 8.25e-3}), -1e-3, 1e-12 * coarse);
  EXPECT_NEAR(shape.signed_distance({0, 1e-3, 8.25e-3}), 1e-3, 1e-12 * coarse);
}

// Bottom and top exchanged is an order that some programs write, and can only mean one hex.
TEST(Meshes, OrdersAreMendedOrRefused) {
  const TemporaryFolder folder;
  const Scene scene =
      build_scene(deck_with({mesh_body(folder.write("m.inp", one_hex + "1, 5,6,7,8, 1,2,3,4\n"), "hexes")}));
  EXPECT_NEAR(sum(scene.hexes.points.mass, 1) / 4430e-9, 1, round_off);
  EXPECT_THAT(fault_of(one_hex + "1, 1,2,4,3, 5,6,8,7\n"),
              AllOf(HasSubstr("test.toml:7: body.file: \"m\""), HasSubstr("m.inp:11: element 1 is turned"),
                    HasSubstr("mend it in the program")));
  for (const std::string top : {"6,7,8,5", "7,8,5,6"}) // by a quarter, by a half
    EXPECT_THAT(fault_of(one_hex + "1, 1,2,3,4, " + top + "\n"), HasSubstr(":11: element 1 is twisted"));
  EXPECT_THAT(fault_of(one_hex + "1, 1,2,3,3, 5,6,7,7\n"),
              HasSubstr("inside out or flat at 4 of its corners"));
}

TEST(Meshes, FaultsAreRefused) {
  const std::string good = one_hex + "1, 1,2,3,4, 5,6,7,8\n";
  EXPECT_EQ(fault_of(good), "");
  EXPECT_THAT(fault_of(""), HasSubstr("holds no hexes: expected *NODE and *ELEMENT"));
  EXPECT_THAT(fault_of(good + "*ELEMENT, TYPE=C3D4\n2, 1,2,3,5\n"), HasSubstr(":12: elements of type C3D4"));
  EXPECT_THAT(fault_of(one_hex + "1, 1,2,3,4, 5,6,7,9\n"), HasSubstr(":11: there is no node 9"));
  EXPECT_THAT(fault_of(one_hex + "1, 1,2,3,4, 5,6,7\n"), HasSubstr(":11: element 1 has 7 nodes: expected 8"));
  EXPECT_THAT(fault_of("*NODE\n1, 0, x, 0\n"), HasSubstr(":2: expected a number in column 3, got \"x\""));
  EXPECT_THAT(fault_of("*NODE\n1, 0, 0, 0\n1, 0, 0, 1\n"), HasSubstr(":3: node 1 is there already"));
  EXPECT_THAT(fault_of("*PART\n*PART\n"), HasSubstr(":2: begins a second part"));
  EXPECT_THAT(fault_of(good + "2, 2,3,4,1, 6,7,8,5\n"),
              HasSubstr(":12: element 2 has the nodes of element 1"));
  EXPECT_THAT(fault_of("*NODE, SYSTEM=C\n"), HasSubstr(":1: *NODE has a system of its own"));
  EXPECT_THAT(fault_of("*NODE, INPUT=nodes.txt\n"), HasSubstr(":1: *NODE has a system of its own, a file"));
  EXPECT_EQ(fault_of("\xef\xbb\xbf" + good), "");
  EXPECT_EQ(fault_of(good + "*NSET, NSET=Left\n1, 4\n*NSET, NSET=LEFT\n5, 8\n", "hexes", "left"), "");
  EXPECT_THAT(fault_of("*NGEN\n1,2\n"), HasSubstr(":1: *NGEN makes or moves nodes"));
  EXPECT_THAT(fault_of(good + "*NSET, NSET=left\n1, 4\n", "hexes", "rihgt"),
              AllOf(HasSubstr("body.faces.rihgt: \"m\" finds no set \"rihgt\" in its file"),
                    HasSubstr("Its sets are left")));
}

TEST(Meshes, ParticlesAreThoseOfTheFile) {
  const TemporaryFolder folder;
  const std::string rows =
      "# x, y, z, volume, sets\n0, 0, 0, 8, clamp\n2, 0, 0, 8\n+4.0E0, 0, 0, 4.\n4, 2, 0, 8\n";
  BodyDeck points = mesh_body(folder.write("p.csv", rows), "particles");
  points.faces = {{"clamp", FaceKind::velocity, {1, 0, 0}}};
  const Scene scene = build_scene(deck_with({points}));
  ASSERT_EQ(scene.particles.count, 4);
  EXPECT_NEAR(sum(scene.particles.points.mass, 4) / (4430 * 28e-9), 1, round_off);
  const auto x = host_copy(scene.particles.position);
  EXPECT_NEAR(x(2, 0), 4e-3, 1e-15 * coarse);
  const auto bits = host_copy(scene.particles.constraints);
  EXPECT_EQ(bits(0) & 1u, 1u);
  EXPECT_EQ(bits(1) & 1u, 0u);
  EXPECT_THAT(fault_of("0, 0, 0\n", "particles"), HasSubstr(":1: has 3 numbers"));
  EXPECT_THAT(fault_of("0, 0, 0, -1\n", "particles"), HasSubstr("volume that is not more than 0"));
  EXPECT_THAT(fault_of("0, 0, 0, 1\n1, 0, 0, 9\n", "particles"), HasSubstr("at most 8 times as much"));
  EXPECT_THAT(fault_of(one_hex, "particles"), HasSubstr(":1: a mesh of particles has no keywords"));
}

// A lattice of particles from a file is tied as the block that it is; what is no lattice cannot be continued.
TEST(Meshes, TiedParticlesContinueTheirLattice) {
  const TemporaryFolder folder;
  const Deck blocks = deck_with({block("z", "particles", {0, 0, 0}, {4e-3, 4e-3, 2e-3}, 0.5e-3)});
  const PointSet set = fill_points(make_shape(blocks, blocks.bodies[0]));
  const auto rows = [&](double askew) {
    std::string text;
    for (std::size_t i = 0; i < set.position.size(); ++i) {
      const Point& x = set.position[i];
      text += fmt::format("{:.17g}, {:.17g}, {:.17g}, {:.17g}\n", 1e3 * (x.x() + askew * x.z()), 1e3 * x.y(),
                          1e3 * x.z(), 1e9 * set.volume[i]);
    }
    return text;
  };
  const BodyDeck bulk = block("bulk", "hexes", {0, 0, -4e-3}, {4e-3, 4e-3, 4e-3}, 1e-3);
  BodyDeck zone = mesh_body(folder.write("p.csv", rows(0)), "particles"), of_block = blocks.bodies[0];
  zone.tie = of_block.tie = "bulk";
  const Scene scene = build_scene(deck_with({zone, bulk})),
              expected = build_scene(deck_with({of_block, bulk}));
  EXPECT_EQ(scene.tie.count, expected.tie.count);
  EXPECT_NEAR(sum(scene.particles.volume, scene.particles.points.count) /
                  sum(expected.particles.volume, expected.particles.points.count),
              1, 10 * round_off);
  zone.file = folder.write("q.csv", rows(0.3));
  EXPECT_THAT(message_of<DeckError>([&] {
                build_scene(deck_with({zone, bulk}));
              }),
              AllOf(HasSubstr("body.tie: \"m\" is tied, and its particle at"), HasSubstr("leave tie out")));
}
