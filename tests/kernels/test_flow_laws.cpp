// What every flow law must keep, and tables of those that test_johnson_cook.cpp does not know.
#include "swarf/material/stress_update.hpp"

#include "support/materials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace swarf {
namespace {

constexpr bool is_double = sizeof(Real) == 8;

std::vector<std::pair<std::string, Material>> all_laws() {
  Material linear = test::ti64();
  linear.law = FlowLaw::linear_hardening, linear.linear_hardening = {Real(400e6), Real(100e6)};
  return {{"linear_hardening", linear},
          {"johnson_cook", test::ti64()},
          {"johnson_cook_tanh", test::softening_ti64()},
          {"zerilli_armstrong, iron", test::zerilli_armstrong_iron()},
          {"zerilli_armstrong, copper", test::zerilli_armstrong_copper()}};
}

struct Row {
  double strain, rate, temperature, stress; // -, 1/s, K, MPa
};

void expect_table(const Material& mat, std::initializer_list<Row> rows) {
  for (const Row& r : rows)
    EXPECT_NEAR(flow_stress(mat, Real(r.strain), Real(r.rate), Real(r.temperature)) / 1e6 / r.stress, 1,
                is_double ? 1e-8 : 1e-4)
        << r.strain << " " << r.rate << " " << r.temperature;
}

// Tables: the formulas in double precision, in another language.
TEST(FlowLaws, ZerilliArmstrongIsThatOfIronAndOfCopper) {
  expect_table(test::zerilli_armstrong_iron(), {{0, 1e3, 300, 300.737563191},
                                                {0.1, 1, 300, 263.994368164},
                                                {0.1, 1e3, 600, 224.289417627},
                                                {1, 1e5, 900, 408.351610922}});
  expect_table(test::zerilli_armstrong_copper(), {{0, 1e3, 300, 65},
                                                  {0.1, 1, 300, 186.501780407},
                                                  {0.1, 1e3, 600, 149.484157407},
                                                  {1, 1e5, 900, 300.758799966}});
}

TEST(FlowLaws, JohnsonCookWithTanhSoftensWithStrain) {
  expect_table(test::softening_ti64(), {{0, 1e3, 298, 1186.400270912},
                                        {0.1, 1, 298, 1372.315030683},
                                        {0.5, 1e3, 700, 929.619635012},
                                        {2, 1e5, 1200, 207.575152034},
                                        {4, 1e4, 900, 398.770660490}});
}

TEST(FlowLaws, SlopesAreDerivativesAtConstantStep) {
  const Real start = Real(0.3), increment = Real(2e-3), dt = Real(1e-6),
             h = is_double ? Real(1e-8) : Real(1e-3);
  for (const auto& [name, mat] : all_laws())
    for (const Real temperature : {Real(200), Real(320), Real(1100)})
      visit_law(mat, [&, &name = name](const auto& law) {
        const auto at = [&](Real d) { return law.stress(start + d, d, dt, law.thermal(temperature)); };
        const Real difference = (at(increment + h).value - at(increment - h).value) / (2 * h);
        EXPECT_NEAR(difference / at(increment).slope, 1, is_double ? 1e-6 : 0.1)
            << name << " " << temperature;
      });
}

TEST(FlowLaws, NothingFlowsBelowTheElasticLimit) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(0, 1);
  for (const auto& [name, mat] : all_laws())
    visit_law(mat, [&, &name = name](const auto& law) {
      for (int k = 0; k < 1000; ++k) {
        const Real T = Real(1900 * u(random)), strain = Real(k % 4 ? 10 * u(random) : 0);
        const Real d = Real(std::pow(10., -12 * u(random)));
        EXPECT_LE(law.elastic_limit(T),
                  law.stress(strain, d, Real(1e-6), law.thermal(T)).value * Real(1 + 1e-6))
            << name << ", " << T << " K, strain " << strain;
      }
    });
}

// First yield (infinite slopes at eps = 0), rates on both sides of the reference rate, overstress from 1 +
// 1e-9 to 100.
TEST(FlowLaws, ReturnMappingConvergesFromEveryStart) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(0, 1);
  for (const auto& [name, mat] : all_laws())
    visit_law(mat, [&, &mat = mat, &name = name](const auto& law) {
      long total = 0;
      const int trials = 20000;
      for (int k = 0; k < trials; ++k) {
        const auto thermal = law.thermal(Real(2000 * u(random)));
        const Real strain = k % 3 ? Real(std::pow(10., -12 + 13 * u(random))) : Real(0);
        const Real dt = Real(std::pow(10., -10 + 12 * u(random)));
        const Real yield = law.stress(strain, 0, dt, thermal).value;
        const Real q = yield > 0 ? yield * Real(1 + std::pow(10., -9 + 11 * u(random))) : Real(1e9);
        if (!(q > yield)) continue;
        const ReturnMapping r = return_radially(law, 3 * mat.shear_modulus, q, strain, dt, thermal);
        ASSERT_TRUE(r.converged) << name << ", eps " << strain << " q/yield " << q / yield << " dt " << dt;
        ASSERT_GE(r.increment, 0);
        total += r.iterations;
      }
      std::printf("%s: %.2f iterations on average\n", name.c_str(), double(total) / trials);
      EXPECT_LT(double(total) / trials, 10) << name; // halving the bracket takes 30
    });
}

// Ten steps of shear: stress on the yield surface, plastic work all heat but for the share that is kept.
TEST(FlowLaws, PointsFollowThem) {
  for (const auto& [name, mat] : all_laws()) {
    MaterialState s{{0, 0, 0, 0, 0, 0}, mat.density, 0, 0, 300, 0};
    double work = 0;
    Real before = 0;
    for (int k = 0; k < 20; ++k) {
      before = s.temperature;
      const StressUpdate update = update_point(mat, s, {0, Real(1e4), 0, 0, 0, 0, 0, 0, 0}, Real(1e-6));
      ASSERT_TRUE(update.converged) << name;
      work += double(update.plastic_work), s = update.state;
    }
    const Real flow = flow_stress(mat, s.equivalent_plastic_strain, s.plastic_strain_rate, before);
    EXPECT_NEAR(von_mises(s.stress) / flow, 1, is_double ? 1e-8 : 1e-4) << name;
    EXPECT_NEAR(work * 0.9 / mat.specific_heat / (s.temperature - 300), 1, is_double ? 1e-10 : 1e-3) << name;
  }
}

} // namespace
} // namespace swarf
