#include "swarf/kernels.hpp"
#include "swarf/material/stress_update.hpp"

#include "support/materials.hpp"
#include "support/points.hpp"
#include "support/status.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>

namespace swarf {
namespace {

Tensor3 sample_gradient(int i) {
  Tensor3 L{1, 2, -3, 4, Real(-0.5), 6, -7, 8, Real(-0.6)};
  const Real s = Real(1e4) * Real(i % 17);
  return {s * L.xx, s * L.xy, s * L.xz, s * L.yx, s * L.yy, s * L.yz, s * L.zx, s * L.zy, s * L.zz};
}

void set_gradients(const MaterialPoints& p, const std::vector<Tensor3>& L) {
  auto host = Kokkos::create_mirror_view(p.velocity_gradient);
  for (int i = 0; i < p.count; ++i) store_tensor(host, i, L[i % L.size()]);
  Kokkos::deep_copy(p.velocity_gradient, host);
}

// The kernel is the pure function at every point: its own material, its own state, works per mass times mass.
TEST(UpdateStress, AppliesThePointwiseUpdateToEveryPoint) {
  const std::vector<Material> mats = {test::ti64(), test::elastic_solid(Real(1e11), Real(5e10), 8000)};
  const int count = 1000;
  const MaterialPoints p = test::make_points(count, mats[0]);
  auto material = Kokkos::create_mirror_view(p.material);
  auto density = Kokkos::create_mirror_view(p.density);
  std::vector<Tensor3> L;
  for (int i = 0; i < count; ++i)
    L.push_back(sample_gradient(i)), material(i) = i % 2, density(i) = mats[i % 2].density;
  Kokkos::deep_copy(p.material, material), Kokkos::deep_copy(p.density, density);
  Kokkos::deep_copy(p.mass, Real(0.5));
  set_gradients(p, L);
  const Status status = test::make_status();
  const Real dt = Real(1e-8);
  for (int k = 0; k < 10; ++k) update_stress(p, test::make_material_table(mats), dt, status);
  ASSERT_EQ(test::read_status(status), no_fault);

  const auto stress = host_copy(p.stress);
  const auto internal = host_copy(p.internal_work), plastic = host_copy(p.plastic_work);
  const auto temperature = host_copy(p.temperature);
  int yielded = 0;
  for (int i = 0; i < count; ++i) {
    MaterialState s{
        {0, 0, 0, 0, 0, 0}, mats[i % 2].density, 0, 0, mats[0].johnson_cook.reference_temperature, 0};
    Real w = 0, w_plastic = 0;
    for (int k = 0; k < 10; ++k) {
      const StressUpdate u = update_point(mats[i % 2], s, L[i], dt);
      s = u.state, w += Real(0.5) * u.internal_work, w_plastic += Real(0.5) * u.plastic_work;
    }
    const Real scale = 1 + von_mises(s.stress), tight = Real(test::round_off);
    ASSERT_NEAR(stress(i, 0), s.stress.xx, tight * scale);
    ASSERT_NEAR(stress(i, 5), s.stress.zx, tight * scale);
    ASSERT_NEAR(temperature(i), s.temperature, tight * s.temperature);
    ASSERT_NEAR(internal(i), w, tight * (1 + w));
    ASSERT_NEAR(plastic(i), w_plastic, tight * (1 + w));
    yielded += s.equivalent_plastic_strain > 0;
  }
  EXPECT_GT(yielded, 100);
  EXPECT_LT(yielded, 900);
}

TEST(UpdateStress, ReportsTheLowestPointThatIsNotFinite) {
  const Material mat = test::ti64();
  const MaterialPoints p = test::make_points(100, mat);
  std::vector<Tensor3> L(100, sample_gradient(0));
  L[97].xy = std::numeric_limits<Real>::quiet_NaN();
  L[42].zz = std::numeric_limits<Real>::infinity();
  set_gradients(p, L);
  const Status status = test::make_status();
  update_stress(p, test::make_material_table({mat}), Real(1e-8), status);
  EXPECT_EQ(test::read_status(status), test::fault_at(Fault::non_finite, 42));
}

// F^-1 = I - L dt has a negative determinant: the point is turned inside out.
TEST(UpdateStress, ReportsAnInvertedPoint) {
  const Material mat = test::elastic_solid(1, 1, 1);
  const MaterialPoints p = test::make_points(3, mat);
  set_gradients(p, {{0, 0, 0, 0, 0, 0, 0, 0, 0}, {3, 0, 0, 0, 0, 0, 0, 0, 0}});
  const Status status = test::make_status();
  update_stress(p, test::make_material_table({mat}), 1, status);
  EXPECT_EQ(test::read_status(status), test::fault_at(Fault::non_finite, 1));
}

double time_updates(const std::vector<Tensor3>& gradients) {
  const Material mat = test::ti64();
  const MaterialPoints p = test::make_points(100000, mat);
  set_gradients(p, gradients);
  const MaterialTable table = test::make_material_table({mat});
  const Status status = test::make_status();
  update_stress(p, table, Real(1e-9), status);
  Kokkos::fence();
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < 20; ++k) update_stress(p, table, Real(1e-9), status);
  Kokkos::fence();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / (20 * 1e5);
}

// Not a test of speed, which depends on the machine: the cost is printed, and the elastic path must be
// cheaper.
TEST(UpdateStress, ElasticPathIsCheaper) {
  const double elastic = time_updates({sample_gradient(0)});
  const double plastic = time_updates({{0, Real(1e7), 0, 0, 0, 0, 0, 0, 0}});
  std::printf("update_stress: %.0f ns per elastic point, %.0f ns per yielding point\n", elastic * 1e9,
              plastic * 1e9);
  EXPECT_LT(elastic, plastic);
}

} // namespace
} // namespace swarf
