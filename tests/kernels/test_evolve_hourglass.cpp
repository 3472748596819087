// The displacement that velocity gradients do not explain, and the force that resists it.
#include "swarf/particles/smoothing_kernel.hpp"
#include "tests/support/particle_block.hpp"
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr Real dt = Real(1e-9);

template <class Function>
void set_vectors(const VectorField& field, const VectorField& position, Function&& function) {
  const auto f = host_copy(field), x = host_copy(position);
  for (std::size_t i = 0; i < f.extent(0); ++i) {
    const Vector3 value = function(int(i), Vector3{x(i, 0), x(i, 1), x(i, 2)});
    f(i, 0) = value.x, f(i, 1) = value.y, f(i, 2) = value.z;
  }
  Kokkos::deep_copy(field, f);
}

ParticleBlock stiff_block(Real disorder) {
  ParticleBlock b = particle_block(12, 12, 12, Real(1e-6), disorder);
  b.method.hourglass_stiffness = 1;
  b.method.viscosity_linear = 0;
  build_lists(b);
  return b;
}

void find_forces(ParticleBlock& b) {
  velocity_gradient(b.particles, b.neighbors, b.method);
  prepare_pair_state(b.particles, b.materials, b.method);
  particle_forces(b.particles, b.neighbors, b.method, dt);
}

// Neighbours along x move against each other.
Vector3 checkerboard(const Vector3& x) {
  const long column = std::lround(double(x.x) / 1e-6 - 0.5);
  return {column % 2 == 0 ? Real(1) : Real(-1), 0, 0};
}

bool inside(const Vector3& x) {
  const auto far = [](Real c) { return c > Real(5e-6) && c < Real(7e-6); };
  return far(x.x) && far(x.y) && far(x.z);
}

} // namespace

TEST(EvolveHourglass, LinearMotionLeavesNoRateAndNoForce) {
  ParticleBlock b = stiff_block(Real(0.1));
  set_vectors(b.particles.velocity, b.particles.position, [](int, const Vector3& x) {
    return Vector3{Real(3e5) * x.x + Real(1e5) * x.y, Real(2e5) * x.z, Real(-4e5) * x.x};
  });
  find_forces(b);
  const auto rate = host_copy(b.particles.hourglass_rate), force = host_copy(b.particles.force);
  const Real round_off = 1000 * Kokkos::Experimental::epsilon_v<Real>;
  for (int i = 0; i < b.particles.count; ++i)
    for (int d = 0; d < 3; ++d) {
      EXPECT_NEAR(rate(i, d), 0, round_off * 5) << i; // velocities reach 3 m/s
      EXPECT_NEAR(force(i, d), 0, round_off * Real(8e10) * Real(1e-12) * Real(5e5) * dt) << i;
    }
}

// sum over the lattice of V |dW/dr| / r x_ij^2 times 2, for neighbours on planes that move against the
// particle's.
Real rate_of_checkerboard() {
  const Real inverse_h = 1 / Real(1.2); // of a unit lattice
  Real sum = 0;
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      for (int z = -3; z <= 3; ++z)
        if (x % 2 != 0)
          sum -= 2 * Real(x * x) * kernel_slope(Real(x * x + y * y + z * z) * inverse_h * inverse_h);
  return sum * std::pow(inverse_h, Real(5));
}

// Planes that move against each other: the gradient sees nothing of it.
TEST(EvolveHourglass, SeesACheckerboardAndOpposesIt) {
  ParticleBlock b = stiff_block(0);
  set_vectors(b.particles.velocity, b.particles.position,
              [](int, const Vector3& x) { return checkerboard(x); });
  find_forces(b);
  set_vectors(b.particles.velocity, b.particles.position, [](int, const Vector3&) {
    return Vector3{0, 0, 0};
  });
  evolve_hourglass(b.particles, b.materials, dt);
  find_forces(b);
  const auto x = host_copy(b.particles.position), rate = host_copy(b.particles.hourglass_displacement),
             force = host_copy(b.particles.force);
  const Real expected = rate_of_checkerboard(), tolerance = sizeof(Real) == 8 ? Real(1e-12) : Real(1e-4);
  int seen = 0;
  for (int i = 0; i < b.particles.count; ++i) {
    const Vector3 at{x(i, 0), x(i, 1), x(i, 2)};
    if (!inside(at)) continue;
    ++seen;
    const Real sign = checkerboard(at).x;
    EXPECT_NEAR(rate(i, 0) / (sign * dt), expected, tolerance) << i;
    EXPECT_NEAR(rate(i, 1) / dt, 0, tolerance) << i;
    EXPECT_LT(force(i, 0) * sign, 0) << i;
  }
  EXPECT_EQ(seen, 8);
}

TEST(EvolveHourglass, AnyDisplacementLeavesMomentumAndItsMoment) {
  ParticleBlock b = stiff_block(Real(0.2));
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> any(-1, 1);
  set_vectors(b.particles.hourglass_displacement, b.particles.position, [&](int, const Vector3&) {
    return Vector3{Real(1e-8) * any(random), Real(1e-8) * any(random), Real(1e-8) * any(random)};
  });
  find_forces(b);
  const auto x = host_copy(b.particles.position), f = host_copy(b.particles.force);
  double sum[3] = {0, 0, 0}, moment[3] = {0, 0, 0}, size = 0;
  for (int i = 0; i < b.particles.count; ++i)
    for (int d = 0; d < 3; ++d) {
      const int e = (d + 1) % 3, g = (d + 2) % 3;
      sum[d] += double(f(i, d)), size += std::abs(double(f(i, d)));
      moment[d] += double(x(i, e)) * double(f(i, g)) - double(x(i, g)) * double(f(i, e));
    }
  EXPECT_GT(size, 0);
  const double round_off = 100 * double(Kokkos::Experimental::epsilon_v<Real>);
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(sum[d] / size, 0, round_off);
    EXPECT_NEAR(moment[d] / (size * 12e-6), 0, round_off);
  }
}

// A turn by 0.3 about z turns d; plastic flow keeps the share that the radial return leaves of a deviator.
TEST(EvolveHourglass, TurnsWithTheMaterialAndReturnsWithTheDeviator) {
  ParticleBlock b = stiff_block(0);
  const Particles& p = b.particles;
  Kokkos::deep_copy(p.hourglass_rate, Real(0));
  set_vectors(p.hourglass_displacement, p.position, [](int, const Vector3&) { return Vector3{1, 0, 0}; });
  const Real step = Real(1e-3), spin = Real(300), flow = Real(1e9), increment = Real(0.01);
  const auto L = host_copy(p.points.velocity_gradient);
  const auto stress = host_copy(p.points.stress);
  const auto rate = host_copy(p.points.plastic_strain_rate);
  for (int i = 0; i < p.count; ++i) {
    L(i, 1) = -spin, L(i, 3) = spin;
    stress(i, 3) = flow / std::sqrt(Real(3)); // simple shear: von Mises stress = flow
    rate(i) = increment / step;
  }
  Kokkos::deep_copy(p.points.velocity_gradient, L), Kokkos::deep_copy(p.points.stress, stress);
  Kokkos::deep_copy(p.points.plastic_strain_rate, rate);
  evolve_hourglass(p, b.materials, step);
  const Real kept = flow / (flow + 3 * elastic_steel().shear_modulus * increment);
  const auto d = host_copy(p.hourglass_displacement);
  const Real angle = 2 * std::atan(spin * step / 2 / (1 + spin * step * spin * step / 4)); // Hughes & Winget
  for (int i = 0; i < p.count; ++i) {
    EXPECT_NEAR(std::hypot(d(i, 0), d(i, 1)), kept, 1e-3 * kept);
    EXPECT_NEAR(std::atan2(d(i, 1), d(i, 0)), angle, 2e-3);
  }
}
