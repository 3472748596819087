// Conduction in hexes. Theory: a linear temperature is steady; a cosine between insulated faces decays at
// alpha (pi / L)^2 (Carslaw & Jaeger 1959, ch. 3).
#include "support/hex_step.hpp"
#include "support/materials.hpp"
#include "swarf/material/heat.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace swarf::test {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr bool is_double = sizeof(Real) == 8;

struct HotBlock {
  HexMesh mesh;
  MaterialTable materials;
  double alpha;
};

HotBlock make_hot_block(HexMesh mesh) {
  Material mat = ti64();
  mat.conductivity = Real(7.2);
  const int hexes = mesh.points.count;
  mesh.corner_heat = View<Real* [8]>("corner_heat", hexes);
  mesh.nodal_heat = ScalarField("nodal_heat", mesh.nodes);
  mesh.nodal_temperature = ScalarField("nodal_temperature", mesh.nodes);
  mesh.heat_capacity = ScalarField("heat_capacity", mesh.nodes);
  const auto mass = host_copy(mesh.mass);
  const auto capacity = Kokkos::create_mirror_view(mesh.heat_capacity);
  for (int a = 0; a < mesh.nodes; ++a) capacity(a) = mass(a) * mat.specific_heat;
  Kokkos::deep_copy(mesh.heat_capacity, capacity);
  hex_velocity_gradient(mesh, make_status());
  return {mesh, make_material_table({mat}), 7.2 / (double(mat.density) * mat.specific_heat)};
}

struct Untied {
  Tie tie;
  Particles particles;
};

template <class Function>
void set_temperature(const HotBlock& b, Function&& T) {
  const HexMesh& m = b.mesh;
  const Untied untied;
  const auto x = host_copy(m.position);
  const auto field = Kokkos::create_mirror_view(m.nodal_temperature);
  for (int a = 0; a < m.nodes; ++a) field(a) = Real(T(x(a, 0), x(a, 1), x(a, 2)));
  Kokkos::deep_copy(m.nodal_temperature, field);
  Kokkos::deep_copy(m.nodal_heat, 0);
  spread_temperature(untied.tie, untied.particles, m, b.materials);
}

void conduct(const HotBlock& b, Real dt) {
  const Untied untied;
  hex_heat(b.mesh, b.materials, dt);
  gather_heat(untied.tie, untied.particles, b.mesh, b.materials);
  spread_temperature(untied.tie, untied.particles, b.mesh, b.materials);
}

} // namespace

TEST(HexHeat, LinearTemperatureIsSteadyInsideADistortedBlock) {
  const Cells n{4, 4, 4};
  const HotBlock b = make_hot_block(make_distorted_block(n, ti64(), 1e-5, 0.2));
  set_temperature(b, [](double x, double y, double z) { return 1e6 * (3 * x - y + 2 * z); });
  conduct(b, Real(1e-7));
  const auto heat = host_copy(b.mesh.nodal_heat);
  double at_surface = 0;
  for (int k = 0; k <= 4; ++k)
    for (int j = 0; j <= 4; ++j)
      for (int i = 0; i <= 4; ++i)
        at_surface = std::max(at_surface, std::abs(double(heat(block_node(n, i, j, k)))));
  for (int k = 1; k < 4; ++k)
    for (int j = 1; j < 4; ++j)
      for (int i = 1; i < 4; ++i)
        EXPECT_NEAR(heat(block_node(n, i, j, k)) / at_surface, 0, is_double ? 1e-12 : 1e-4);
}

TEST(HexHeat, KeepsTheEnergyOfADistortedBlock) {
  const HotBlock b = make_hot_block(make_distorted_block({5, 4, 3}, ti64(), 1e-5, 0.2));
  set_temperature(
      b, [](double x, double y, double z) { return 300 + 100 * std::sin(1e6 * (4 * x + 7 * y + 9 * z)); });
  const auto capacity = host_copy(b.mesh.heat_capacity);
  const auto energy = [&] {
    const auto T = host_copy(b.mesh.nodal_temperature);
    double sum = 0;
    for (int a = 0; a < b.mesh.nodes; ++a) sum += capacity(a) * T(a);
    return sum;
  };
  const double before = energy();
  const Real dt = stable_heat_step(b.mesh, b.materials);
  for (int k = 0; k < 200; ++k) conduct(b, dt);
  EXPECT_NEAR(energy() / before, 1, is_double ? 1e-13 : 1e-5);
  const auto T = host_copy(b.mesh.nodal_temperature);
  double least = 1e9, most = 0;
  for (int a = 0; a < b.mesh.nodes; ++a)
    least = std::min(least, double(T(a))), most = std::max(most, double(T(a)));
  EXPECT_LT(most - least, 20); // 200 before: no mode is left standing
}

// What heats a hex reaches its nodes: 10 K in one hex of a block warm the block by the mean, no more, no
// less.
TEST(HexHeat, TakesTheHeatOfTheHexes) {
  const HotBlock b = make_hot_block(make_distorted_block({3, 3, 3}, ti64(), 1e-5, 0.1));
  set_temperature(b, [](double, double, double) { return 300; });
  const auto temperature = host_copy(b.mesh.points.temperature), mass = host_copy(b.mesh.points.mass);
  temperature(13) += 10;
  Kokkos::deep_copy(b.mesh.points.temperature, temperature);
  for (int k = 0; k < 3; ++k) conduct(b, Real(1e-8));
  const auto T = host_copy(b.mesh.nodal_temperature), node_mass = host_copy(b.mesh.mass);
  double gained = 0;
  for (int a = 0; a < b.mesh.nodes; ++a) gained += node_mass(a) * (T(a) - 300);
  EXPECT_NEAR(gained / (mass(13) * 10), 1, is_double ? 1e-10 : 1e-3);
}

// Second order: a quarter of the error on half the spacing.
TEST(HexHeat, CosineDecaysAtTheExactRate) {
  const auto error = [](int n) {
    const double L = 1e-4;
    const HotBlock b = make_hot_block(make_hex_block({n, 2, 2}, ti64(), L / n));
    set_temperature(b, [&](double x, double, double) { return 300 + std::cos(pi * x / L); });
    const double time = 2e-4, rate = b.alpha * pi * pi / (L * L);
    const int steps = 64 * n * n / 64;
    for (int k = 0; k < steps; ++k) conduct(b, Real(time / steps));
    return host_copy(b.mesh.nodal_temperature)(0) - 300 - std::exp(-rate * time);
  };
  const double coarse = error(8), fine = error(16);
  if (is_double) {
    EXPECT_NEAR(std::log2(std::abs(coarse / fine)), 2, 0.1);
  }
  EXPECT_LT(std::abs(fine), 1e-3 + 300 * 2 * std::numeric_limits<Real>::epsilon()); // round-off at 300 K
}

// The modes that one point does not see conduct as exact integration lets them: T = xi eta on a unit cube
// brings each corner -k / 3 of its value (the integral of grad N_a . grad T).
TEST(HexHeat, HourglassModeOfACubeConductsAsExactIntegrationSays) {
  const HotBlock b = make_hot_block(make_hex_block({1, 1, 1}, ti64(), 1.0));
  set_temperature(b, [](double x, double y, double) { return (2 * x - 1) * (2 * y - 1); });
  hex_heat(b.mesh, b.materials, 1);
  const auto heat = host_copy(b.mesh.corner_heat);
  for (int a = 0; a < 8; ++a)
    EXPECT_NEAR(heat(0, a) / (7.2 / 3 * hourglass_sign(2, a)), -1, is_double ? 1e-12 : 1e-5);
}

} // namespace swarf::test
