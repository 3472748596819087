#include "swarf/material/stress_update.hpp"

#include "support/materials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace swarf {
namespace {

constexpr bool is_double = sizeof(Real) == 8;

MaterialState make_state(const Material& mat) {
  return {{0, 0, 0, 0, 0, 0}, mat.density, 0, 0, mat.johnson_cook.reference_temperature, 0};
}

// L at the step's end whose midpoint strain is exactly diag(x, y, z).
Tensor3 make_stretch(Real x, Real y, Real z, Real dt) {
  return {x / (1 + x / 2) / dt, 0, 0, 0, y / (1 + y / 2) / dt, 0, 0, 0, z / (1 + z / 2) / dt};
}

// Largest relative error of the flow stress against rows of the adiabatic table, in steps of `step` strain.
struct TableRow {
  double strain, stress, temperature; // 1, MPa, K
};
double measure_table_error(double rate, const std::vector<TableRow>& rows, double step) {
  const Material mat = test::ti64();
  const Real dt = Real(step / rate), d = Real(step);
  MaterialState s = make_state(mat), before = s;
  double error = 0;
  for (const TableRow& row : rows) {
    while (s.equivalent_plastic_strain < Real(row.strain)) {
      before = s;
      s = update_point(mat, s, make_stretch(d, -d / 2, -d / 2, dt), dt).state;
    }
    const double e0 = before.equivalent_plastic_strain, e1 = s.equivalent_plastic_strain;
    const double t = (row.strain - e0) / (e1 - e0);
    const double stress = (1 - t) * von_mises(before.stress) + t * von_mises(s.stress);
    error = std::max(error, std::abs(stress / 1e6 / row.stress - 1));
    const double temperature = (1 - t) * before.temperature + t * s.temperature;
    EXPECT_NEAR(temperature, row.temperature, 1e-3 * row.temperature) << rate << " 1/s, eps " << row.strain;
  }
  return error;
}

// Adiabatic table for Ti-6Al-4V: A 862 B 331 MPa n 0.34 C 0.012 m 0.8, rate 1/s, rho 4430, c 526.3, beta 0.9,
// T0 = Tr = 298.15 K, Tm 1878 K, constant plastic rate, solved as an ODE to 1e-12.
TEST(StressUpdate, FollowsTheAdiabaticTable) {
  const std::vector<TableRow> slow = {{0.02, 936.946811, 305.256419}, {0.05, 954.074915, 316.222553},
                                      {0.1, 963.453110, 334.747502},  {0.2, 962.662785, 371.970181},
                                      {0.3, 952.715955, 408.955980},  {0.5, 922.989924, 481.414325},
                                      {0.7, 888.186837, 551.346346},  {1.0, 833.367907, 651.039187},
                                      {1.5, 743.254163, 803.119051},  {2.0, 659.107332, 938.339006}};
  const std::vector<TableRow> quick = {{0.02, 1013.722191, 305.841745}, {0.05, 1031.231509, 317.700429},
                                       {0.1, 1039.850379, 337.708628},  {0.2, 1036.262849, 377.829170},
                                       {0.3, 1023.037563, 417.593487},  {0.5, 986.510770, 495.218466},
                                       {0.7, 945.074948, 569.796563},   {1.0, 880.971114, 675.531273},
                                       {1.5, 777.371558, 835.457626},   {2.0, 682.105210, 976.153474}};
  const std::vector<TableRow> quickest = {{0.02, 1064.838385, 306.231679}, {0.05, 1082.524266, 318.684155},
                                          {0.1, 1090.524042, 339.677277},  {0.2, 1084.876835, 381.715909},
                                          {0.3, 1069.297514, 423.311773},  {0.5, 1027.956421, 504.321969},
                                          {0.7, 981.876832, 581.918945},   {1.0, 911.336404, 691.536276},
                                          {1.5, 798.512185, 856.403473},   {2.0, 695.761778, 1000.431225}};
  EXPECT_LT(measure_table_error(1, slow, 1e-3), 1e-3);
  EXPECT_LT(measure_table_error(1e3, quick, 1e-3), 1e-3);
  const double coarse = measure_table_error(1e5, quickest, 1e-3);
  EXPECT_LT(coarse, 1e-3);
  if (is_double) { // first order in the step
    EXPECT_NEAR(coarse / measure_table_error(1e5, quickest, 5e-4), 2, 0.4);
  }
  std::printf("largest error at 1e5 1/s, steps of 1e-3: %.3g\n", coarse);
}

// Closed form of the Jaumann rate in simple shear: tau = G sin(gamma), sigma_xx = -sigma_yy = G (1 -
// cos(gamma)) (Dienes 1979).
double measure_shear_error(int steps) {
  const Material mat = test::elastic_solid(3, 1, 1);
  MaterialState s = make_state(mat);
  double error = 0;
  const Real dt = Real(10) / steps;
  for (int k = 1; k <= steps; ++k) {
    s = update_point(mat, s, {0, 1, 0, 0, 0, 0, 0, 0, 0}, dt).state;
    const double gamma = 10. * k / steps;
    error = std::max(error, std::abs(s.stress.xy - std::sin(gamma)));
    error = std::max(error, std::abs(s.stress.xx - (1 - std::cos(gamma))));
    error = std::max(error, std::abs(s.stress.yy + (1 - std::cos(gamma))));
    error = std::max(error, std::abs(s.density - 1.));
  }
  return error;
}
TEST(StressUpdate, FollowsJaumannsOscillationInSimpleShear) {
  const double error = measure_shear_error(1000);
  EXPECT_LT(error, is_double ? 1e-4 : 1e-3);
  if (is_double) { // second order
    EXPECT_NEAR(error / measure_shear_error(2000), 4, 0.1);
  }
  std::printf("simple shear to 10 in 1000 steps: error %.3g G\n", error);
}

TEST(StressUpdate, RigidRotationThrough360DegreesKeepsTheStress) {
  const Material mat = test::ti64();
  MaterialState s = make_state(mat);
  const Symmetric3 stress{Real(3e8), Real(-1e8), Real(2e8), Real(5e7), Real(-9e7), Real(4e7)};
  s.stress = stress;
  const double angle = 2 * M_PI / 360, c = std::cos(angle), sn = std::sin(angle);
  // About (1, 2, 2) / 3, by Rodrigues' formula; x_n = Q^T x_n+1, so L dt = I - Q^T.
  const double u[3] = {1. / 3, 2. / 3, 2. / 3},
               U[3][3] = {{0, -u[2], u[1]}, {u[2], 0, -u[0]}, {-u[1], u[0], 0}};
  double L[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) L[j][i] = (1 - c) * ((i == j) - u[i] * u[j]) - sn * U[i][j];
  const Tensor3 gradient{Real(L[0][0]), Real(L[0][1]), Real(L[0][2]), Real(L[1][0]), Real(L[1][1]),
                         Real(L[1][2]), Real(L[2][0]), Real(L[2][1]), Real(L[2][2])};
  double drift = 0;
  for (int k = 0; k < 360; ++k) {
    s = update_point(mat, s, gradient, 1).state;
    drift = std::max(drift, std::abs(double(contract(s.stress, s.stress) / contract(stress, stress)) - 1));
    drift = std::max(drift, std::abs(double(trace(s.stress) / trace(stress)) - 1));
  }
  EXPECT_LT(drift, is_double ? 1e-10 : 1e-1);
  const Symmetric3 change = s.stress + Real(-1) * stress;
  EXPECT_LT(std::sqrt(contract(change, change) / contract(stress, stress)), is_double ? 1e-10 : 1e-1);
  EXPECT_NEAR(s.density / mat.density, 1, is_double ? 1e-12 : 1e-4);
  EXPECT_EQ(s.equivalent_plastic_strain, 0);
}

// Confined compression of a linearly hardening solid: p = (2 G e - Y) / (3 G + H), q = Y + H p,
// sigma_xx = -K e - 2 q / 3; density and works as well.
TEST(StressUpdate, LinearHardeningMatchesTheClosedFormOfUniaxialStrain) {
  Material mat = test::elastic_solid(Real(140e9), Real(47e9), 8930);
  mat.law = FlowLaw::linear_hardening, mat.linear_hardening = {Real(400e6), Real(100e6)};
  mat.taylor_quinney = 1, mat.specific_heat = 383;
  MaterialState s = make_state(mat);
  const int steps = 100;
  const double e = 0.02, de = e / steps, K = 140e9, G = 47e9, Y = 400e6, H = 100e6;
  double heat = 0;
  for (int k = 0; k < steps; ++k) {
    const StressUpdate u = update_point(mat, s, make_stretch(Real(-de), 0, 0, 1), 1);
    EXPECT_LE(u.iterations, 2); // linear: Newton's method is exact
    heat += u.plastic_work / 383;
    s = u.state;
  }
  const double p = (2 * G * e - Y) / (3 * G + H);
  const double tight = is_double ? 1e-9 : 1e-3;
  EXPECT_NEAR(s.equivalent_plastic_strain / p, 1, tight);
  EXPECT_NEAR(s.stress.xx / (-K * e - 2. / 3 * (Y + H * p)), 1, tight);
  EXPECT_NEAR(s.stress.yy / (-K * e + (Y + H * p) / 3), 1, tight);
  EXPECT_NEAR(s.density / (8930 * std::pow((1 + de / 2) / (1 - de / 2), steps)), 1, is_double ? 1e-12 : 1e-4);
  EXPECT_NEAR(heat, s.temperature - mat.johnson_cook.reference_temperature, is_double ? 1e-10 : 1e-2);
}

// Elastic work of confined compression, per volume of the undeformed solid: M e^2 / 2, e small.
TEST(StressUpdate, InternalWorkIsTheElasticEnergy) {
  const Material mat = test::elastic_solid(Real(140e9), Real(47e9), 8930);
  MaterialState s = make_state(mat);
  double work = 0;
  for (int k = 0; k < 100; ++k) {
    const StressUpdate u = update_point(mat, s, make_stretch(Real(-1e-6), 0, 0, 1), 1);
    work += u.internal_work;
    s = u.state;
  }
  EXPECT_NEAR(work * 8930 / (0.5 * (140e9 + 4. / 3 * 47e9) * 1e-8), 1, 2e-4);
}

TEST(ReturnMapping, ConvergesQuadratically) {
  Material mat = test::ti64();
  mat.shear_modulus = Real(1e9); // soft: hardening and rate count, so that there is a history to look at
  std::vector<double> residual;
  for (int k = 1; k < 20; ++k) {
    const ReturnMapping r = return_radially(mat.johnson_cook, 3 * mat.shear_modulus, Real(2.5e9), Real(0.01),
                                            Real(1e-4), Real(1), k);
    residual.push_back(std::abs(r.residual / r.flow_stress));
    if (r.converged) break;
  }
  ASSERT_LE(residual.size(), 8u);
  int quadratic = 0;
  for (std::size_t k = 0; k + 1 < residual.size(); ++k) {
    std::printf("residual %.3e -> %.3e\n", residual[k], residual[k + 1]);
    if (residual[k] > 0.1) continue;
    EXPECT_LT(residual[k + 1], std::max(residual[k] * residual[k], 1e-14)); // the constant is below 1 here
    ++quadratic;
  }
  EXPECT_GE(quadratic, is_double ? 2 : 1);
}

// Every admissible start converges: first yield (infinite slope at eps = 0), rates on both sides of the
// reference rate, overstress from 1 + 1e-9 to 100.
TEST(ReturnMapping, ConvergesFromEveryStart) {
  Material mat = test::ti64();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  int most = 0;
  long total = 0;
  const int trials = 100000;
  for (int k = 0; k < trials; ++k) {
    mat.johnson_cook.n = Real((is_double ? 0.1 : 0.25) + uniform(random)),
    mat.johnson_cook.m = Real(0.5 + uniform(random));
    const JohnsonCook& law = mat.johnson_cook;
    const Real strain = k % 3 ? Real(std::pow(10., -12 + 13 * uniform(random))) : Real(0);
    const Real softening = law.thermal(Real(2000 * uniform(random)));
    const Real dt = Real(std::pow(10., -10 + 12 * uniform(random)));
    const Real yield = law.stress(strain, 0, dt, softening).value;
    const Real q = softening > 0 ? yield * Real(1 + std::pow(10., -9 + 11 * uniform(random))) : Real(1e9);
    if (!(q > yield)) continue;
    const ReturnMapping r = return_radially(law, 3 * mat.shear_modulus, q, strain, dt, softening);
    ASSERT_TRUE(r.converged) << "eps " << strain << " q/yield " << q / yield << " dt " << dt;
    ASSERT_GE(r.increment, 0);
    most = std::max(most, r.iterations), total += r.iterations;
  }
  std::printf("iterations: %.2f on average, %d at most\n", double(total) / trials, most);
  EXPECT_LT(most, return_max_iterations);
  EXPECT_LT(double(total) / trials, 5);
}

TEST(ReturnMapping, SaysWhereItDidNotConverge) {
  const Material mat = test::ti64();
  EXPECT_FALSE(return_radially(mat.johnson_cook, 3 * mat.shear_modulus, Real(3e9), 0, Real(1e-6), Real(1), 1)
                   .converged);
}

// The share of a step above the reference rate grows from nothing: no jump of the stress with the step's
// length.
TEST(ReturnMapping, IsContinuousAtTheReferenceRate) {
  const Material mat = test::ti64();
  const auto after = [&](Real dt) {
    return return_radially(mat.johnson_cook, 3 * mat.shear_modulus, Real(1.05e9), 0, dt, Real(1));
  };
  const Real rate_dt = after(1).increment; // dt at which the rate is 1/s
  const Real step = is_double ? Real(1e-6) : Real(1e-3);
  const Real slower = after(rate_dt * (1 + step)).flow_stress;
  const Real faster = after(rate_dt * (1 - step)).flow_stress;
  EXPECT_NEAR(faster / slower, 1, mat.johnson_cook.C * step + return_tolerance * 4);
}

TEST(StressUpdate, MoltenPointKeepsOnlyPressure) {
  const Material mat = test::ti64();
  MaterialState s = make_state(mat);
  s.temperature = mat.johnson_cook.melt_temperature;
  s.stress = {Real(-1e8), Real(-3e8), Real(-2e8), Real(5e7), 0, 0};
  const StressUpdate u = update_point(mat, s, {0, 0, 0, 0, 0, 0, 0, 0, 0}, Real(1e-8));
  EXPECT_LT(von_mises(u.state.stress), 1e-6 * 2e8);
  EXPECT_NEAR(trace(u.state.stress) / -6e8, 1, test::round_off);
  EXPECT_TRUE(u.converged);
}

// Pure deviatoric stretch has no mean stress: fracture strain D1 + D2 = 0.3 at a rate factor 1 and T* ~ 0.
TEST(StressUpdate, DamageFailsAtTheFractureStrainAndLeavesNoDeviatorAndNoTension) {
  Material mat = test::ti64();
  mat.damage = {true, Real(0.1), Real(0.2), Real(-1.5), 0, 0};
  mat.taylor_quinney = 0;
  MaterialState s = make_state(mat);
  const Real d = Real(1e-3);
  int steps = 0;
  while (s.damage < 1 && steps < 1000)
    s = update_point(mat, s, make_stretch(d, -d / 2, -d / 2, 1), 1).state, ++steps;
  EXPECT_NEAR(s.equivalent_plastic_strain, 0.3, 1.01e-3);
  EXPECT_EQ(s.damage, 1);
  EXPECT_EQ(von_mises(s.stress), 0);
  s = update_point(mat, s, make_stretch(d, d, d, 1), 1).state;
  EXPECT_EQ(trace(s.stress), 0);
  const Real strain = s.equivalent_plastic_strain;
  s = update_point(mat, s, make_stretch(-2 * d, -2 * d, -2 * d, 1), 1).state;
  EXPECT_NEAR(trace(s.stress) / (-9 * 1e-3 * mat.bulk_modulus), 1, is_double ? 1e-5 : 1e-2);
  EXPECT_EQ(von_mises(s.stress), 0);
  EXPECT_EQ(s.equivalent_plastic_strain, strain); // a failed point does not flow
}

} // namespace
} // namespace swarf
