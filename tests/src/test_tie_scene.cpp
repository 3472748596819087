// The tie as the scene builds it, with the kernels of the step: where tied particles lie, and what a constant
// stress, a constant and a linear velocity do at the interface.
#include "scene_decks.hpp"
#include "src/geometry/isoparametric.hpp"
#include "swarf/kernels.hpp"
#include <algorithm>
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
    for (const char* face : {"x_min", "x_max", "y_min", "y_max"})
      b.faces.push_back({face, FaceKind::periodic, {}});
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
  sort_particles(s.scene.particles, s.scene.lattice);
  project_tie(s.scene.tie, s.scene.particles, s.scene.hexes);
  make_ghosts(s.scene.particles, s.lists, s.scene.ghost_planes);
  find_neighbors(s.lists, s.scene.particles);
  update_ghosts(s.scene.particles, s.lists, s.scene.ghost_planes);
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
  update_ghost_state(c.particles, s.lists, c.ghost_planes);
  particle_forces(c.particles, s.lists, s.method, Real(0));
  hex_forces(c.hexes, c.materials, s.hex_method, Real(0));
  gather_corner_forces(c.hexes);
  gather_tie_forces(c.tie, c.particles, c.hexes);
  couple_nodes(c.hexes, c.node_transforms, true);
}

// Two layers with free sides, the hexes wider than the particles: for fields that are not periodic.
Deck free_layers() {
  Deck deck = two_layers(3);
  for (BodyDeck& b : deck.bodies) b.faces.clear();
  deck.bodies[1].size = {9 * spacing, 9 * spacing, 12 * spacing};
  return deck;
}

// Velocity v0 + G x of nodes and particles, then |L - G| at most of each particle and tied particle, 1/s.
std::vector<double> gradient_errors(Step& s, double v0, const std::array<double, 9>& G) {
  const Particles& p = s.scene.particles;
  for (const auto& [x, v, rows] :
       {std::tuple{p.position, p.velocity, p.count},
        std::tuple{s.scene.hexes.position, s.scene.hexes.velocity, s.scene.hexes.nodes}}) {
    const auto hx = host_copy(x), hv = host_copy(v);
    for (int i = 0; i < rows; ++i)
      for (int d = 0; d < 3; ++d)
        hv(i, d) = Real(v0 + G[3 * d] * hx(i, 0) + G[3 * d + 1] * hx(i, 1) + G[3 * d + 2] * hx(i, 2));
    Kokkos::deep_copy(v, hv);
  }
  project_tie(s.scene.tie, p, s.scene.hexes);
  update_ghosts(p, s.lists, s.scene.ghost_planes);
  velocity_gradient(p, s.lists, s.method);
  const auto L = host_copy(p.points.velocity_gradient);
  std::vector<double> errors;
  for (int i = 0; i < p.count + p.tied; ++i) {
    double error = 0;
    for (int c = 0; c < 9; ++c) error = std::max(error, std::abs(double(L(i, c)) - G[c]));
    errors.push_back(error);
  }
  return errors;
}
// Velocities of 3 m/s resolve gradients over 10 um to round-off times 3e5 / s.
constexpr double gradient_round_off = 3e5;

// Random values of the given size on every row.
template <class Field>
void set_random(const Field& field, double size, int seed) {
  const auto f = host_copy(field);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-size, size);
  for (std::size_t i = 0; i < f.extent(0); ++i)
    for (std::size_t c = 0; c < f.extent(1); ++c) f(i, c) = Real(any(random));
  Kokkos::deep_copy(field, f);
}

// Sums over particles and nodes, which alone have mass, and the size of their terms.
struct Balance {
  Vector3 force{0, 0, 0}, moment{0, 0, 0};
  double power = 0, force_size = 0, moment_size = 0, power_size = 0;
};
void add_rows(Balance& sum, const VectorField& position, const VectorField& velocity,
              const VectorField& force, int rows) {
  const auto x = host_copy(position), v = host_copy(velocity), f = host_copy(force);
  for (int i = 0; i < rows; ++i) {
    const Vector3 x_i = load_vector(x, i), v_i = load_vector(v, i), f_i = load_vector(f, i);
    sum.force = sum.force + f_i, sum.moment = sum.moment + cross(x_i, f_i),
    sum.power += double(dot(v_i, f_i));
    sum.force_size += double(norm(f_i)), sum.moment_size += double(norm(x_i) * norm(f_i));
    sum.power_size += double(norm(v_i) * norm(f_i));
  }
}
Balance sum_balance(const Scene& c) {
  Balance sum;
  add_rows(sum, c.particles.position, c.particles.velocity, c.particles.force, c.particles.count);
  add_rows(sum, c.hexes.position, c.hexes.velocity, c.hexes.force, c.hexes.nodes);
  return sum;
}

// sum w V stress : L
double stress_power(const MaterialPoints& points, const ScalarField& volume, const ScalarField& weight) {
  const auto s = host_copy(points.stress);
  const auto L = host_copy(points.velocity_gradient);
  const auto V = host_copy(volume), w = host_copy(weight);
  double power = 0;
  for (int i = 0; i < points.count; ++i)
    power += double((w.extent(0) > 0 ? w(i) : Real(1)) * V(i) *
                    contract(load_symmetric(s, i), symmetric_part(load_tensor(L, i))));
  return power;
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
  const auto shape = host_copy(s.scene.tie.shape);
  for (int k = 0; k < p.tied; ++k) {
    double total = 0;
    for (int a = 0; a < 8; ++a) {
      total += double(shape(k, a));
      EXPECT_GE(shape(k, a), -round_off); // inside the host
    }
    EXPECT_NEAR(total, 1, round_off);
  }
}

// What the hexes leave to the tied particles, sum (1 - share) V, is the volume that these carry, so that no
// stress counts twice or not at all: the midpoints that integrate the ramp over a hex miss it by its kink.
TEST(TieScene, SharesLeaveTheVolumeOfTheTiedParticles) {
  for (const double ratio : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0}) {
    Deck deck = two_layers(1);
    const double wide = 60 * spacing, edge = ratio * spacing; // divided by all ratios
    for (BodyDeck& b : deck.bodies) b.size = {wide / 5, wide / 5, 6 * spacing};
    if (ratio == 2.5)
      for (BodyDeck& b : deck.bodies) b.size = {wide / 6, wide / 6, 6 * spacing};
    deck.bodies[1].origin = {0, 0, -4 * edge}, deck.bodies[1].size[2] = 4 * edge;
    deck.bodies[1].spacing = edge;
    const Scene scene = build_scene(deck);
    const auto share = host_copy(scene.hexes.share), V = host_copy(scene.particles.volume);
    double filled = 0, tied = 0, mass = 0;
    for (int e = 0; e < scene.hexes.points.count; ++e) filled += (1 - double(share(e))) * edge * edge * edge;
    for (int i = scene.particles.count; i < scene.particles.count + scene.particles.tied; ++i)
      tied += double(V(i));
    for (const double m : {sum(scene.hexes.points.mass, scene.hexes.points.count), tied * 4430}) mass += m;
    std::printf("hex / spacing %.1f: filled / tied volume - 1 = %.2g\n", ratio, filled / tied - 1);
    // Measured 8e-4 for 2.5 and, worst, with the kink on the middle of a sixth, 1.2e-2 for 4.
    EXPECT_NEAR(filled / tied, 1, ratio < 4 ? 2e-3 : 1.5e-2) << ratio;
    // Material points carry the mass of the hexes once.
    EXPECT_NEAR(mass / sum(scene.hexes.mass, scene.hexes.nodes), 1, 5e-3) << ratio;
  }
}

// L of particles and tied particles on both sides of the interface: exact for constant and linear velocities
// (Randles & Libersky 1996), whatever the ratio of hexes to spacing. Periodic sides allow slopes along z
// only.
TEST(TieScene, ConstantAndLinearVelocityPassBothWays) {
  for (const int ratio : {1, 2, 4})
    for (const double slope : {0.0, 1.0}) {
      Step s = prepare(two_layers(ratio));
      const auto errors = gradient_errors(s, 3, {0, 0, -3 * slope, 0, 0, 6 * slope, 0, 0, 9 * slope});
      EXPECT_LT(*std::max_element(errors.begin(), errors.end()), gradient_round_off * round_off) << ratio;
    }
}

// All nine slopes, also where the deepest layer of tied particles ends free and their neighbours are few and
// light: a sixth of a cell each.
TEST(TieScene, LinearVelocityPassesBetweenFreeSides) {
  Step s = prepare(free_layers());
  const auto errors = gradient_errors(s, 3, {1, 2, -3, 4, -5, 6, -7, 8, 9});
  EXPECT_LT(*std::max_element(errors.begin(), errors.end()), gradient_round_off * round_off);
}

// A constant stress over both bodies: inner particles and nodes of either side are in balance. What is left
// at the interface, measured, in units of stress times the area of a cell or of a hex face: along the ramp
// the volumes of the tied particles change from layer to layer, and corrected sums over such a lattice are
// exact for the velocity gradient, not for the divergence of the stress (one is the adjoint of the other, not
// its mirror). It does no harm to momentum or work (tests below).
TEST(TieScene, ConstantStressLeavesAMeasuredResidual) {
  for (const int ratio : {1, 2, 4}) {
    Step s = prepare(two_layers(ratio));
    const Symmetric3 stress{Real(-4e8), Real(-5e8), Real(-6e8), Real(1e8), Real(2e8), Real(3e8)};
    fill(s.scene.particles.points.stress, stress);
    fill(s.scene.hexes.points.stress, stress);
    compute_forces(s);
    const Particles& p = s.scene.particles;
    const double edge = ratio * spacing;
    const auto x = host_copy(p.position), f = host_copy(p.force);
    double layer[3] = {0, 0, 0}; // particles by layer, from the interface
    for (int i = 0; i < p.count; ++i)
      if (x(i, 2) < 3 * spacing) { // below the range of the free surface at z = 6 spacings
        double& worst = layer[int(x(i, 2) / spacing)];
        worst = std::max(worst, double(norm(load_vector(f, i))) / (6e8 * spacing * spacing));
      }
    const auto node_x = host_copy(s.scene.hexes.position), node_f = host_copy(s.scene.hexes.force);
    double plane[4] = {0, 0, 0, 0}; // nodes by plane, from the interface
    for (int a = 0; a < s.scene.hexes.nodes; ++a) {
      const int k = int(std::lround(-double(node_x(a, 2)) / edge));
      if (k < 4) plane[k] = std::max(plane[k], double(norm(load_vector(node_f, a))) / (6e8 * edge * edge));
    }
    std::printf("hex / spacing %d: layers of particles %.2g %.2g %.2g, planes of nodes %.2g %.2g %.2g %.2g\n",
                ratio, layer[0], layer[1], layer[2], plane[0], plane[1], plane[2], plane[3]);
    RecordProperty("particles_" + std::to_string(ratio), std::to_string(*std::max_element(layer, layer + 3)));
    RecordProperty("nodes_" + std::to_string(ratio), std::to_string(*std::max_element(plane, plane + 4)));
    EXPECT_LT(*std::max_element(layer, layer + 3), 0.07) << ratio; // measured 0.057 for every ratio
    EXPECT_LT(*std::max_element(plane, plane + 4), 0.08) << ratio; // measured 0.066, 0.029, 0.032
  }
}

// Whatever the stresses of particles, tied particles and hexes: no net force, and no net moment where the
// gradient is exact for rotations. The bound of the correction at the rim of the deepest tied layer (above)
// costs a moment of 1.1e-5 of the sum of its terms, measured; without stress in that layer there is none.
TEST(TieScene, MomentumIsConserved) {
  for (const bool deepest : {true, false}) {
    Step s = prepare(free_layers());
    const Particles& p = s.scene.particles;
    set_random(p.points.stress, 1e9, 5), set_random(s.scene.hexes.points.stress, 1e9, 6);
    const auto x = host_copy(p.position);
    const auto stress = host_copy(p.points.stress);
    for (int i = 0; i < p.count + p.tied; ++i)
      if (!deepest && x(i, 2) < -2 * spacing) store_symmetric(stress, i, {0, 0, 0, 0, 0, 0});
    Kokkos::deep_copy(p.points.stress, stress);
    compute_forces(s);
    const Balance sum = sum_balance(s.scene);
    EXPECT_LT(double(norm(sum.force)) / sum.force_size, round_off);
    EXPECT_LT(double(norm(sum.moment)) / sum.moment_size, deepest ? 3e-5 : round_off);
  }
}

// The same with periodic sides, across which there are ghosts and coupled nodes.
TEST(TieScene, MomentumIsConservedInAPeriodicScene) {
  Step s = prepare(two_layers(2));
  set_random(s.scene.particles.points.stress, 1e9, 5), set_random(s.scene.hexes.points.stress, 1e9, 6);
  compute_forces(s);
  const Balance sum = sum_balance(s.scene);
  EXPECT_LT(double(norm(sum.force)) / sum.force_size, round_off);
}

// The power of the forces on any motion is that of the stresses: with it the tie keeps energy.
TEST(TieScene, ForcesDoTheWorkOfTheStresses) {
  Step s = prepare(free_layers());
  const Particles& p = s.scene.particles;
  set_random(p.points.stress, 1e9, 5), set_random(s.scene.hexes.points.stress, 1e9, 6);
  set_random(p.velocity, 10, 7), set_random(s.scene.hexes.velocity, 10, 8);
  project_tie(s.scene.tie, p, s.scene.hexes);
  compute_forces(s);
  const Balance sum = sum_balance(s.scene);
  const double power = stress_power(p.points, p.volume, ScalarField()) +
                       stress_power(s.scene.hexes.points, s.scene.hexes.volume, s.scene.hexes.share);
  EXPECT_NEAR(sum.power, -power, round_off * sum.power_size);
  EXPECT_GT(std::abs(sum.power), 1e-3 * sum.power_size); // not 0 = 0
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
