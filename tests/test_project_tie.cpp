// The kernels of the tie on a disordered block of hexes with tied particles at random places in it.
// Theory: shape functions of the trilinear hex sum to 1 and reproduce x, so constant and linear fields are
// exact.
#include "support/hex_block.hpp"
#include "support/materials.hpp"
#include "support/particle_block.hpp"
#include "swarf/kernels.hpp"
#include <gtest/gtest.h>
#include <map>

using namespace swarf;
using namespace swarf::test;

namespace {

struct TiedBlock {
  HexMesh hexes;
  Particles particles;
  Tie tie;
};

double random_unit(std::mt19937& random) { return std::uniform_real_distribution<double>(-1, 1)(random); }

// 5 particles and `tied` tied ones in a block of 3 x 3 x 3 hexes of 10 um.
TiedBlock make_tied_block(int tied) {
  TiedBlock b;
  b.hexes = make_distorted_block({3, 3, 3}, ti64(), 10e-6, 0.2);
  b.hexes.points.velocity_gradient = TensorField("L", 27);
  b.particles.count = b.particles.points.count = 5;
  b.particles.tied = tied, b.particles.total = 5 + tied;
  allocate(b.particles, 5 + tied);
  b.tie.count = tied;
  b.tie.host = IndexField("host", tied), b.tie.shape = View<Real* [8]>("shape", tied);
  b.tie.state_hex = View<int* [7]>("state_hex", tied),
  b.tie.state_weight = View<Real* [7]>("state_weight", tied);
  b.tie.face_nodes = View<int* [4]>("face_nodes", tied),
  b.tie.face_shape = View<Real* [4]>("face_shape", tied);
  const auto host = host_copy(b.tie.host);
  const auto face = host_copy(b.tie.face_nodes);
  const auto hex = host_copy(b.hexes.connectivity);
  const auto state = host_copy(b.tie.state_hex);
  const auto share = host_copy(b.tie.state_weight);
  const auto shape = host_copy(b.tie.shape);
  const auto weight = host_copy(b.tie.face_shape);
  std::mt19937 random(3);
  std::map<int, std::vector<int>> entries;
  for (int k = 0; k < tied; ++k) {
    host(k) = k % 27;
    for (int n = 0; n < 7; ++n) state(k, n) = (host(k) + n) % 27, share(k, n) = Real(n == 0 ? 1.3 : -0.05);
    const double u = random_unit(random), v = random_unit(random), w = random_unit(random);
    const double low[4] = {(1 - u) * (1 - v) / 4, (1 + u) * (1 - v) / 4, (1 + u) * (1 + v) / 4,
                           (1 - u) * (1 + v) / 4};
    for (int a = 0; a < 4; ++a) {
      shape(k, a) = Real(low[a] * (1 - w) / 2), shape(k, a + 4) = Real(low[a] * (1 + w) / 2);
      weight(k, a) = Real(low[a]), face(k, a) = hex(host(k), a);
      entries[face(k, a)].push_back(4 * k + a);
    }
  }
  std::vector<int> nodes, start{0}, entry;
  for (const auto& [node, list] : entries) {
    nodes.push_back(node), entry.insert(entry.end(), list.begin(), list.end());
    start.push_back(int(entry.size()));
  }
  const auto upload = [](IndexField& field, const std::vector<int>& values) {
    field = IndexField("index", values.size());
    const auto f = Kokkos::create_mirror_view(field);
    for (std::size_t i = 0; i < values.size(); ++i) f(i) = values[i];
    Kokkos::deep_copy(field, f);
  };
  upload(b.tie.row_node, nodes), upload(b.tie.start, start), upload(b.tie.entry, entry);
  Kokkos::deep_copy(b.tie.state_hex, state), Kokkos::deep_copy(b.tie.state_weight, share);
  Kokkos::deep_copy(b.tie.host, host), Kokkos::deep_copy(b.tie.shape, shape);
  Kokkos::deep_copy(b.tie.face_nodes, face), Kokkos::deep_copy(b.tie.face_shape, weight);
  return b;
}

Vector3 sum_rows(const VectorField& field, int begin, int end) {
  const auto f = host_copy(field);
  Vector3 sum{0, 0, 0};
  for (int i = begin; i < end; ++i) sum = sum + load_vector(f, i);
  return sum;
}

} // namespace

TEST(ProjectTie, LinearVelocityPasses) {
  const TiedBlock b = make_tied_block(500);
  const double G[3][3] = {{10, -3, 7}, {2, 5, -8}, {-4, 6, 9}}, v0[3] = {1, -2, 0.5}; // m/s per 10 um
  const auto linear = [&](const Point& x) {
    Point v{};
    for (int i = 0; i < 3; ++i) v[i] = v0[i] + (G[i][0] * x[0] + G[i][1] * x[1] + G[i][2] * x[2]) * 1e5;
    return v;
  };
  set_nodal(b.hexes.velocity, b.hexes.position, linear);
  project_tie(b.tie, b.particles, b.hexes);
  const auto x = host_copy(b.particles.position), v = host_copy(b.particles.velocity);
  for (int i = 5; i < 505; ++i) {
    const Point exact = linear({double(x(i, 0)), double(x(i, 1)), double(x(i, 2))});
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(double(v(i, d)), exact[d], 60 * round_off);
  }
  const Vector3 free = sum_rows(b.particles.velocity, 0, 5); // rows of particles are not touched
  EXPECT_EQ(free.x, 0);
}

TEST(ProjectTie, ConstantVelocityPasses) {
  const TiedBlock b = make_tied_block(100);
  set_nodal(b.hexes.velocity, b.hexes.position, [](const Point&) { return Point{3, -7, 11}; });
  project_tie(b.tie, b.particles, b.hexes);
  const auto v = host_copy(b.particles.velocity);
  for (int i = 5; i < 105; ++i) {
    EXPECT_NEAR(double(v(i, 0)), 3, 3 * round_off);
    EXPECT_NEAR(double(v(i, 1)), -7, 7 * round_off);
    EXPECT_NEAR(double(v(i, 2)), 11, 11 * round_off);
  }
}

// Total force, and so the power on any constant velocity, to round-off; the nodes' own force stays.
TEST(GatherTieForces, ForceAndPowerAreConserved) {
  const TiedBlock b = make_tied_block(500);
  const auto f = host_copy(b.particles.force);
  std::mt19937 random(11);
  for (int i = 0; i < 505; ++i)
    for (int d = 0; d < 3; ++d) f(i, d) = Real(random_unit(random)); // N, also on rows that are not tied
  Kokkos::deep_copy(b.particles.force, f);
  set_nodal(b.hexes.force, b.hexes.position, [](const Point&) { return Point{1, 2, 3}; });
  gather_tie_forces(b.tie, b.particles, b.hexes);
  const Vector3 given = sum_rows(b.particles.force, 5, 505),
                taken = sum_rows(b.hexes.force, 0, b.hexes.nodes);
  EXPECT_NEAR(double(taken.x) - 64, double(given.x), 500 * round_off);
  EXPECT_NEAR(double(taken.y) - 128, double(given.y), 500 * round_off);
  EXPECT_NEAR(double(taken.z) - 192, double(given.z), 500 * round_off);
  const Vector3 v{3, -7, 11};
  const Vector3 net = taken - Vector3{64, 128, 192};
  EXPECT_NEAR(double(dot(net, v)), double(dot(given, v)), 5000 * round_off);
}

TEST(ProjectTieState, IsTheHostsState) {
  TiedBlock b = make_tied_block(54); // two in each hex
  const Material mat = ti64();
  const MaterialTable table = make_material_table({mat});
  set_rows(b.hexes.points.stress, {1e6, 2e6, 3e6, 4e6, 5e6, 6e6});
  set_rows(b.hexes.points.velocity_gradient, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  Kokkos::deep_copy(b.hexes.points.density, Real(1.25 * mat.density)); // compressed
  b.tie.correction = Real(1.5);
  const double volume = 27e-18;
  Kokkos::deep_copy(b.particles.points.mass, Real(volume * mat.density));
  const auto active = host_copy(b.hexes.active);
  active(4) = 0;
  Kokkos::deep_copy(b.hexes.active, active);
  project_tie_state(b.tie, b.particles, b.hexes, table, Real(100));

  const auto P = host_copy(b.particles.pair_stress);
  const auto D = host_copy(b.particles.strain_rate);
  const auto V = host_copy(b.particles.volume);
  const auto Z = host_copy(b.particles.impedance);
  const double E = 110e9, nu = 0.33; // plane-wave speed sqrt(E (1 - nu) / rho (1 + nu)(1 - 2 nu))
  const double speed = std::sqrt(E * (1 - nu) / (mat.density * (1 + nu) * (1 - 2 * nu)));
  const double exact_P[9] = {1e6, 4e6, 6e6, 4e6, 2e6, 5e6, 6e6, 5e6, 3e6}, exact_D[6] = {1, 5, 9, 3, 7, 5};
  for (int k = 0; k < 54; ++k) {
    const int i = 5 + k;
    const bool deleted = k % 27 == 4;
    for (int c = 0; c < 9; ++c) EXPECT_NEAR(double(P(i, c)), deleted ? 0 : 1.5 * exact_P[c], 1e8 * round_off);
    for (int c = 0; c < 6; ++c) EXPECT_NEAR(double(D(i, c)), exact_D[c], 100 * round_off);
    EXPECT_NEAR(double(V(i)), deleted ? 0 : volume / 1.25, volume * round_off);
    EXPECT_NEAR(double(Z(i, 0)) / (1.25 * mat.density * 100 * speed / 10), 1, round_off);
    EXPECT_NEAR(double(Z(i, 1)) / (125 * mat.density), 1, round_off);
  }
}
