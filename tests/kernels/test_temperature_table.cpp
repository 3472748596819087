// Properties over temperature: values, their integral and its inverse against a table done by hand, and what
// the material update makes of warming. 500 J/kg/K to 300 K, 700 at 500 K, 600 from 800 K on.
#include "support/materials.hpp"
#include "swarf/material/stress_update.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

constexpr double near = sizeof(Real) == 8 ? 1e-13 : 1e-5;

TemperatureTable table() {
  TemperatureTable t;
  t.points = 3;
  const Real T[] = {300, 500, 800}, value[] = {500, 700, 600};
  for (int k = 0; k < 3; ++k) t.temperature[k] = T[k], t.value[k] = value[k];
  t.integral_to[1] = 120000, t.integral_to[2] = 120000 + 195000;
  return t;
}

} // namespace

TEST(TemperatureTable, LinearBetweenItsPointsAndConstantOutside) {
  const TemperatureTable t = table();
  const double T[] = {100, 300, 400, 500, 650, 800, 2000}, value[] = {500, 500, 600, 700, 650, 600, 600};
  for (int k = 0; k < 7; ++k) EXPECT_NEAR(double(value_at(t, Real(T[k]))) / value[k], 1, near);
}

TEST(TemperatureTable, IntegralIsThatOfStraightLines) {
  const TemperatureTable t = table();
  const double T[] = {100, 400, 500, 650, 800, 1000},
               sum[] = {-100000, 55000, 120000, 221250, 315000, 435000};
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(double(integral_at(t, Real(T[k]))) / sum[k], 1, near);
}

TEST(TemperatureTable, TheInverseComesBack) {
  const TemperatureTable t = table();
  for (double T = 50; T < 1500; T += 7.3)
    EXPECT_NEAR(double(temperature_of_integral(t, integral_at(t, Real(T)))) / T, 1, 10 * near);
}

TEST(TemperatureTable, ConstantsGiveTheSameBitsAsBefore) {
  const Material mat = ti64();
  const Real T = Real(311.7), heat = Real(3.3e-9), mass = Real(4.1e-14);
  EXPECT_EQ(warmed_by(mat, mass, T, heat), T + heat / (mass * mat.specific_heat));
  EXPECT_EQ(heat_between(mat, mass, T, Real(400)), mass * mat.specific_heat * (Real(400) - T));
  EXPECT_EQ(stiffness_share(mat, T), Real(1));
}

// Held still and warmed: -3 K alpha dT in each direction, whatever warmed it, and once only.
TEST(TemperatureTable, WarmingAPointThatIsHeldStressesIt) {
  Material mat = ti64();
  mat.law = FlowLaw::elastic, mat.thermal_expansion = Real(8.7e-6);
  const MaterialState start{{0, 0, 0, 0, 0, 0}, mat.density, 0, 0, Real(400), 0};
  const Tensor3 still{0, 0, 0, 0, 0, 0, 0, 0, 0};
  const StressUpdate u = update_point(mat, start, still, Real(1e-9), Real(300));
  const double expected = -3 * double(mat.bulk_modulus) * 8.7e-6 * 100;
  for (const Real s : {u.state.stress.xx, u.state.stress.yy, u.state.stress.zz})
    EXPECT_NEAR(double(s) / expected, 1, 10 * near);
  EXPECT_EQ(u.internal_work, Real(0)); // nothing moves
  const StressUpdate again = update_point(mat, u.state, still, Real(1e-9), Real(400));
  EXPECT_EQ(again.state.stress.xx, u.state.stress.xx);
}

// The elastic strain stays, and meets the modulus of now.
TEST(TemperatureTable, SofteningScalesTheStressThatIsThere) {
  Material mat = ti64();
  mat.law = FlowLaw::elastic;
  mat.stiffness_table.points = 2;
  mat.stiffness_table.temperature[0] = 300, mat.stiffness_table.temperature[1] = 500;
  mat.stiffness_table.value[0] = 1, mat.stiffness_table.value[1] = Real(0.5);
  const MaterialState start{{100, 20, 0, 7, 0, 0}, mat.density, 0, 0, Real(400), 0};
  const StressUpdate u = update_point(mat, start, {0, 0, 0, 0, 0, 0, 0, 0, 0}, Real(1e-9), Real(300));
  EXPECT_NEAR(double(u.state.stress.xx), 75, 100 * near);
  EXPECT_NEAR(double(u.state.stress.xy), 5.25, 10 * near);
}

} // namespace swarf::test
