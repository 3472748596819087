// The correction of the gradient where neighbours lack: sheets, strings, lone pairs.
#include "support/materials.hpp"
#include "support/particle_block.hpp"
#include "swarf/particles/correction.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

double gradient_error(int nx, int ny, int nz, const Tensor3& L0, Real disorder) {
  ParticleBlock b = particle_block(nx, ny, nz, 1, disorder);
  if (nz == 1)
    set_rows(b.particles.position, b.particles.count, [](const Vector3& x) { return Vector3{x.x, x.y, 0}; });
  if (ny == 1)
    set_rows(b.particles.position, b.particles.count, [](const Vector3& x) { return Vector3{x.x, 0, x.z}; });
  build_lists(b);
  const auto x = host_copy(b.particles.position), v = host_copy(b.particles.velocity);
  for (int i = 0; i < b.particles.count; ++i) store_vector(v, i, multiply(L0, load_vector(x, i)));
  Kokkos::deep_copy(b.particles.velocity, v);
  velocity_gradient(b.particles, b.neighbors, b.method);
  const auto L = host_copy(b.particles.points.velocity_gradient);
  double worst = 0;
  for (int i = 0; i < b.particles.count; ++i)
    for (int c = 0; c < 9; ++c) worst = std::max(worst, double(std::abs(L(i, c) - (&L0.xx)[c])));
  return worst;
}

// Linear fields along a sheet of one row, and along a string of particles, are exact.
TEST(Correction, IsExactAlongASheetAndAString) {
  EXPECT_LT(gradient_error(9, 8, 1, {1, 2, 0, -3, 0.5, 0, 4, -1, 0}, Real(0.2)), 1e3 * round_off);
  EXPECT_LT(gradient_error(9, 1, 1, {1, 0, 0, -3, 0, 0, 4, 0, 0}, Real(0.2)), 1e3 * round_off);
}

// What would be amplified more than 4 times the mean is not: A of a sheet that is nearly flat.
TEST(Correction, IsBoundedWhereADirectionHasHardlyAnyNeighbours) {
  const auto at = correction_from({Real(0.6), Real(0.6), Real(1e-4), 0, 0, 0});
  EXPECT_FALSE(at.exact);
  EXPECT_NEAR(double(at.K.xx), 1 / 0.6, 1e-6);
  EXPECT_NEAR(double(at.K.zz), 1 / 0.1, 1e-3);
  const auto inside = correction_from({Real(0.9), Real(0.8), Real(0.3), 0, 0, 0});
  EXPECT_TRUE(inside.exact);
  EXPECT_NEAR(double(inside.K.zz), 1 / 0.3, 1e-4);
}

// Whatever its volumes are: tied particles keep theirs down to nothing along the ramp of the tie.
TEST(Correction, IsExactAmongTiedParticles) {
  const auto at = correction_from({Real(0.009), Real(0.008), Real(0.005), 0, 0, 0}, true);
  EXPECT_TRUE(at.exact);
  EXPECT_NEAR(double(at.K.zz), 1 / 0.005, 1e-2);
}

// A pair that parts: K A, by which the force of the pair is weighed, falls to 0 without a jump.
TEST(Correction, FadesWithTheLastNeighbour) {
  double before = 1;
  for (const double a : {0.3, 0.2, 0.1, 0.09, 0.05, 0.01, 0.0}) {
    const double weight = double(correction_from({Real(a), 0, 0, 0, 0, 0}).K.xx) * a;
    EXPECT_LE(weight, before + 1e-9);
    EXPECT_NEAR(weight, std::min(1.0, a / 0.1), 1e-6) << a;
    before = weight;
  }
}

} // namespace
} // namespace swarf::test
