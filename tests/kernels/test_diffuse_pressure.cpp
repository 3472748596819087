// Diffusion of pressures that alternate. Theory: what a linear field explains is left alone; sum V p is kept;
// the elastic energy sum V p^2 / 2K falls by what is booked.
#include "support/particle_block.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

constexpr bool is_double = sizeof(Real) == 8;

ParticleBlock pressed_block(Real disorder) {
  ParticleBlock b = particle_block(8, 7, 6, Real(1e-3), disorder);
  b.particles.pressure_state = View<Real* [4]>("pressure_state", b.particles.count);
  build_lists(b);
  prepare_pair_state(b.particles, b.materials, b.method); // impedance and volume; it takes the place of K
  velocity_gradient(b.particles, b.neighbors, b.method);
  return b;
}

template <class Function>
void set_pressure(const ParticleBlock& b, Function&& pressure) {
  const auto x = host_copy(b.particles.position);
  const auto stress = Kokkos::create_mirror_view(b.particles.points.stress);
  for (int i = 0; i < b.particles.count; ++i)
    for (int d = 0; d < 3; ++d) stress(i, d) = -Real(pressure(x(i, 0), x(i, 1), x(i, 2)));
  Kokkos::deep_copy(b.particles.points.stress, stress);
}

void diffuse(const ParticleBlock& b, Real time) {
  diffuse_pressure(b.particles, b.neighbors, {}, b.materials, {Real(0.1), time, 0, true});
}

// h / c of the block
const Real scale = Real(1.2e-3 / std::sqrt((1e11 + 4.0 / 3 * 8e10) / 7800));

} // namespace

TEST(DiffusePressure, LeavesALinearFieldAlone) {
  const ParticleBlock b = pressed_block(Real(0.2));
  const auto linear = [](double x, double y, double z) { return 1e9 * (1 + 200 * x - 300 * y + 100 * z); };
  set_pressure(b, linear);
  diffuse(b, scale);
  const auto x = host_copy(b.particles.position);
  const auto s = host_copy(b.particles.points.stress);
  for (int i = 0; i < b.particles.count; ++i)
    ASSERT_NEAR(-s(i, 0) / 1e9, linear(x(i, 0), x(i, 1), x(i, 2)) / 1e9, is_double ? 1e-12 : 1e-4);
}

// Rows of opposite pressure, the mode that no gradient sees: the decay rate of each call is bounded by 12
// delta c / h (Gershgorin) and not far below. Sums are kept to round-off.
TEST(DiffusePressure, TakesAwayAlternatingRows) {
  const ParticleBlock b = pressed_block(0);
  set_pressure(b, [](double x, double, double) { return int(std::floor(x / 1e-3)) % 2 ? 1e8 : -1e8; });
  const auto V = host_copy(b.particles.volume);
  const auto sums = [&] {
    const auto s = host_copy(b.particles.points.stress);
    const auto in = host_copy(b.particles.points.internal_work), out = host_copy(b.particles.hourglass_work);
    std::array<double, 3> sum{}; // V p, V p^2 / 2K, booked
    for (int i = 0; i < b.particles.count; ++i) {
      const double p = -double(s(i, 0) + s(i, 1) + s(i, 2)) / 3;
      sum[0] += V(i) * p, sum[1] += V(i) * p * p / 2e11;
      sum[2] += out(i);
      EXPECT_NEAR(in(i) + out(i), 0, 1e-12 * std::abs(double(out(i))));
    }
    return sum;
  };
  const auto before = sums();
  const int calls = 40;
  for (int k = 0; k < calls; ++k) diffuse(b, scale / 3);
  const auto after = sums();
  const double pressure_volume = std::sqrt(before[1] * 2e11 * b.particles.count * 1e-9);
  EXPECT_NEAR((after[0] - before[0]) / pressure_volume, 0, is_double ? 1e-13 : 1e-5);
  EXPECT_NEAR(after[2] / (before[1] - after[1]), 1, is_double ? 1e-9 : 1e-3);
  // Half a block away from the ends, whose one-sided gradients explain part of the alternation to themselves.
  const auto x = host_copy(b.particles.position);
  const auto s = host_copy(b.particles.points.stress);
  for (int i = 0; i < b.particles.count; ++i)
    if (std::abs(x(i, 0) - 4e-3) < 1e-3) {
      EXPECT_LT(std::abs(double(s(i, 0))), 0.1 * 1e8);
    }
}

// K ln(rho / rho_0) goes with the pressure, and what one particle gains in volume others lose: to second
// order in p / K.
TEST(DiffusePressure, TakesTheDensityAlong) {
  const ParticleBlock b = pressed_block(Real(0.1));
  const auto alternating = [](double x, double, double) {
    return int(std::floor(x / 1e-3)) % 2 ? 1e8 : -1e8;
  };
  set_pressure(b, alternating);
  const auto x = host_copy(b.particles.position);
  const double rho_0 = host_copy(b.particles.points.density)(0), m = host_copy(b.particles.points.mass)(0);
  diffuse(b, scale);
  const auto s = host_copy(b.particles.points.stress);
  const auto rho = host_copy(b.particles.points.density);
  double gained = 0, moved = 0;
  for (int i = 0; i < b.particles.count; ++i) {
    const double change = -double(s(i, 0)) - alternating(x(i, 0), 0, 0), K = 1e11;
    ASSERT_NEAR(K * std::log(double(rho(i)) / rho_0), change, is_double ? 1e-3 : 2e4);
    gained += m / double(rho(i)) - m / rho_0, moved += std::abs(m / double(rho(i)) - m / rho_0);
  }
  EXPECT_GT(moved, 1e-5 * b.particles.count * 1e-9);
  EXPECT_NEAR(gained / moved, 0, 1e-3);
}

} // namespace swarf::test
