// Verlet's kick and drift against closed forms: free fall, a face that moves, a harmonic oscillator.
#include "support/box_tool.hpp"
#include "swarf/kernels.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

constexpr Real round_off = Kokkos::Experimental::epsilon_v<Real> * 100;

// One point of 2 kg that no constraint holds.
Motion make_motion() {
  Motion m;
  m.count = 1;
  m.position = VectorField("position", 1), m.velocity = VectorField("velocity", 1);
  m.force = VectorField("force", 1), m.mass = ScalarField("mass", 1);
  m.external_work = ScalarField("external_work", 1), m.constraints = View<unsigned*>("constraints", 1);
  Kokkos::deep_copy(m.mass, Real(2));
  return m;
}

ConstraintTable make_table(const Constraint& c) {
  const ConstraintTable table("table", 1);
  Kokkos::deep_copy(table, c);
  return table;
}

// x = v0 t + g t^2 / 2 to round-off whatever the mass factor; the work is that of the weight of the scaled
// mass.
TEST(Integrate, FreeFallIsExact) {
  for (const Real factor : {Real(1), Real(100)}) {
    const Motion m = make_motion();
    const Vector3 v0{3, 0, 1}, g{0, -2, Real(-9.81)};
    set_row(m.velocity, 0, v0);
    const Real dt = Real(0.01), t = 200 * dt;
    for (int step = 0; step < 200; ++step) {
      kick(m, ConstraintTable(), g, factor, dt / 2);
      drift(m, dt);
      kick(m, ConstraintTable(), g, factor, dt / 2);
    }
    const Vector3 x = t * v0 + (t * t / 2) * g;
    EXPECT_LT(norm(get_row(m.position, 0) - x), 100 * round_off * norm(x));
    EXPECT_LT(norm(get_row(m.velocity, 0) - v0 - t * g), 100 * round_off * norm(g) * t);
    EXPECT_NEAR(get_row(m.external_work, 0) / (2 * factor * dot(g, x)), 1, 100 * round_off);
  }
}

// A face that moves with v against the force f on it does the work -f . v t.
TEST(Integrate, MovingFaceKeepsItsVelocityAndDoesWork) {
  const Motion m = make_motion();
  const Vector3 v{1, 2, 3}, f{-50, 20, 7};
  const ConstraintTable table = make_table({true, {1, 0, 0}, v});
  Kokkos::deep_copy(m.constraints, 1u);
  set_row(m.velocity, 0, v), set_row(m.force, 0, f);
  for (int step = 0; step < 100; ++step) kick(m, table, {0, 0, 0}, 1, Real(0.01));
  EXPECT_EQ(norm(get_row(m.velocity, 0) - v), 0);
  EXPECT_NEAR(get_row(m.external_work, 0), -dot(f, v), 100 * round_off * norm(f) * norm(v));
}

// A symmetric face holds the component along its normal and leaves the others to Newton's law, without work.
TEST(Integrate, SymmetricFaceLeavesTheTangentFree) {
  const Motion m = make_motion();
  const ConstraintTable table = make_table({false, {0, 1, 0}, {0, 0, 0}});
  Kokkos::deep_copy(m.constraints, 1u);
  set_row(m.force, 0, {4, 1000, -6});
  kick(m, table, {0, 0, 0}, 1, Real(0.5));
  const Vector3 v = get_row(m.velocity, 0);
  EXPECT_NEAR(v.x, 1, round_off);
  EXPECT_EQ(v.y, 0);
  EXPECT_NEAR(v.z, -1.5, round_off);
  EXPECT_NEAR(get_row(m.external_work, 0), 0, round_off);
}

// From a standstill onto the speed of the face: the work is the kinetic energy.
TEST(Integrate, AJerkOfTheFaceGivesTheKineticEnergy) {
  const Motion m = make_motion();
  const ConstraintTable table = make_table({true, {1, 0, 0}, {3, 0, 4}});
  Kokkos::deep_copy(m.constraints, 1u);
  kick(m, table, {0, 0, 0}, 1, Real(0.1));
  EXPECT_NEAR(get_row(m.external_work, 0), 0.5 * 2 * 25, 50 * round_off);
}

// Largest error of the energy of m x'' = -k x over one period, over the energy; k / m = (2 pi)^2, period 1.
double oscillator_error(int steps) {
  const Motion m = make_motion();
  const double k = 2 * 4 * 9.869604401089358, dt = 1.0 / steps;
  set_row(m.position, 0, {1, 0, 0}), set_row(m.force, 0, {Real(-k), 0, 0});
  double worst = 0;
  for (int step = 0; step < steps; ++step) {
    kick(m, ConstraintTable(), {0, 0, 0}, 1, Real(dt / 2));
    drift(m, Real(dt));
    const double x = double(get_row(m.position, 0).x);
    set_row(m.force, 0, {Real(-k * x), 0, 0});
    kick(m, ConstraintTable(), {0, 0, 0}, 1, Real(dt / 2));
    const double v = double(get_row(m.velocity, 0).x);
    worst = std::max(worst, std::abs(v * v + k / 2 * x * x - k / 2) / (k / 2));
  }
  return worst;
}

// Verlet keeps v^2 / 2 + w^2 x^2 (1 - (w dt / 2)^2) / 2 (Hairer, Lubich & Wanner 2003): from x = 1 the energy
// is off by (w dt / 2)^2 at most, where x = 0, and by the square of the step.
TEST(Integrate, OscillatorEnergyIsOfSecondOrder) {
  const double coarse = oscillator_error(40), fine = oscillator_error(80);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.01);
  const double half = 3.141592653589793 / 80;
  EXPECT_NEAR(fine / (half * half), 1, 0.01);
}

} // namespace
} // namespace swarf::test
