#include "swarf/material/flow_law.hpp"

#include "support/materials.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swarf {
namespace {

constexpr double tolerance = sizeof(Real) == 8 ? 1e-8 : 1e-5;

struct Row {
  double rate, strain, stress; // 1/s, 1, MPa
};

// Column sigma_isothermal of the adiabatic table for Ti-6Al-4V (constant plastic rate, ODE tolerance 1e-12),
// A 862 B 331 MPa n 0.34 C 0.012 m 0.8, rate 1/s, T = Tr: 9 or more digits.
TEST(FlowStress, MatchesTheIsothermalTable) {
  const Row rows[] = {{1, 0, 862},           {1, 0.02, 949.534286},    {1, 0.1, 1013.296191},
                      {1, 2, 1280.965433},   {1e3, 0, 933.453821},     {1e3, 0.02, 1028.244091},
                      {1e3, 1, 1291.891425}, {1e5, 0.05, 1117.133655}, {1e5, 2, 1457.937347}};
  const Material mat = test::ti64();
  for (const Row& row : rows)
    EXPECT_NEAR(flow_stress(mat, Real(row.strain), Real(row.rate), mat.johnson_cook.reference_temperature) /
                    1e6 / row.stress,
                1, tolerance)
        << row.rate << " " << row.strain;
}

// Row 1e3 1/s, eps 2 of the same table: 682.105210 MPa at 976.153474 K.
TEST(FlowStress, SoftensWithTemperature) {
  EXPECT_NEAR(flow_stress(test::ti64(), 2, 1000, Real(976.153474)) / 682.105210e6, 1, tolerance);
}

TEST(FlowStress, RateFactorIsOneBelowTheReferenceRateAndContinuousThere) {
  Material mat = test::ti64();
  mat.johnson_cook.reference_rate = 50;
  const Real at = flow_stress(mat, Real(0.1), 50, 300);
  EXPECT_EQ(flow_stress(mat, Real(0.1), 0, 300), at);
  EXPECT_EQ(flow_stress(mat, Real(0.1), Real(49.9), 300), at);
  const Real step = sizeof(Real) == 8 ? Real(1e-9) : Real(1e-4);
  const Real above = flow_stress(mat, Real(0.1), 50 * (1 + step), 300);
  EXPECT_NEAR((above / at - 1) / (mat.johnson_cook.C * step), 1,
              sizeof(Real) == 8 ? 1e-5 : 0.2); // slope C just above
}

TEST(FlowStress, VanishesAtTheMeltingPointAndKeepsFullStrengthBelowTheReferenceTemperature) {
  const Material mat = test::ti64();
  EXPECT_EQ(flow_stress(mat, 1, 1000, mat.johnson_cook.melt_temperature), Real(0));
  EXPECT_EQ(flow_stress(mat, 1, 1000, 2 * mat.johnson_cook.melt_temperature), Real(0));
  EXPECT_GT(flow_stress(mat, 1, 1000, Real(0.999) * mat.johnson_cook.melt_temperature), Real(0));
  EXPECT_EQ(flow_stress(mat, 0, 0, 4), mat.johnson_cook.A);
  EXPECT_EQ(flow_stress(mat, 0, 0, mat.johnson_cook.reference_temperature), mat.johnson_cook.A);
}

// 4340 steel, Johnson & Cook (1985), table 3: D1..D5 = 0.05, 3.44, -2.12, 0.002, 0.61.
TEST(FractureStrain, FollowsTheThreeFactorsOfJohnsonAndCook) {
  Material mat = test::ti64();
  mat.damage = {true, Real(0.05), Real(3.44), Real(-2.12), Real(0.002), Real(0.61)};
  const Real T_half =
      Real(0.5) * (mat.johnson_cook.reference_temperature + mat.johnson_cook.melt_temperature);
  const double third = 0.05 + 3.44 * std::exp(-2.12 / 3); // uniaxial tension
  EXPECT_NEAR(fracture_strain(mat, Real(1. / 3), 1, 298), third, 1e-5);
  EXPECT_NEAR(fracture_strain(mat, Real(1. / 3), Real(0.1), 298), third, 1e-5); // clamped below the rate
  EXPECT_NEAR(fracture_strain(mat, 0, 100, 298), 3.49 * (1 + 0.002 * std::log(100.)), 1e-5);
  EXPECT_NEAR(fracture_strain(mat, 0, 1, T_half), 3.49 * (1 + 0.61 * 0.5), 1e-5);
}

} // namespace
} // namespace swarf
