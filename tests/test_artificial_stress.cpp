#include "swarf/artificial_stress.hpp"
#include <gtest/gtest.h>

namespace swarf {

// The tensile part of Q diag(3, -2, 1) Q^T is Q diag(3, 0, 1) Q^T.
TEST(ArtificialStress, TensilePartIsTheSpectralOne) {
  const Real a = Real(0.7), c = std::cos(a), s = std::sin(a);
  const Tensor3 about_z{c, -s, 0, s, c, 0, 0, 0, 1}, about_x{1, 0, 0, 0, c, -s, 0, s, c};
  const Tensor3 Q = multiply(about_z, about_x);
  const Symmetric3 part = tensile_part(rotate(Q, Symmetric3{3, -2, 1, 0, 0, 0}));
  const Symmetric3 expected = rotate(Q, Symmetric3{3, 0, 1, 0, 0, 0});
  const Symmetric3 error = part + Real(-1) * expected;
  EXPECT_LT(std::sqrt(contract(error, error)), 100 * Kokkos::Experimental::epsilon_v<Real>);
}

TEST(ArtificialStress, CompressionHasNoTensilePart) {
  const Symmetric3 part = tensile_part({-3, -2, -1, Real(0.5), Real(0.2), Real(-0.1)});
  EXPECT_EQ(contract(part, part), 0);
}

} // namespace swarf
