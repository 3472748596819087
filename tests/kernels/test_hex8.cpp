#include "swarf/hexes/hex8.hpp"

#include "support/hex_block.hpp"
#include "support/materials.hpp"
#include "support/particle_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace swarf {
namespace {

constexpr int sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                            {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
constexpr double round_off = test::round_off;

HexVectors unit_cube() {
  HexVectors x;
  for (int a = 0; a < 8; ++a)
    x.at[a] = {Real(0.5 * (1 + sign[a][0])), Real(0.5 * (1 + sign[a][1])), Real(0.5 * (1 + sign[a][2]))};
  return x;
}

HexVectors distorted_cube(std::mt19937& random) {
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  HexVectors x = unit_cube();
  for (Vector3& c : x.at) c = c + Vector3{Real(shift(random)), Real(shift(random)), Real(shift(random))};
  return x;
}

// Integral over the trilinear hex of J (c = -1) or of J dN_c/dx_d by Gauss' rule with n points a direction;
// both integrands are polynomials of degree <= 2 in each direction, so 2 points are exact.
double integrate(const HexVectors& x, int c, int d) {
  const double g = 1 / std::sqrt(3.);
  double sum = 0;
  for (int p = 0; p < 8; ++p) {
    const double s[3] = {g * sign[p][0], g * sign[p][1], g * sign[p][2]};
    double J[3][3] = {}, dN[8][3];
    for (int a = 0; a < 8; ++a) {
      double f[3];
      for (int i = 0; i < 3; ++i) f[i] = 1 + s[i] * sign[a][i];
      for (int i = 0; i < 3; ++i) dN[a][i] = sign[a][i] * f[(i + 1) % 3] * f[(i + 2) % 3] / 8;
      const double X[3] = {x.at[a].x, x.at[a].y, x.at[a].z};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) J[i][j] += X[i] * dN[a][j];
    }
    auto cofactor = [&](int i, int j) {
      return J[(i + 1) % 3][(j + 1) % 3] * J[(i + 2) % 3][(j + 2) % 3] -
             J[(i + 1) % 3][(j + 2) % 3] * J[(i + 2) % 3][(j + 1) % 3];
    };
    if (c < 0)
      for (int j = 0; j < 3; ++j) sum += J[0][j] * cofactor(0, j);
    else
      for (int j = 0; j < 3; ++j) sum += dN[c][j] * cofactor(d, j);
  }
  return sum;
}

TEST(MeanGradient, IsTheExactIntegralOverDistortedHexes) {
  std::mt19937 random(1);
  for (int k = 0; k < 100; ++k) {
    const HexVectors x = distorted_cube(random);
    const HexGradient g = mean_gradient(x);
    ASSERT_NEAR(g.volume, integrate(x, -1, 0), round_off);
    for (int a = 0; a < 8; ++a) {
      ASSERT_NEAR(g.B.at[a].x * g.volume, integrate(x, a, 0), round_off);
      ASSERT_NEAR(g.B.at[a].y * g.volume, integrate(x, a, 1), round_off);
      ASSERT_NEAR(g.B.at[a].z * g.volume, integrate(x, a, 2), round_off);
    }
  }
}

TEST(MeanGradient, VolumeOfAnInvertedHexIsNegative) {
  HexVectors x = unit_cube();
  for (Vector3& c : x.at) c.z = -c.z;
  EXPECT_NEAR(mean_gradient(x).volume, -1, round_off);
}

Vector3 linear_field(const Vector3& x) {
  const Tensor3 L{Real(0.3), -2, 1, Real(0.7), Real(-0.1), 4, -3, Real(1.5), Real(0.8)};
  return multiply(L, x);
}

TEST(VelocityGradient, IsExactForLinearFieldsOnDistortedHexes) {
  std::mt19937 random(2);
  for (int k = 0; k < 100; ++k) {
    const HexVectors x = distorted_cube(random);
    HexVectors v;
    for (int a = 0; a < 8; ++a) v.at[a] = linear_field(x.at[a]);
    const Tensor3 L = velocity_gradient(v, mean_gradient(x).B);
    ASSERT_NEAR(L.xx, 0.3, round_off);
    ASSERT_NEAR(L.xy, -2, round_off);
    ASSERT_NEAR(L.zx, -3, round_off);
    ASSERT_NEAR(L.yz, 4, round_off);
    const HexModes q = hourglass_rates(project_modes(x), v, L); // and no hourglass rate
    for (const Vector3& mode : q.mode) ASSERT_LT(norm(mode), round_off * 10);
  }
}

// The base vectors are eta zeta, zeta xi, xi eta, xi eta zeta; each sees its own displacement only, as 8.
TEST(HourglassModes, EachProjectionSeesItsOwnMode) {
  const HexVectors x = unit_cube();
  const HexVectors B = mean_gradient(x).B;
  for (int m = 0; m < 4; ++m) {
    HexVectors v;
    for (int a = 0; a < 8; ++a) {
      const int* s = sign[a];
      const int h[4] = {s[1] * s[2], s[2] * s[0], s[0] * s[1], s[0] * s[1] * s[2]};
      v.at[a] = {Real(h[m]), Real(2 * h[m]), Real(-h[m])};
    }
    const Tensor3 L = velocity_gradient(v, B);
    EXPECT_NEAR(std::abs(L.xx) + std::abs(L.yy) + std::abs(L.xy), 0, round_off); // the mean gradient is blind
    const HexModes q = hourglass_rates(project_modes(x), v, L);
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(q.mode[k].x, k == m ? 8 : 0, round_off);
      EXPECT_NEAR(q.mode[k].y, k == m ? 16 : 0, round_off);
      EXPECT_NEAR(q.mode[k].z, k == m ? -8 : 0, round_off);
    }
  }
}

// Forces do the power that the rates say: sum f_a v_a = -(V sigma : L + sum Q q), and balance as forces and
// torques, for any nodal velocity, on distorted hexes.
TEST(CornerForces, AreWorkConjugateAndInBalance) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  auto draw = [&] { return Vector3{Real(uniform(random)), Real(uniform(random)), Real(uniform(random))}; };
  for (int k = 0; k < 100; ++k) {
    const HexVectors x = distorted_cube(random);
    const HexGradient g = mean_gradient(x);
    HexVectors v;
    for (Vector3& u : v.at) u = draw();
    HexModes Q;
    for (Vector3& f : Q.mode) f = draw();
    const Symmetric3 s{1, -2, Real(0.5), Real(0.3), Real(-0.7), 2};
    const HexModes modes = project_modes(x);
    const HexVectors f = corner_forces(g.volume * s, g.B, modes, Q);
    const Tensor3 L = velocity_gradient(v, g.B);
    const HexModes q = hourglass_rates(modes, v, L);
    double power = g.volume * contract(s, symmetric_part(L));
    for (int m = 0; m < 4; ++m) power += dot(Q.mode[m], q.mode[m]);
    Vector3 force{0, 0, 0}, torque{0, 0, 0};
    for (int a = 0; a < 8; ++a) {
      power += dot(f.at[a], v.at[a]);
      force = force + f.at[a], torque = torque + cross(x.at[a], f.at[a]);
    }
    ASSERT_NEAR(power, 0, 10 * round_off);
    ASSERT_LT(norm(force), 10 * round_off);
    ASSERT_LT(norm(torque), 10 * round_off);
  }
}

TEST(LargestEigenvalue, MatchesKnownSpectra) {
  EXPECT_NEAR(largest_eigenvalue({3, 3, 3, 0, 0, 0}), 3, round_off);
  EXPECT_NEAR(largest_eigenvalue({1, -5, 2, 0, 0, 0}), 2, round_off);
  // [[2 -1 0] [-1 2 -1] [0 -1 2]]: 2 - sqrt 2, 2, 2 + sqrt 2
  EXPECT_NEAR(largest_eigenvalue({2, 2, 2, -1, -1, 0}), 2 + std::sqrt(2.), round_off);
}

TEST(CharacteristicLength, IsTheEdgeOfACubeAndTheThicknessOfABrickInAnyDirection) {
  HexVectors x = unit_cube();
  EXPECT_NEAR(characteristic_length(mean_gradient(x).B), 1, round_off);
  const Real c = Real(0.6), s = Real(0.8);
  for (Vector3& p : x.at) { // 3 x 2 x 0.1, turned about x, then about z
    p = {3 * p.x, 2 * p.y, Real(0.1) * p.z};
    p = {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
    p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
  }
  EXPECT_NEAR(characteristic_length(mean_gradient(x).B), 0.1, 1e3 * round_off);
}

// Highest frequency of a free hex, by power iteration on the forces that a motion of its corners brings: 8 /
// rho V times the largest eigenvalue of its stiffness.
double free_hex_frequency2(const HexVectors& x, const Material& mat) {
  const HexGradient g = mean_gradient(x);
  const Real lambda = mat.bulk_modulus - 2 * mat.shear_modulus / 3;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  HexVectors u;
  for (Vector3& v : u.at) v = {Real(uniform(random)), Real(uniform(random)), Real(uniform(random))};
  double eigenvalue = 0;
  for (int k = 0; k < 1000; ++k) {
    const Symmetric3 strain = symmetric_part(velocity_gradient(u, g.B));
    const Real mean = lambda * trace(strain);
    const Symmetric3 stress = (2 * mat.shear_modulus) * strain + Symmetric3{mean, mean, mean, 0, 0, 0};
    const HexVectors f = corner_forces(g.volume * stress, g.B, HexModes{}, HexModes{});
    double f2 = 0, u2 = 0;
    for (int a = 0; a < 8; ++a) f2 += dot(f.at[a], f.at[a]), u2 += dot(u.at[a], u.at[a]);
    eigenvalue = std::sqrt(f2 / u2);
    for (int a = 0; a < 8; ++a) u.at[a] = Real(1 / std::sqrt(f2)) * f.at[a];
  }
  return 8 * eigenvalue / double(mat.density * g.volume);
}

TEST(WaveStep, IsThatOfTheFreeHex) {
  for (const double poisson : {0.0, 0.33, 0.49}) {
    Material mat = test::elastic_steel();
    mat.bulk_modulus = Real(double(mat.shear_modulus) * 2 * (1 + poisson) / (3 * (1 - 2 * poisson)));
    const HexInertia scaled{mat.density, longitudinal_wave_speed(mat)};
    const auto share = [&](const HexVectors& x) { // of the bound over the true step
      const Real step = wave_step(mat, scaled, {0, 0}, gradient_moments(mean_gradient(x).B), 0);
      return double(step) / (2 / std::sqrt(free_hex_frequency2(x, mat)));
    };
    HexVectors x = unit_cube();
    EXPECT_NEAR(share(x), 1, 1e3 * round_off) << poisson;
    for (Vector3& p : x.at) p.z *= Real(0.01);
    EXPECT_NEAR(share(x), 1, 1e-4) << poisson;
    std::mt19937 random(4);
    for (int k = 0; k < 100; ++k) {
      const double of = share(distorted_cube(random));
      EXPECT_LT(of, 1 + 1e3 * round_off) << poisson;
      EXPECT_GT(of, 0.85) << poisson;
    }
  }
}

// q = rho ((b2 l rate)^2 + b1 c l |rate|): 1000 ((1.2 * 0.01 * 5e4)^2 + 0.06 * 3000 * 0.01 * 5e4) Pa.
TEST(BulkViscosity, MatchesTheFormulaInCompressionAndIsZeroInExpansion) {
  const HexInertia inertia{1000, 3000};
  const Real b1 = Real(0.06), b2 = Real(1.2), l = Real(0.01);
  EXPECT_NEAR(bulk_viscosity(inertia, b1, b2, l, -5e4) / (1000 * (600. * 600 + 0.06 * 3000 * 500)), 1, 1e-6);
  EXPECT_EQ(bulk_viscosity(inertia, b1, b2, l, 5e4), 0);
}

} // namespace
} // namespace swarf
