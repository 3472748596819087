#include "swarf/particles/smoothing_kernel.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace swarf {
namespace {

// 4 pi int W r^2 dr = 1, by Simpson's rule, exact for the piecewise polynomial of degree 5.
TEST(SmoothingKernel, IsNormalised) {
  double integral = 0;
  const int n = 200;
  for (int k = 0; k < n; ++k) {
    const double a = 2.0 * k / n, b = 2.0 * (k + 1) / n, m = 0.5 * (a + b);
    const auto f = [](double q) { return 4 * M_PI * q * q * double(kernel_shape(Real(q))); };
    integral += (b - a) / 6 * (f(a) + 4 * f(m) + f(b));
  }
  EXPECT_NEAR(integral, 1, 1e-6);
}

TEST(SmoothingKernel, SlopeIsTheDerivative) {
  for (double q = 0.05; q < 2; q += 0.1) {
    const double d = 1e-3;
    const double difference =
        (double(kernel_shape(Real(q + d))) - double(kernel_shape(Real(q - d)))) / (2 * d);
    EXPECT_NEAR(q * double(kernel_slope(Real(q * q))), difference, sizeof(Real) == 8 ? 1e-6 : 2e-4) << q;
  }
}

TEST(SmoothingKernel, HasCompactSupportAndAFiniteCentre) {
  EXPECT_EQ(kernel_shape(Real(2)), 0);
  EXPECT_EQ(kernel_slope(Real(6.25)), 0);
  EXPECT_NEAR(double(kernel_shape(Real(0))), 1 / M_PI, 1e-6); // Monaghan & Lattanzio (1985)
  EXPECT_NEAR(double(kernel_slope(Real(0))), -3 / M_PI, 1e-6);
}

// sum_j V W_ij over a lattice of spacing h / 1.2 is 1 to about 1 %.
TEST(SmoothingKernel, SumsToUnityOnALattice) {
  double sum = 0;
  const double s = 1 / 1.2;
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j)
      for (int k = -3; k <= 3; ++k)
        sum += s * s * s * double(kernel_shape(Real(s * std::sqrt(i * i + j * j + k * k))));
  EXPECT_NEAR(sum, 1, 0.01);
}

// A pack gives in each lane what a single number gives.
TEST(SmoothingKernel, PackAndScalarAgree) {
  const Pack q = make_pack([](int lane) { return Real(0.3) * Real(lane); });
  const Pack shape = kernel_shape(q), slope = kernel_slope(q * q);
  for (int lane = 0; lane < pack_width; ++lane) {
    EXPECT_NEAR(lane_of(shape, lane), kernel_shape(Real(0.3) * Real(lane)), 1e-6);
    EXPECT_NEAR(lane_of(slope, lane), kernel_slope(Real(0.09) * Real(lane * lane)), 1e-6);
  }
}

// To a few units in the last place, over more than the range of what pairs divide by.
TEST(Pack, ReciprocalAndInverseSqrtAreExactToRoundOff) {
  const Real round_off = std::numeric_limits<Real>::epsilon();
  for (int exponent = -100; exponent <= 100; ++exponent) {
    const auto x = [&](int lane) { return std::ldexp(1 + Real(lane) / 7, exponent); };
    const Pack one_over = reciprocal(make_pack(x)), root = inverse_sqrt(make_pack(x));
    for (int lane = 0; lane < pack_width; ++lane) {
      EXPECT_NEAR(lane_of(one_over, lane) * x(lane), 1, 2 * round_off) << x(lane);
      EXPECT_NEAR(lane_of(root, lane) * std::sqrt(x(lane)), 1, 4 * round_off) << x(lane);
    }
  }
}

} // namespace
} // namespace swarf
