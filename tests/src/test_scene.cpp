// The scene: counts, masses and places against the closed forms of the shapes.
#include "scene_decks.hpp"
#include "src/geometry/lattice.hpp"
#include <cmath>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;

namespace {
const double round_off = sizeof(Real) == 8 ? 1e-12 : 1e-4;

double mass_of(const Scene& scene) { return sum(scene.particles.points.mass, scene.particles.count); }
double node_mass(const Scene& scene) { return sum(scene.hexes.mass, scene.hexes.nodes); }
} // namespace

// Demiral & Mamedov (2022), section 3: 370 689 particles and 123 840 hexes.
TEST(Scene, PaperCounts) {
  const Scene scene = build_scene(paper_deck());
  EXPECT_EQ(scene.particles.count, 370689);
  EXPECT_EQ(scene.hexes.points.count, 123840);
  EXPECT_EQ(scene.hexes.nodes, 344 * 16 * 25);
  EXPECT_GT(scene.tie.count, 717 * 47);
  // Mass of a hollow cylinder.
  const double band = 400 * um + 11 * 3.3 * um, exact = 4430 * pi * (band * band - 16e-8) * 150 * um;
  EXPECT_NEAR(mass_of(scene) / exact, 1, 10 * round_off); // 4e5 terms
  // Hexes have straight edges: a regular 344-gon instead of a circle.
  const double polygon = 344 / (2 * pi) * std::sin(2 * pi / 344);
  EXPECT_NEAR(node_mass(scene) / (4430 * pi * (36e-8 - band * band) * 150 * um * polygon), 1, round_off);
}

// Memory: what is switched off has no rows.
TEST(Scene, FieldsOfOptionsThatAreOffHaveNoRows) {
  Deck deck = empty_deck();
  deck.bodies = {block("b", "particles", {0, 0, 0}, {1e-3, 1e-3, 1e-3}, 0.2e-3)};
  deck.particles.hourglass_stiffness = 0;
  deck.particles.pressure_diffusion = 0, deck.particles.density = DensityRule::continuity;
  const auto rows = [&] {
    const Particles p = build_scene(deck).particles;
    return p.hourglass_displacement.extent(0) + p.hourglass_rate.extent(0) + p.pressure_state.extent(0) +
           p.reference_summation.extent(0) + p.deformation_gradient.extent(0) + p.damping.extent(0);
  };
  EXPECT_EQ(rows(), 0u);
  deck.particles.pressure_diffusion = 0.03;
  EXPECT_EQ(rows(), 125u);
}

TEST(Scene, MassesOfShapes) {
  const auto mass = [](BodyDeck b) {
    Deck deck = empty_deck();
    deck.bodies = {std::move(b)};
    const Scene scene = build_scene(deck);
    return scene.particles.count > 0 ? mass_of(scene) : node_mass(scene);
  };
  for (const char* fill : {"particles", "hexes"}) {
    EXPECT_NEAR(mass(block("b", fill, {1e-3, 0, 0}, {2e-3, 1e-3, 3e-3}, 0.21e-3)) / (4430 * 6e-9), 1,
                round_off);
    BodyDeck sector = ring("r", fill, 2e-3, 3e-3, 1e-3, {20, 5, 5});
    sector.start_angle = 20 * degree, sector.end_angle = 80 * degree;
    const double chord = fill[0] == 'h' ? std::sin(3 * degree) / (3 * degree) : 1;
    EXPECT_NEAR(mass(sector) / (4430 * pi / 6 * 5e-6 * 1e-3 * chord), 1, round_off);
    BodyDeck bar = body("c", "cylinder", fill);
    bar.radius = 3.2e-3, bar.height = 5e-3, bar.spacing = 0.4e-3;
    // 40 edges around the rim of the hexes
    const double rim = fill[0] == 'h' ? std::sin(2 * pi / 40) / (2 * pi / 40) : 1;
    EXPECT_NEAR(mass(bar) / (4430 * pi * 3.2e-3 * 3.2e-3 * 5e-3 * rim), 1, round_off);
    BodyDeck shell = body("s", "sphere", fill);
    shell.inner_radius = 1e-3, shell.outer_radius = 2e-3, shell.spacing = 0.2e-3;
    const double exact = 4430 * 4 * pi / 3 * 7e-9;
    EXPECT_NEAR(mass(shell) / exact, 1, fill[0] == 'h' ? 0.02 : round_off);
  }
}

// The outermost particles of a cylinder lie half a spacing below its surface, all around.
TEST(Scene, CylinderIsRound) {
  for (int across : {15, 16}) {
    BodyDeck bar = body("c", "cylinder", "particles");
    bar.radius = 3.2e-3, bar.height = 1e-3, bar.cells = {across, across, 3};
    const Deck deck = empty_deck();
    const PointSet set = fill_points(make_shape(deck, bar));
    const double pitch = 6.4e-3 / across;
    double volume_error = 0;
    for (std::size_t i = 0; i < set.position.size(); ++i) {
      EXPECT_LE(std::hypot(set.position[i].x(), set.position[i].y()), 3.2e-3 - 0.5 * pitch + 1e-12);
      volume_error = std::max(volume_error, std::abs(set.volume[i] / std::pow(set.spacing, 3) - 1));
    }
    for (int i : set.faces.at("side"))
      EXPECT_NEAR(std::hypot(set.position[i].x(), set.position[i].y()), 3.2e-3 - 0.5 * pitch, 1e-12);
    EXPECT_LT(volume_error, 0.25); // the centre of an odd lattice has pi/4 of a cell
    EXPECT_GT(set.faces.at("side").size(), std::size_t(3 * (across - 1) * 3 * 0.9));
  }
}

// Distance between the surfaces of two teeth along the ray from the tool's centre: f sin(phi), and the
// trochoid's second order, (f^2 / R) (cos^2(phi) / 2 - sin(phi) cos(phi) / pi) for two teeth: the earlier
// circle is hit at an immersion larger by f cos(phi) / R, when its centre had moved on by f / pi times that.
TEST(Scene, PreviousToothLeavesChipOfFeedSinPhi) {
  ToolDeck tool = paper_mill();
  for (const double turned : {0.0, 37.0}) {
    tool.feed_direction = {std::cos(turned * degree), std::sin(turned * degree), 0};
    tool.start_angle = -turned * degree; // immersion is clockwise from +y: the tooth is left of the feed
    const InnerSurface before = previous_tooth_surface(tool, {0, 0, 0});
    for (double phi = 5; phi < 180; phi += 10) {
      // The tooth's tip at the time of this immersion, and the ray from there to the surface left before.
      const double advance = 10 * um * phi / 180, angle = (90 + turned - phi) * degree;
      const double x = advance * std::cos(turned * degree), y = advance * std::sin(turned * degree);
      double low = 300 * um, high = 500 * um; // bisect for the distance from the tool's centre
      for (int pass = 0; pass < 60; ++pass) {
        const double r = 0.5 * (low + high), px = x + r * std::cos(angle), py = y + r * std::sin(angle);
        (std::hypot(px, py) < before(std::atan2(py, px), 0) ? low : high) = r;
      }
      const double s = std::sin(phi * degree), c = std::cos(phi * degree);
      const double trochoid = 10 * um * 10 / 400 * (c * c / 2 - s * c / pi);
      EXPECT_NEAR(400 * um - low, 10 * um * s + trochoid, 0.005 * um) << phi; // f^3 / R^2 = 0.006 um
    }
  }
}

// At time 0 the tip of each tooth lies on the surface that it has just cut, at any height; ahead of it stands
// the full chip, behind it nothing reaches into the tool's circle.
TEST(Scene, PreviousToothMeetsTheTips) {
  ToolDeck tool = paper_mill();
  tool.start_angle = 70 * degree, tool.position = {3 * um, -2 * um, 0};
  const InnerSurface surface = previous_tooth_surface(tool, {0, 0, 0});
  for (const double z : {0.0, 60 * um}) {
    const double phi = 70 * degree - z * std::tan(tool.helix) / (400 * um);
    const auto chip = [&](double ahead) { // of the tool's circle at time 0
      const double a = pi / 2 - phi - ahead * degree, x = 3 * um + 400 * um * std::cos(a),
                   y = -2 * um + 400 * um * std::sin(a);
      return std::hypot(x, y) - surface(std::atan2(y, x), z);
    };
    EXPECT_NEAR(chip(-1), 0, 0.2 * um);
    EXPECT_NEAR(chip(1), 10 * um * std::sin(phi), 0.3 * um);
  }
}

TEST(Scene, PreviousToothKeepsMass) {
  Deck deck = paper_deck();
  deck.tool = paper_mill();
  deck.tool->position = {0, 0, -20 * um};
  deck.tool->length = 300 * um;
  deck.bodies[0].previous_tooth = true;
  deck.bodies[0].cells = {200, 6, 11}, deck.bodies[1].cells = {100, 3, 6};
  deck.bodies[0].start_angle = deck.bodies[1].start_angle = -10 * degree;
  deck.bodies[0].end_angle = deck.bodies[1].end_angle = 80 * degree;
  const Scene scene = build_scene(deck);
  // Chips of height 10 um sin(phi) add (f R) integral sin(phi) to the sector, phi from 10 to 100 degrees,
  // less the centre's way back: the mean of the advance from -f to 0 over the pass.
  const Shape shape = make_shape(deck, deck.bodies[0]);
  double area = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double angle = (-10 + 90 * (i + 0.5) / n) * degree, r = shape.inner(angle, 75 * um);
    area += 0.5 * (436.3 * 436.3 * um * um - r * r) * 90 * degree / n;
  }
  EXPECT_NEAR(mass_of(scene) / (4430 * area * 150 * um), 1, 1e-5);
}

// A fixed face of hexes holds its nodes, of particles the first layer; a symmetric one the normal.
TEST(Scene, Faces) {
  Deck deck = empty_deck();
  deck.bodies = {block("hexes", "hexes", {0, 0, 0}, {4e-3, 3e-3, 2e-3}, 1e-3),
                 block("particles", "particles", {10e-3, 0, 0}, {4e-3, 3e-3, 2e-3}, 1e-3)};
  for (BodyDeck& b : deck.bodies)
    b.faces = {{"x_min", FaceKind::fixed, {}}, {"z_max", FaceKind::symmetric, {}}};
  deck.bodies[1].faces.push_back({"y_max", FaceKind::velocity, {0, 0, -5}});
  deck.bodies[1].size[2] = 8e-3, deck.bodies[1].origin[2] = -6e-3; // both z_max in one plane
  const Scene scene = build_scene(deck);
  const auto node = host_copy(scene.hexes.constraints), particle = host_copy(scene.particles.constraints);
  const auto table = host_copy(scene.constraints);
  const auto x = host_copy(scene.hexes.position), y = host_copy(scene.particles.position);
  for (int a = 0; a < scene.hexes.nodes; ++a)
    for (int b = 0; b < int(table.extent(0)); ++b) {
      const bool held = (node(a) >> b) & 1u;
      if (table(b).all && table(b).velocity.z == 0) {
        EXPECT_EQ(held, x(a, 0) == 0);
      }
      if (!table(b).all) {
        EXPECT_EQ(held, std::abs(double(x(a, 2)) - 2e-3) < 1e-9);
      }
    }
  for (int i = 0; i < scene.particles.count; ++i)
    for (int b = 0; b < int(table.extent(0)); ++b) {
      const bool held = (particle(i) >> b) & 1u;
      if (table(b).all && table(b).velocity.z != 0) {
        EXPECT_EQ(held, std::abs(double(y(i, 1)) - 2.5e-3) < 1e-9);
      }
      if (!table(b).all) {
        EXPECT_FALSE(held); // particles see a mirror
      }
    }
  ASSERT_EQ(scene.ghost_planes.size(), 2u);
  const GhostPlane& mirror = scene.ghost_planes[1];
  EXPECT_FALSE(scene.ghost_planes[0].active);
  ASSERT_TRUE(mirror.active);
  EXPECT_FALSE(mirror.periodic);
  const Vector3 image = apply(mirror.to_ghost, Vector3{Real(1e-3), Real(2e-3), Real(1e-3)});
  EXPECT_NEAR(image.x, 1e-3, 1e-9);
  EXPECT_NEAR(image.z, 3e-3, 1e-9);
}

// Each particle of a held row follows the one behind it, whole where held faces meet.
TEST(Scene, HeldRowsFollowTheNext) {
  Deck deck = empty_deck();
  deck.bodies = {block("b", "particles", {0, 0, 0}, {5e-3, 4e-3, 3e-3}, 1e-3)};
  deck.bodies[0].faces = {{"x_min", FaceKind::fixed, {}}, {"y_max", FaceKind::velocity, {0, 0, -5}}};
  const Scene scene = build_scene(deck);
  const auto bits = host_copy(scene.particles.constraints);
  const auto x = host_copy(scene.particles.position), v = host_copy(scene.particles.velocity);
  for (int i = 0; i < scene.particles.count; ++i) {
    const bool at_x = x(i, 0)<1e-3, at_y = x(i, 1)> 3e-3;
    EXPECT_EQ((bits(i) & follows_bit) != 0, at_x != at_y);
    EXPECT_NEAR(v(i, 2), at_y && !at_x ? -5 * 2.0 / 3 : 0, 1e-6);
  }
  const HeldRows& rows = scene.held_rows;
  const auto host = host_copy(rows.host), start = host_copy(rows.start), held = host_copy(rows.held);
  EXPECT_EQ(rows.held.extent(0), std::size_t(3 * 3 + 4 * 3)); // without the edge
  EXPECT_EQ(rows.groups, 3 * 3 + 4 * 3 - 3);                  // one host of both next to the edge
  for (int g = 0; g < rows.groups; ++g)
    for (int k = start(g); k < start(g + 1); ++k)
      EXPECT_NEAR(norm(load_vector(x, host(g)) - load_vector(x, held(k))), 1e-3, 1e-9);
}

// Faces of two layers, and round ones, have none behind.
TEST(Scene, RowsWithoutAnotherBehindAreHeld) {
  Deck deck = empty_deck();
  deck.bodies = {block("b", "particles", {0, 0, 0}, {2e-3, 4e-3, 3e-3}, 1e-3)};
  deck.bodies[0].faces = {{"x_min", FaceKind::fixed, {}}};
  EXPECT_EQ(build_scene(deck).held_rows.groups, 0);
  deck.bodies = {body("c", "cylinder", "particles")};
  deck.bodies[0].radius = 4e-3, deck.bodies[0].height = 4e-3, deck.bodies[0].spacing = 1e-3;
  deck.bodies[0].faces = {{"side", FaceKind::fixed, {}}};
  EXPECT_EQ(build_scene(deck).held_rows.groups, 0);
  deck.bodies[0].faces = {{"bottom", FaceKind::fixed, {}}};
  const Scene scene = build_scene(deck);
  const auto x = host_copy(scene.particles.position);
  const auto host = host_copy(scene.held_rows.host), held = host_copy(scene.held_rows.held);
  EXPECT_GT(scene.held_rows.groups, 40);
  for (int g = 0; g < scene.held_rows.groups; ++g)
    EXPECT_NEAR(norm(load_vector(x, host(g)) - load_vector(x, held(g)) - Vector3{0, 0, Real(1e-3)}), 0, 1e-9);
}

// Every node couple maps by its transform; the masses of a pair are equal and the total is kept.
TEST(Scene, PeriodicSector) {
  Deck deck = empty_deck();
  deck.bodies = {ring("zone", "particles", 2e-3, 3e-3, 1e-3, {8, 6, 6}),
                 ring("bulk", "hexes", 3e-3, 4e-3, 1e-3, {4, 3, 3})};
  deck.bodies[0].tie = "bulk";
  for (BodyDeck& b : deck.bodies) {
    b.start_angle = 30 * degree, b.end_angle = 90 * degree;
    for (const char* face : {"start", "end", "bottom", "top"})
      b.faces.push_back({face, FaceKind::periodic, {}});
  }
  const Scene scene = build_scene(deck);
  EXPECT_EQ(scene.ghost_planes.size(), 4u);
  const HexMesh& m = scene.hexes;
  const auto couples = host_copy(m.coupled_nodes);
  const auto maps = host_copy(scene.node_transforms);
  const auto x = host_copy(m.position);
  const auto mass = host_copy(m.mass);
  ASSERT_EQ(couples.extent(0), std::size_t(4 * 4 + 5 * 4));
  for (std::size_t r = 0; r < couples.extent(0); ++r) {
    const Vector3 image = apply(maps(couples(r, 2)), load_vector(x, couples(r, 0)));
    EXPECT_NEAR(norm(image - load_vector(x, couples(r, 1))), 0, 1e-9);
    EXPECT_EQ(mass(couples(r, 0)), mass(couples(r, 1)));
  }
  const double section = 0.5 * (16e-6 - 9e-6) * 4 * std::sin(15 * degree); // four straight-edged cells around
  EXPECT_NEAR(node_mass(scene) / (4430 * section * 1e-3), 1, round_off);
  for (const GhostPlane& p : scene.ghost_planes) EXPECT_TRUE(p.active && p.periodic);
}

// Lateral surface and ends of a cylinder; none of it on a symmetric plane.
TEST(Scene, ContactAreaIsTheFreeSurface) {
  Deck deck = empty_deck();
  BodyDeck bar = body("c", "cylinder", "hexes");
  bar.radius = 1e-3, bar.height = 2e-3, bar.spacing = 0.1e-3,
  bar.faces = {{"bottom", FaceKind::symmetric, {}}};
  deck.bodies = {bar};
  const Scene scene = build_scene(deck);
  EXPECT_NEAR(sum(scene.hexes.contact_area, scene.hexes.nodes) / (pi * 1e-6 + 2 * pi * 2e-6), 1, 5e-3);
}
