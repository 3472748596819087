// The tie as the scene builds it, with the kernels of the step: where tied particles lie, and what a constant
// stress, a constant and a linear velocity do at the interface.
#include "scene_decks.hpp"
#include "src/isoparametric.hpp"
#include "swarf/kernels.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace swarf;
using namespace swarf::test;

namespace {
const double round_off = sizeof(Real) == 8 ? 1e-12 : 1e-4;
constexpr double spacing = 10 * um;

// Particles above z = 0, hexes `ratio` times as long as the spacing below, periodic in x and y.
Deck two_layers(int ratio) {
  Deck deck = empty_deck();
  const double wide = 8 * spacing;
  deck.bodies = {block("zone", "particles", {0, 0, 0}, {wide, wide, 6 * spacing}, spacing),
                 block("bulk", "hexes", {0, 0, -4 * ratio * spacing}, {wide, wide, 4 * ratio * spacing},
                       ratio * spacing)};
  deck.bodies[0].tie = "bulk";
  for (BodyDeck& b : deck.bodies)
    for (const char* face : {"x_min", "x_max", "y_min", "y_max"}) b.faces.push_back({face, "periodic", {}});
  return deck;
}

struct Step {
  Scene scene;
  Neighbors lists;
  ParticleMethod method;
  HexMethod hex_method;
};

Step prepare(const Deck& deck) {
  Step s;
  s.scene = build_scene(deck);
  s.lists.cutoff = Real(s.scene.cutoff), s.lists.skin = Real(s.scene.skin);
  s.method.spacing_ratio = 1 / Real(deck.particles.smoothing_ratio);
  sort_particles(s.scene.particles, s.lists.cutoff / 4);
  project_tie(s.scene.tie, s.scene.particles, s.scene.hexes);
  make_images(s.scene.particles, s.lists, s.scene.image_planes);
  find_neighbors(s.lists, s.scene.particles);
  update_images(s.scene.particles, s.lists, s.scene.image_planes);
  return s;
}

void fill(const SymmetricField& field, const Symmetric3& value) {
  const auto f = Kokkos::create_mirror_view(field);
  for (std::size_t i = 0; i < f.extent(0); ++i) store_symmetric(f, int(i), value);
  Kokkos::deep_copy(field, f);
}

// Forces of particles, hexes and the tie under the stresses that the scene carries.
void compute_forces(Step& s) {
  Scene& c = s.scene;
  const Status status("status");
  Kokkos::deep_copy(status, no_fault);
  velocity_gradient(c.particles, s.lists, s.method);
  hex_velocity_gradient(c.hexes, status);
  prepare_pair_state(c.particles, c.materials, s.method);
  project_tie_state(c.tie, c.particles, c.hexes, c.materials, Real(1));
  update_image_state(c.particles, s.lists, c.image_planes);
  particle_forces(c.particles, s.lists, s.method, Real(0));
  hex_forces(c.hexes, c.materials, s.hex_method, Real(0));
  gather_corner_forces(c.hexes);
  gather_tie_forces(c.tie, c.particles, c.hexes);
  couple_nodes(c.hexes, c.node_transforms, true);
}

} // namespace

// The cells below the particles' block, in three rows: the reach is 2.64 spacings.
TEST(TieScene, TiedParticlesContinueTheLattice) {
  Step s = prepare(two_layers(2));
  const Particles& p = s.scene.particles;
  ASSERT_EQ(p.tied, 3 * 64);
  const auto x = host_copy(p.position);
  for (int i = p.count; i < p.count + p.tied; ++i)
    for (int d = 0; d < 3; ++d) {
      const double cell = double(x(i, d)) / spacing - 0.5; // after project_tie: the shape functions place it
      EXPECT_NEAR(cell, std::round(cell), 1e4 * round_off);
      EXPECT_TRUE(d < 2 || (x(i, d) < 0 && x(i, d) > -3 * spacing));
    }
  const auto weight = host_copy(s.scene.tie.face_shape);
  const auto node = host_copy(s.scene.tie.face_nodes);
  const auto node_x = host_copy(s.scene.hexes.position);
  for (int k = 0; k < p.tied; ++k) {
    double total = 0, place = 0; // the nearest point of the face z = 0 lies straight above
    for (int a = 0; a < 4; ++a) {
      EXPECT_EQ(node_x(node(k, a), 2), 0);
      total += double(weight(k, a)), place += double(weight(k, a) * node_x(node(k, a), 0));
    }
    EXPECT_NEAR(total, 1, round_off);
    EXPECT_NEAR(place, double(x(p.count + k, 0)), spacing * round_off * 10);
  }
}

// L of the particles at the interface, from tied neighbours: exact for a linear velocity (Randles & Libersky
// 1996).
TEST(TieScene, LinearVelocityPassesToTheParticles) {
  Deck deck = two_layers(3);
  for (BodyDeck& b : deck.bodies) b.faces.clear(); // a linear field is not periodic
  deck.bodies[1].size = {9 * spacing, 9 * spacing, 12 * spacing};
  Step s = prepare(deck);
  const double G[9] = {1, 2, -3, 4, -5, 6, -7, 8, 9}; // 1/s
  for (const auto& [x, v, rows] :
       {std::tuple{s.scene.particles.position, s.scene.particles.velocity, s.scene.particles.count},
        std::tuple{s.scene.hexes.position, s.scene.hexes.velocity, s.scene.hexes.nodes}}) {
    const auto hx = host_copy(x), hv = host_copy(v);
    for (int i = 0; i < rows; ++i)
      for (int d = 0; d < 3; ++d)
        hv(i, d) = Real(3 + G[3 * d] * hx(i, 0) + G[3 * d + 1] * hx(i, 1) + G[3 * d + 2] * hx(i, 2));
    Kokkos::deep_copy(v, hv);
  }
  project_tie(s.scene.tie, s.scene.particles, s.scene.hexes);
  velocity_gradient(s.scene.particles, s.lists, s.method);
  const auto L = host_copy(s.scene.particles.points.velocity_gradient);
  // Velocities of 3 m/s resolve gradients over 10 um to round-off times 3e5 / s.
  for (int i = 0; i < s.scene.particles.count; ++i)
    for (int c = 0; c < 9; ++c) EXPECT_NEAR(double(L(i, c)), G[c], 3e5 * round_off);
}

// A constant stress: no force on inner particles and inner nodes, and none on the interface, where the
// traction of the hexes on their face meets that of the particles. Errors in units of stress times the cell's
// area.
TEST(TieScene, ConstantStressIsInBalance) {
  for (int ratio : {1, 2, 4}) {
    Step s = prepare(two_layers(ratio));
    const Symmetric3 stress{Real(-4e8), Real(-5e8), Real(-6e8), Real(1e8), Real(2e8), Real(3e8)};
    fill(s.scene.particles.points.stress, stress);
    fill(s.scene.hexes.points.stress, stress);
    compute_forces(s);
    const Particles& p = s.scene.particles;
    const auto x = host_copy(p.position), f = host_copy(p.force);
    double particle_error = 0;
    for (int i = 0; i < p.count; ++i) // below the range of the free surface at z = 6 spacings
      if (x(i, 2) < 2 * spacing)
        particle_error =
            std::max(particle_error, double(norm(load_vector(f, i))) / (6e8 * spacing * spacing));
    const auto node_x = host_copy(s.scene.hexes.position), node_f = host_copy(s.scene.hexes.force);
    const double edge = ratio * spacing;
    double node_error = 0;
    for (int a = 0; a < s.scene.hexes.nodes; ++a)
      if (node_x(a, 2) > -3.5 * edge) // the lower surface is free
        node_error = std::max(node_error, double(norm(load_vector(node_f, a))) / (6e8 * edge * edge));
    RecordProperty("particle_error_" + std::to_string(ratio), std::to_string(particle_error));
    RecordProperty("node_error_" + std::to_string(ratio), std::to_string(node_error));
    std::printf("ratio %d: particles %.3g, nodes %.3g of stress times area\n", ratio, particle_error,
                node_error);
    EXPECT_LT(particle_error, 1e4 * round_off) << ratio;
    EXPECT_LT(node_error, 1e4 * round_off) << ratio;
  }
}

// Whatever the stresses: what the particles get, the nodes lose, to round-off; so momentum is conserved.
TEST(TieScene, ForcesSumToZero) {
  Step s = prepare(two_layers(2));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1e9, 1e9);
  for (const SymmetricField& field : {s.scene.particles.points.stress, s.scene.hexes.points.stress}) {
    const auto f = host_copy(field);
    for (std::size_t i = 0; i < f.extent(0); ++i)
      for (int c = 0; c < 6; ++c) f(i, c) = Real(any(random));
    Kokkos::deep_copy(field, f);
  }
  compute_forces(s);
  Vector3 total{0, 0, 0};
  double size = 0;
  const auto add = [&](const VectorField& force, int rows) {
    const auto f = host_copy(force);
    for (int i = 0; i < rows; ++i) total = total + load_vector(f, i), size += double(norm(load_vector(f, i)));
  };
  add(s.scene.particles.force, s.scene.particles.count), add(s.scene.hexes.force, s.scene.hexes.nodes);
  EXPECT_LT(double(norm(total)) / size, 100 * round_off);
}

// A ring of hexes seen from points of a polar lattice: the inverse map is exact on distorted hexes.
TEST(TieScene, LocateInHex) {
  std::array<Eigen::Vector3d, 8> corner;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> shift(-0.2, 0.2), inside(-1, 1);
  for (int a = 0; a < 8; ++a)
    corner[a] = Eigen::Vector3d(((a + 1) / 2) % 2 + shift(random), (a / 2) % 2 + shift(random),
                                a / 4 + shift(random));
  for (int k = 0; k < 200; ++k) {
    const double scale = k % 2 == 0 ? 1 : 1.5; // odd ones may lie outside
    const double u = scale * inside(random), v = scale * inside(random), w = scale * inside(random);
    const double low[4] = {(1 - u) * (1 - v) / 4, (1 + u) * (1 - v) / 4, (1 + u) * (1 + v) / 4,
                           (1 - u) * (1 + v) / 4};
    Eigen::Vector3d x(0, 0, 0);
    std::array<double, 8> exact{};
    for (int a = 0; a < 4; ++a) exact[a] = low[a] * (1 - w) / 2, exact[a + 4] = low[a] * (1 + w) / 2;
    for (int a = 0; a < 8; ++a) x += exact[a] * corner[a];
    const auto found = locate_in_hex(corner, x);
    ASSERT_EQ(found.has_value(), std::max({std::abs(u), std::abs(v), std::abs(w)}) <= 1);
    for (int a = 0; found && a < 8; ++a) EXPECT_NEAR((*found)[a], exact[a], 1e-12);
  }
}
