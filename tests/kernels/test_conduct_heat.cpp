// Conduction between particles. Theory: -div q = k lap T; a cosine that fits a slab between insulated faces
// decays at alpha (pi / L)^2 and keeps its shape (Carslaw & Jaeger 1959, ch. 3).
#include "support/particle_block.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr bool is_double = sizeof(Real) == 8;

ParticleBlock conducting_block(int nx, int ny, int nz, Real spacing, Real disorder = 0) {
  ParticleBlock b = particle_block(nx, ny, nz, spacing, disorder);
  const auto materials = host_copy(b.materials);
  materials(0).conductivity = 50;
  Kokkos::deep_copy(b.materials, materials);
  b.particles.heat = ScalarField("heat", b.particles.count);
  b.particles.heat_shape = SymmetricField("heat_shape", b.particles.count);
  b.particles.heat_state = View<Real* [2]>("heat_state", b.particles.count);
  return b;
}

template <class Function>
void set_temperature(const ParticleBlock& b, Function&& T) {
  const auto x = host_copy(b.particles.position);
  const auto field = Kokkos::create_mirror_view(b.particles.points.temperature);
  for (int i = 0; i < b.particles.count; ++i) field(i) = Real(T(x(i, 0), x(i, 1), x(i, 2)));
  Kokkos::deep_copy(b.particles.points.temperature, field);
}

void conduct(ParticleBlock& b, Real dt, const GhostPlanes& planes = {}) {
  conduct_heat(b.particles, b.neighbors, planes, b.materials, dt);
}

// alpha of the block's steel
const double alpha = 50.0 / (7800 * 500);

} // namespace

TEST(ConductHeat, KeepsTheEnergyAndTheExtremesOfADisorderedBlock) {
  ParticleBlock b = conducting_block(9, 8, 7, Real(1e-5), Real(0.2));
  build_lists(b);
  velocity_gradient(b.particles, b.neighbors, b.method);
  set_temperature(
      b, [](double x, double y, double z) { return 300 + 100 * std::sin(4e6 * x + 7e6 * y + z * 9e6); });
  const auto before = host_copy(b.particles.points.temperature);
  const auto copy = std::vector<Real>(before.data(), before.data() + b.particles.count);
  const Real dt = stable_heat_step(b.particles, b.materials);
  for (int k = 0; k < 50; ++k) conduct(b, dt);
  const auto after = host_copy(b.particles.points.temperature);
  double sum = 0, least = 1e9, most = 0, difference = 0;
  for (int i = 0; i < b.particles.count; ++i) {
    sum += after(i) - copy[std::size_t(i)];
    difference = std::max(difference, std::abs(double(after(i) - copy[std::size_t(i)])));
    least = std::min(least, double(after(i))), most = std::max(most, double(after(i)));
  }
  EXPECT_GT(difference, 50);
  EXPECT_NEAR(sum / b.particles.count / 300, 0, is_double ? 1e-14 : 1e-6);
  EXPECT_GE(least, 200);
  EXPECT_LE(most, 400);
}

// Rate of the first cosine across a slab of n particles, over the exact one.
double decay_ratio(int n, bool along_surface) {
  const double L = 1e-4, spacing = L / n;
  // across: the faces x = 0 and L are ends of the cosine. along: it runs along the faces of a thin plate.
  ParticleBlock b = conducting_block(n, along_surface ? 3 : 8, 8, Real(spacing));
  build_lists(b);
  velocity_gradient(b.particles, b.neighbors, b.method);
  set_temperature(b, [&](double x, double, double) { return 300 + std::cos(pi * x / L); });
  const double dt = 1e-9;
  conduct(b, Real(dt));
  const auto x = host_copy(b.particles.position);
  const auto heat = host_copy(b.particles.heat), mass = host_copy(b.particles.points.mass);
  double rate = 0, norm = 0;
  for (int i = 0; i < b.particles.count; ++i) {
    const double shape = std::cos(pi * x(i, 0) / L);
    rate -= shape * heat(i) / (mass(i) * 500 * dt), norm += shape * shape;
  }
  return rate / norm / (alpha * pi * pi / (L * L));
}

// Along free sides, too: those of a bar of 8 x 8 rows, of a plate of 3 x 8.
TEST(ConductHeat, CosineDecaysInABar) { EXPECT_NEAR(decay_ratio(16, false), 1, 0.004); }
TEST(ConductHeat, CosineDecaysAlongAThinPlate) { EXPECT_NEAR(decay_ratio(24, true), 1, 0.004); }

// Periodic ghosts: a cosine of the period decays as in an endless body, at alpha (2 pi / L)^2.
TEST(ConductHeat, PassesThroughPeriodicGhosts) {
  const int n = 16;
  const double L = n * 1e-5;
  ParticleBlock b = conducting_block(n, 8, 8, Real(1e-5));
  const auto face = [&](Real sign, Real offset) {
    return GhostPlane{{sign, 0, 0}, offset, {identity3(), {sign * Real(L), 0, 0}}, true, true};
  };
  const GhostPlanes planes{face(1, 0), face(-1, Real(-L))};
  build_lists(b, planes);
  velocity_gradient(b.particles, b.neighbors, b.method);
  set_temperature(b, [&](double x, double, double) { return 300 + std::cos(2 * pi * x / L); });
  conduct(b, Real(1e-9), planes);
  const auto x = host_copy(b.particles.position);
  const auto heat = host_copy(b.particles.heat);
  double sum = 0, rate = 0, norm = 0;
  for (int i = 0; i < b.particles.count; ++i) {
    const double shape = std::cos(2 * pi * x(i, 0) / L);
    sum += heat(i), rate -= shape * heat(i) / (7800e-15 * 500 * 1e-9), norm += shape * shape;
  }
  EXPECT_NEAR(rate / norm / (alpha * 4 * pi * pi / (L * L)), 1, 0.03);
  EXPECT_NEAR(sum / (7800e-15 * 500), 0, is_double ? 1e-12 : 1e-3); // kelvin
}

} // namespace swarf::test
