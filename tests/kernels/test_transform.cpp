#include "swarf/core/transform.hpp"
#include <gtest/gtest.h>

namespace swarf {
namespace {

constexpr Real tolerance = Real(1e-6);

Vector3 around_z(const Vector3& x) { return {-x.y, x.x, x.z}; } // a quarter of a turn

const Transform turned{{0, -1, 0, 1, 0, 0, 0, 0, 1}, {1, 2, 3}};
const Transform mirrored{{-1, 0, 0, 0, 1, 0, 0, 0, 1}, {4, 0, 0}};

void expect_equal(const Vector3& a, const Vector3& b) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Transform, turns_and_then_shifts) {
  const Vector3 x{5, 7, 9};
  expect_equal(apply(turned, x), around_z(x) + Vector3{1, 2, 3});
  expect_equal(apply(mirrored, x), {-1, 7, 9});
}

TEST(Transform, has_an_inverse_that_leads_back) {
  const Vector3 x{5, 7, 9};
  for (const Transform& map : {turned, mirrored}) {
    expect_equal(apply(inverse(map), apply(map, x)), x);
    expect_equal(apply(map, apply(inverse(map), x)), x);
  }
}

TEST(Transform, composes_from_the_right) {
  const Vector3 x{5, 7, 9};
  expect_equal(apply(compose(turned, mirrored), x), apply(turned, apply(mirrored, x)));
  expect_equal(apply(compose(mirrored, turned), x), apply(mirrored, apply(turned, x)));
}

} // namespace
} // namespace swarf
