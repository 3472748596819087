// Theory: h / V^(1/3) is kept, whatever has changed the density.
#include "support/particle_block.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

TEST(EvolveSmoothingLength, FollowsTheCubeRootOfTheVolume) {
  ParticleBlock b = particle_block(3, 3, 3, Real(1e-3));
  Particles& p = b.particles;
  const double h = 1.2e-3, rho_0 = 7800, tolerance = sizeof(Real) == 8 ? 1e-12 : 1e-5;
  const auto rho = Kokkos::create_mirror_view(p.points.density);
  const auto ratio = [](int step, int i) { return std::pow(1 + 0.1 * i, step - 1.0); };
  for (int step = 1; step <= 4; ++step) {
    for (int i = 0; i < p.count; ++i) rho(i) = Real(rho_0 * ratio(step, i));
    Kokkos::deep_copy(p.points.density, rho);
    evolve_smoothing_length(p);
    prepare_pair_state(p, b.materials, b.method); // V = m / rho
    const auto found = host_copy(p.inverse_support);
    for (int i = 0; i < p.count; ++i)
      EXPECT_NEAR(2 * double(found(i)) * h * std::cbrt(1 / ratio(step, i)), 1, step * tolerance);
  }
}

} // namespace
} // namespace swarf::test
