// The damping where freezing begins; what of a wave comes back from it is in src/test_freeze.cpp.
#include "support/materials.hpp"
#include "swarf/kernels.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

TEST(AbsorbWaves, velocity_decays_exponentially_and_its_energy_leaves) {
  Motion m;
  m.count = 2;
  m.velocity = VectorField("velocity", 2), m.mass = ScalarField("mass", 2);
  m.external_work = ScalarField("external_work", 2), m.constraints = View<unsigned*>("constraints", 2);
  Kokkos::deep_copy(m.mass, Real(3)), Kokkos::deep_copy(m.velocity, Real(2));
  const ScalarField damping("damping", 2);
  const auto d = host_copy(damping);
  d(1) = 5;
  Kokkos::deep_copy(damping, d);
  for (int k = 0; k < 10; ++k) absorb_waves(m, damping, 100, Real(0.02));
  const auto v = host_copy(m.velocity);
  const auto work = host_copy(m.external_work);
  const Real kept = Kokkos::exp(Real(-1));
  EXPECT_EQ(v(0, 0), 2);
  EXPECT_EQ(work(0), 0);
  EXPECT_NEAR(v(1, 2), 2 * kept, 2 * round_off);
  EXPECT_NEAR(work(1), Real(-0.5) * 300 * 12 * (1 - kept * kept), 1800 * round_off);
}

} // namespace
} // namespace swarf::test
