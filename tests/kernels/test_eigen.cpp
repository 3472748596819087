// Eigenvalues of symmetric tensors, against tensors made of known ones.
#include "swarf/core/eigen.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace swarf::test {
namespace {

constexpr double round_off = 1e3 * double(Kokkos::Experimental::epsilon_v<Real>);

// A turn about three axes in a row.
Tensor3 turn(double a, double b, double c) {
  const auto about = [](double angle) { return std::pair(Real(std::cos(angle)), Real(std::sin(angle))); };
  const auto [ca, sa] = about(a);
  const auto [cb, sb] = about(b);
  const auto [cc, sc] = about(c);
  return multiply(multiply(Tensor3{ca, -sa, 0, sa, ca, 0, 0, 0, 1}, Tensor3{1, 0, 0, 0, cb, -sb, 0, sb, cb}),
                  Tensor3{cc, 0, sc, 0, 1, 0, -sc, 0, cc});
}

TEST(Eigen, FindsValuesAndVectorsOfTurnedTensors) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-3, 3);
  for (const auto& known :
       {std::array{3.0, 2.0, 1.0}, std::array{1.0, 1.0, 1e-3}, std::array{2.0, -1.0, -1.0},
        std::array{0.5, 0.0, 0.0}, std::array{1.0, 1.0, 1.0}})
    for (int k = 0; k < 20; ++k) {
      const Tensor3 Q = turn(u(random), u(random), u(random));
      const Symmetric3 A = rotate(Q, {Real(known[0]), Real(known[1]), Real(known[2]), 0, 0, 0});
      const Eigen3 e = eigen_decomposition(A);
      std::array<double, 3> found{double(e.value[0]), double(e.value[1]), double(e.value[2])};
      std::sort(found.rbegin(), found.rend());
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(found[std::size_t(c)], known[std::size_t(c)], round_off);
        const Vector3 off = multiply(A, e.vector[c]) - e.value[c] * e.vector[c];
        EXPECT_LT(double(norm(off)), round_off);
        EXPECT_NEAR(double(norm(e.vector[c])), 1, round_off);
      }
      EXPECT_NEAR(double(largest_eigenvalue(A)), known[0], 1e-6); // a double root costs half of the digits
    }
}

} // namespace
} // namespace swarf::test
