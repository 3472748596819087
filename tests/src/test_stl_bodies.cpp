// Bodies that are filled from a closed STL surface: volumes against those of the facets and of the round
// body, boxes against blocks, and what must be refused.
#include "src/geometry/closed_surface.hpp"
#include "src/geometry/lattice.hpp"
#include "src/geometry/surface_quads.hpp"
#include "tests/src/stl_bodies.hpp"
#include "tests/support/chance.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>

using namespace swarf;
using namespace swarf::test;
using testing::AllOf;
using testing::HasSubstr;

namespace {

const double round_off = sizeof(Real) == 8 ? 1e-12 : 1e-4;
constexpr double R = 1e-3;

double particle_mass(const Scene& scene) { return sum(scene.particles.points.mass, scene.particles.count); }
double hex_mass(const Scene& scene) { return sum(scene.hexes.points.mass, scene.hexes.points.count); }

// Of a surface as a file holds it, in single precision.
double volume_of_file(const std::string& file) { return ClosedSurface(read_stl(file, 1), {}).volume(); }

std::string fault_of(const BodyDeck& body) {
  return message_of<DeckError>([&] { build_scene(deck_with({body})); });
}
std::string fault_of(const FacetSurface& surface, double spacing, const std::string& fill = "hexes") {
  const TemporaryFolder folder;
  write_stl(surface, (folder / "s.stl").string());
  return fault_of(stl_body((folder / "s.stl").string(), fill, spacing));
}

} // namespace

// 1 % at 20 cells across. Facets of edge a, corners on a sphere of radius R, lie a^2 / (8 R) below it in the
// mean, so 8192 equal ones enclose 3/8 a^2 / R^2 = 0.13 % less; these differ in size, and enclose a little
// less still.
TEST(StlBodies, BallAndCylinderHaveTheirVolume) {
  const TemporaryFolder folder;
  const std::string ball = (folder / "ball.stl").string(), bar = (folder / "bar.stl").string();
  write_stl(make_sphere(R, 5), ball), write_stl(make_cylinder(R, 2 * R, 256), bar);
  const double of_ball = 4 * pi / 3 * R * R * R, of_bar = 2 * pi * R * R * R;
  EXPECT_NEAR(volume_of_file(ball) / of_ball, 1 - 1.33e-3, 2e-4);
  EXPECT_NEAR(volume_of_file(bar) / of_bar, 128 / pi * std::sin(pi / 128), 1e-6) << "of a prism of 256 sides";
  for (const auto& [file, volume] : {std::pair(ball, of_ball), std::pair(bar, of_bar)}) {
    const Scene particles = build_scene(deck_with({stl_body(file, "particles", R / 10)}));
    EXPECT_NEAR(particle_mass(particles) / (4430 * volume_of_file(file)), 1, 100 * round_off);
    EXPECT_NEAR(particles.particles.count * std::pow(R / 10, 3) / volume, 1, 0.01)
        << "before they are scaled";
    const Scene hexes = build_scene(deck_with({stl_body(file, "hexes", R / 10)}));
    EXPECT_NEAR(hex_mass(hexes) / (4430 * volume), 1, 0.01);
    EXPECT_EQ(hexes.hexes.points.count, particles.particles.count) << "the same cells";
    RecordProperty(file == ball ? "ball_cells_off" : "bar_cells_off",
                   std::to_string(particles.particles.count * std::pow(R / 10, 3) / volume - 1));
  }
}

// Whatever the distance; exact_distance works by the winding number, over all facets.
TEST(StlBodies, DistanceIsExactEverywhere) {
  const FacetSurface surface = add(make_sphere(R, 3), make_box({1.2 * R, -R, -R}, {R, 2 * R, 0.3 * R}));
  const Triple origin{3e-4, -2e-4, 1e-4};
  const ClosedSurface closed(surface, origin);
  Chance chance(7);
  for (int k = 0; k < 3000; ++k) {
    Triple x;
    for (double& c : x) c = R * (double(chance.below(1000001)) / 1e5 - 5);
    const double exact = exact_distance(surface, x);
    const double found = closed.signed_distance({x[0] + origin[0], x[1] + origin[1], x[2] + origin[2]});
    ASSERT_NEAR(found, exact, coarse * 1e-12 * R) << x[0] << " " << x[1] << " " << x[2];
  }
  EXPECT_EQ(closed.parts(), 2);
  EXPECT_NEAR(closed.box().min().x(), origin[0] - R, 1e-12);
}

// Cells fit the box of the surface, so a box is filled as the block that it is, to the last bit of the
// lattice.
TEST(StlBodies, BoxIsABlock) {
  const TemporaryFolder folder;
  const Triple low{0, 0, 0}, size{1, 0.5, 0.75}; // exact in single precision
  write_stl(make_box(low, size), (folder / "box.stl").string());
  BodyDeck from_file = stl_body((folder / "box.stl").string(), "particles", 0.13);
  from_file.origin = {2, -1, 0.5};
  const Deck deck = deck_with({from_file, block("c", "particles", {2, -1, 0.5}, size, 0.13)});
  const Shape shape = make_shape(deck, deck.bodies[0]), of_block = make_shape(deck, deck.bodies[1]);
  const PointSet points = fill_points(shape), expected = fill_points(of_block);
  ASSERT_EQ(points.position.size(), expected.position.size());
  for (std::size_t i = 0; i < points.position.size(); ++i) {
    EXPECT_LT((points.position[i] - expected.position[i]).norm(), 1e-15);
    EXPECT_NEAR(points.volume[i] / expected.volume[i], 1, 1e-12);
  }
  EXPECT_EQ(points.faces, expected.faces);
  EXPECT_EQ(points.behind, expected.behind);
  const HexSet hexes = fill_hexes(shape), of_hexes = fill_hexes(of_block);
  ASSERT_EQ(hexes.hex.size(), of_hexes.hex.size());
  for (const auto& [name, members] : of_hexes.faces)
    EXPECT_EQ(hexes.faces.at(name).size(), members.size()) << name;
  // Beyond it the lattice goes on as that of the block.
  const PointSet beyond = continue_points(shape, 2), of_beyond = continue_points(of_block, 2);
  ASSERT_EQ(beyond.position.size(), of_beyond.position.size());
  for (std::size_t i = 0; i < beyond.position.size(); ++i)
    EXPECT_LT((beyond.position[i] - of_beyond.position[i]).norm(), 1e-15);
}

// Tied to hexes as the block is.
TEST(StlBodies, TieIsThatOfTheBlock) {
  const TemporaryFolder folder;
  write_stl(make_box({0, 0, 0}, {1, 1, 0.5}), (folder / "box.stl").string());
  BodyDeck zone = stl_body((folder / "box.stl").string(), "particles", 0.1);
  BodyDeck as_block = block("b", "particles", {0, 0, 0}, {1, 1, 0.5}, 0.1);
  const BodyDeck bulk = block("bulk", "hexes", {0, 0, -1}, {1, 1, 1}, 0.2);
  zone.tie = as_block.tie = "bulk";
  const Scene scene = build_scene(deck_with({zone, bulk})),
              expected = build_scene(deck_with({as_block, bulk}));
  EXPECT_GT(expected.tie.count, 0);
  EXPECT_EQ(scene.tie.count, expected.tie.count);
  const auto share = host_copy(scene.hexes.share), of_block = host_copy(expected.hexes.share);
  for (int e = 0; e < scene.hexes.points.count; ++e) EXPECT_NEAR(share(e), of_block(e), 1e-12 * coarse);
}

// Sides of the box: what is held is the first layer of particles, and nodes on the side.
TEST(StlBodies, SidesAreHeld) {
  const TemporaryFolder folder;
  write_stl(make_cylinder(R, 2 * R, 128), (folder / "bar.stl").string());
  for (const char* fill : {"particles", "hexes"}) {
    BodyDeck bar = stl_body((folder / "bar.stl").string(), fill, R / 8);
    bar.faces = {{"z_min", FaceKind::fixed}};
    const Scene scene = build_scene(deck_with({bar}));
    const bool particles = scene.particles.count > 0;
    const auto bits = host_copy(particles ? scene.particles.constraints : scene.hexes.constraints);
    const auto x = host_copy(particles ? scene.particles.position : scene.hexes.position);
    int held = 0;
    for (int i = 0; i < int(bits.extent(0)); ++i) {
      const double highest = particles ? 0.51 * R / 8 : 1e-9;
      EXPECT_EQ((bits(i) & 1u) != 0, x(i, 2) < highest) << fill << " " << x(i, 2);
      held += (bits(i) & 1u) != 0 ? 1 : 0;
    }
    EXPECT_GT(held, 150) << fill;
  }
  BodyDeck ball = stl_body((folder / "ball.stl").string(), "hexes", R / 2.5);
  FacetSurface octahedron = make_sphere(R, 0); // comes to a point
  write_stl(octahedron, ball.file);
  ball.faces = {{"x_min", FaceKind::fixed}}, ball.spacing = R / 4;
  EXPECT_THAT(fault_of(ball), HasSubstr("body.faces.x_min: \"b\" has no cell at that side of the box"));
}

TEST(StlBodies, FaultsOfTheSurfaceAreRefused) {
  const FacetSurface box = make_box({0, 0, 0}, {R, R, R});
  FacetSurface open = box, turned = box;
  open.facets.pop_back(), std::swap(turned.facets[3][0], turned.facets[3][1]);
  EXPECT_THAT(fault_of(open, R / 4), AllOf(HasSubstr("test.toml:7: body.file: \"b\" cannot be filled:"),
                                           HasSubstr("is open"), HasSubstr("close the hole")));
  EXPECT_THAT(fault_of(turned, R / 4), HasSubstr("is inverted"));
  const auto with = [&](const Triple& low, const Triple& size) { return add(box, make_box(low, size)); };
  const std::string cuts = "goes through facet", lies = "lies in or on another part";
  const auto half = [](double a) { return Triple{a * R, a * R, a * R}; };
  EXPECT_THAT(fault_of(with(half(0.5), half(1)), R / 4),
              AllOf(HasSubstr(cuts), HasSubstr("join the parts to one")));
  // Their sides lie in the same planes: edges go through the sides of facets only.
  EXPECT_THAT(fault_of(with({0.5 * R, 0, 0}, half(1)), R / 4), HasSubstr(cuts));
  EXPECT_THAT(fault_of(with(half(0.25), half(0.5)), R / 4), HasSubstr(lies)) << "one in the other";
  // A beam through a box, with no corner of one in the other.
  EXPECT_THAT(fault_of(with({-R, 0.4 * R, 0.4 * R}, {3 * R, 0.2 * R, 0.2 * R}), R / 4), HasSubstr(cuts));
  EXPECT_EQ(fault_of(with({1.5 * R, 0, 0}, half(1)), R / 4), "") << "two parts, apart";
  EXPECT_EQ(fault_of(make_sphere(R, 3), R / 8, "particles"), "");
}

// Whatever is sound is taken: flutes, needles between others, and boxes in every direction.
TEST(StlBodies, SoundSurfacesAreTaken) {
  ToolDeck lean = make_wedge_deck();
  lean.inclination = 20 * degree;
  for (const FacetSurface& s :
       {make_tool_surface(make_mill(4), ""), make_tool_surface(lean, ""), make_cylinder(R, 20 * R, 256),
        make_cylinder(R, 1e-3 * R, 64), make_sphere(R, 5)})
    EXPECT_NO_THROW(check_parts(s, "s"));
  Chance chance(11);
  for (int k = 0; k < 200; ++k) {
    FacetSurface box = add(make_box({0, 0, 0}, {R, 2 * R, 3 * R}), make_box({1.001 * R, 0, 0}, {R, R, R}));
    const Eigen::Quaterniond turn(double(chance.below(1000)), double(chance.below(1000)),
                                  double(chance.below(1000)), 1 + double(chance.below(1000)));
    for (Triple& v : box.vertices) {
      const Point x = turn.normalized() * Point(v[0], v[1], v[2]);
      v = {x.x(), x.y(), x.z()};
    }
    EXPECT_NO_THROW(check_parts(box, "box"));
  }
}

TEST(StlBodies, CellsThatMakeAnotherBodyAreRefused) {
  EXPECT_THAT(fault_of(make_box({0, 0, 0}, {R, R, R}), 3 * R),
              AllOf(HasSubstr("body.spacing: \"b\" holds not one cell"), HasSubstr("Make it smaller")));
  // A bar of 1/20 across the diagonal of its box lies between the centres.
  FacetSurface bar = make_box({-0.05 * R, -0.05 * R, 0}, {0.1 * R, 0.1 * R, 4 * R});
  for (Triple& v : bar.vertices) v = {v[0] + v[2] / 3 + 0.01 * R, v[1] + v[2] / 5, v[2]};
  EXPECT_THAT(fault_of(bar, 0.4 * R), AllOf(HasSubstr("body.spacing: \"b\""), HasSubstr("Make it")));
  // Parts nearer than a cell become one; a ball of six cells across has 20 % too much.
  const FacetSurface two = add(make_box({0, 0, 0}, {R, R, R}), make_box({1.02 * R, 0, 0}, {R, R, R}));
  EXPECT_THAT(fault_of(two, 0.2 * R), HasSubstr("makes 1 piece(s) of cells of the 2 parts of the surface"));
  EXPECT_THAT(fault_of(make_sphere(R, 4), R / 3),
              HasSubstr("% off that of the surface: expected at most 10 %"));
}

// Tips whose cells hang on the others by an edge are left out, and the rest is one piece.
TEST(StlBodies, HexesHangTogetherByFaces) {
  const TemporaryFolder folder;
  FacetSurface s; // a sharp tetrahedron, askew
  s.vertices = {
      {0, 0, 0}, {1.0 * R, 0.2 * R, 0.1 * R}, {0.1 * R, 1.1 * R, 0.15 * R}, {0.25 * R, 0.2 * R, 1.3 * R}};
  s.facets = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  write_stl(s, (folder / "t.stl").string());
  const Deck deck = deck_with({stl_body((folder / "t.stl").string(), "hexes", R / 30)});
  const HexSet set = fill_hexes(make_shape(deck, deck.bodies[0]));
  const auto neighbors = find_face_neighbors(set);
  std::set<int> reached{0};
  std::vector<int> front{0};
  while (!front.empty()) {
    const int h = front.back();
    front.pop_back();
    for (const int other : neighbors[std::size_t(h)])
      if (other >= 0 && reached.insert(other).second) front.push_back(other);
  }
  EXPECT_EQ(reached.size(), set.hex.size());
}
