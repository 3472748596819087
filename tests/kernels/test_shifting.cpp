// Shifts of one particle from given sums. Theory: Fick's law for the concentration (Lind et al. 2012), cut
// off by the budget; at a surface nothing goes out, and under a tool nothing goes in or out.
#include "support/materials.hpp"
#include "swarf/particles/shifting.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace swarf::test {
namespace {

constexpr Real spacing = Real(1e-3), h = Real(1.2e-3);
constexpr double tolerance = 100 * double(Kokkos::Experimental::epsilon_v<Real>); // round-off of a few sums
constexpr Symmetric3 inside{1, 1, 1, 0, 0, 0};

constexpr double flux = double(shift_coefficient) * h * h; // m2, displacement over the gradient

void expect_near(const Vector3& is, const Vector3& should_be, double scale) {
  EXPECT_NEAR(is.x / scale, should_be.x / scale, tolerance);
  EXPECT_NEAR(is.y / scale, should_be.y / scale, tolerance);
  EXPECT_NEAR(is.z / scale, should_be.z / scale, tolerance);
}

// What a half space below n leaves of 1: half of n n.
Symmetric3 open_along(const Vector3& n) {
  const Real half = Real(-0.5);
  return inside + half * Symmetric3{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
}

struct Random {
  std::mt19937_64 engine{11};
  Real operator()(Real size) { return std::uniform_real_distribution<Real>(-size, size)(engine); }
  Vector3 vector(Real size) { return {(*this)(size), (*this)(size), (*this)(size)}; }
};

} // namespace

TEST(Shifting, GoesDownTheGradientInsideAndLeansAwayFromPairs) {
  const Vector3 gradient{10, -20, 20}, pairing{5, 5, 0}; // 1/m
  const Shift s = shift_of({gradient, pairing, inside, {0, 0, 0}}, {h, spacing, 1, {0, 0, 0}});
  const double share = double(shift_pairing);
  expect_near(s.displacement,
              {Real(-flux * (10 + 5 * share)), Real(-flux * (-20 + 5 * share)), Real(-flux * 20)}, 1e-5);
  EXPECT_EQ(norm(s.normal), 0);
}

TEST(Shifting, KeepsToTheBudgetAndToATwentiethOfASpacing) {
  const Vector3 gradient{300, 400, 0}; // would go 0.216 spacings
  for (const double allowed : {0.0, 1e-9, 1e-5, 4.9e-5, 6e-5, 1.0}) {
    const Shift s =
        shift_of({gradient, {0, 0, 0}, inside, {0, 0, 0}}, {h, spacing, Real(allowed), {0, 0, 0}});
    const double length = std::min(allowed, 0.05 * double(spacing));
    expect_near(s.displacement, {Real(-0.6 * length), Real(-0.8 * length), 0}, double(spacing));
    EXPECT_LE(norm(s.displacement), length * (1 + tolerance)) << allowed;
  }
}

// Whatever the neighbours are like: with the sums of a surface nothing goes out, and no shift is too long.
TEST(Shifting, NeverMovesASurfaceParticleOut) {
  Random random;
  int inward = 0, along = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vector3 gradient = random.vector(Real(0.6) / spacing);
    const Vector3 out = (Real(-1) / norm(gradient)) * gradient;
    const ShiftSums sums{gradient, random.vector(Real(1) / spacing), open_along(out), random.vector(1)};
    const Shift s = shift_of(sums, {h, spacing, 1, {0, 0, 0}});
    expect_near(s.normal, out, 1);
    const double outward = double(dot(s.displacement, out)) / spacing;
    EXPECT_LE(outward, tolerance);
    EXPECT_LE(norm(s.displacement), double(largest_shift) * spacing * (1 + tolerance));
    inward += outward<-1e-6, along += norm(s.displacement - dot(s.displacement, out) * out)> 1e-6 * spacing;
  }
  EXPECT_GT(inward, 100);
  EXPECT_EQ(along, 2000); // the pairing term moves it along the surface
}

// In the outer row of a lattice the gradient is 0.48 / spacing, above 0.29: it stays. With 0.2 / spacing it
// has come off, and goes back by D h^2 (0.29 - 0.2) / spacing.
TEST(Shifting, DrawsARowBackThatHasComeOff) {
  const auto outward = [](Real gradient) {
    const ShiftSums sums{{0, 0, -gradient / spacing}, {0, 0, 0}, open_along({0, 0, 1}), {0, 0, 0}};
    const Shift s = shift_of(sums, {h, spacing, 1, {0, 0, 0}});
    EXPECT_EQ(s.displacement.x, 0);
    EXPECT_EQ(s.displacement.y, 0);
    return double(s.displacement.z);
  };
  EXPECT_NEAR(outward(Real(0.48)) / spacing, 0, tolerance);
  EXPECT_NEAR(outward(Real(0.29)) / spacing, 0, tolerance);
  EXPECT_NEAR(outward(Real(0.2)) / spacing, -flux * (0.29 - 0.2) / spacing / spacing, tolerance);
}

// What lies below a surface does not push it out: of d the part along the normals it sees goes, where that is
// outward.
TEST(Shifting, DoesNotMoveOutBelowASurface) {
  const Vector3 normals{0, Real(0.1), 0}, far{0, Real(0.02), 0}, none{0, 0, 0};
  const auto shift = [&](const Vector3& gradient, const Vector3& surface) {
    return shift_of({gradient, none, inside, surface}, {h, spacing, 1, none}).displacement;
  };
  const Vector3 out{10, -20, 20}, in{10, 20, 20};
  expect_near(shift(out, normals), {Real(-10 * flux), 0, Real(-20 * flux)}, 1e-5);
  expect_near(shift(in, normals), {Real(-10 * flux), Real(-20 * flux), Real(-20 * flux)}, 1e-5);
  expect_near(shift(out, far), {Real(-10 * flux), Real(20 * flux), Real(-20 * flux)}, 1e-5); // inside
}

TEST(Shifting, UnderTheToolMovesAlongItOnly) {
  Random random;
  for (int k = 0; k < 500; ++k) {
    const Vector3 pressed = random.vector(3);
    const ShiftSums sums{random.vector(Real(0.14) / spacing), random.vector(Real(1) / spacing), inside,
                         random.vector(1)};
    const ShiftPoint free{h, spacing, 1, {0, 0, 0}}, held{h, spacing, 1, pressed};
    const Shift s = shift_of(sums, held);
    const Vector3 n = (Real(-1) / norm(pressed)) * pressed;
    expect_near(s.normal, n, 1);
    EXPECT_NEAR(dot(s.displacement, n) / spacing, 0, tolerance);
    EXPECT_GT(norm(s.displacement), 1e-6 * spacing);
    EXPECT_EQ(norm(shift_of(sums, free).normal), 0);
  }
}

// Where a free surface meets the tool: the gradient along the tool is that of an outer row.
TEST(Shifting, DoesNotLeaveASurfaceAlongTheTool) {
  const Vector3 n{0, 0, 1}, pressed{0, 0, -3};
  for (const Real steep : {Real(0.2), Real(0.47), Real(1)})
    for (const Real lean : {Real(-1), Real(0), Real(1)}) { // of the pairing, along and against
      const ShiftSums sums{{-steep / spacing, 0, Real(-0.5) / spacing},
                           {lean * 20 / spacing, Real(1) / spacing, 0},
                           inside,
                           {0, 0, 0}};
      const Vector3 d = shift_of(sums, {h, spacing, 1, pressed}).displacement;
      EXPECT_LE(d.x, tolerance * spacing); // outwards is +x
      EXPECT_NEAR(dot(d, n), 0, tolerance * spacing);
      EXPECT_LT(d.y, 0);
      if (lean > 0) {
        EXPECT_LT(d.x, 0);
      }
    }
}

// 0 where nothing tells where to go: no neighbours at all.
TEST(Shifting, StaysAlone) {
  const Shift s = shift_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0, 0, 0, 0}, {0, 0, 0}}, {h, spacing, 1, {0, 0, 0}});
  EXPECT_EQ(norm(s.displacement), 0);
  EXPECT_EQ(norm(s.normal), 0);
}

// Half of stress : strain, with Hooke's law in E and nu: 100 GPa and 60 GPa are E = 150 GPa and nu = 0.25.
TEST(Shifting, ElasticEnergyIsThatOfHookesLaw) {
  const Material mat = elastic_solid(Real(100e9), Real(60e9), 7800);
  const double x = 3e8, y = -1e8, z = 2e8, xy = 1e8, yz = 2e8, zx = -3e8, E = 150e9, nu = 0.25;
  const double density = (x * x + y * y + z * z - 2 * nu * (x * y + y * z + z * x)) / (2 * E) +
                         (1 + nu) / E * (xy * xy + yz * yz + zx * zx); // J/m3
  const Real volume = Real(2e-9);
  const Symmetric3 stress{Real(x), Real(y), Real(z), Real(xy), Real(yz), Real(zx)};
  EXPECT_NEAR(elastic_energy(mat, stress, volume) / (2e-9 * density), 1, tolerance);
  EXPECT_EQ(elastic_energy(mat, {0, 0, 0, 0, 0, 0}, volume), 0);
}

} // namespace swarf::test
