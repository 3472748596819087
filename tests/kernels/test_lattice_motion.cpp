// Planes of particles that move against each other, in time: pair viscosity and stiffness alone, which the
// stable step has to know. One degree of freedom, driven by the kernels: no stress is updated.
#include "support/materials.hpp"
#include "support/particle_block.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

constexpr Real spacing = Real(1e-6);
const double of_waves = 1.2e-6 / std::sqrt((1e11 + 4.0 / 3 * 8e10) / 7800); // h / c of elastic_steel, s
constexpr int across = 14; // from the middle three supports to the surface: nothing there sees it

class Planes {
 public:
  explicit Planes(const ParticleMethod& method) {
    block = particle_block(across, across, across, spacing);
    const Real ratio = block.method.spacing_ratio;
    block.method = method, block.method.spacing_ratio = ratio;
    build_lists(block);
    const auto x = host_copy(block.particles.position);
    at_rest = VectorField("at_rest", x.extent(0));
    Kokkos::deep_copy(at_rest, x);
    for (int i = 0; i < block.particles.count; ++i) {
      const auto column = [&](int d) { return std::lround(double(x(i, d) / spacing) - 0.5); };
      sign.push_back(column(0) % 2 == 0 ? 1 : -1);
      if (column(0) == across / 2 && column(1) == across / 2 && column(2) == across / 2) middle = i;
    }
    Real zero = 0;
    Kokkos::deep_copy(block.particles.points.velocity_gradient, zero);
    limit = double(
        stable_step(block.particles, block.neighbors, block.materials, {block.method, Real(of_waves)}).dt);
  }

  // Largest speed of 200 steps / the speed at the start.
  double growth(double courant) {
    const Particles& p = block.particles;
    const double mass = double(host_copy(p.points.mass)(middle)), dt = courant * limit;
    const double start = 1e-6 * double(spacing) / dt; // shifts that leave the lattice as it is
    double v = start, shift = 0, most = 0;
    Kokkos::deep_copy(p.hourglass_displacement, Real(0)), Kokkos::deep_copy(p.hourglass_rate, Real(0));
    for (int k = 0; k < 200 && most < 1e6 * start; ++k) {
      shift += dt * v;
      set(p.position, shift, true), set(p.velocity, v, false);
      velocity_gradient(p, block.neighbors, block.method);
      evolve_hourglass(p, block.materials, Real(dt));
      prepare_pair_state(p, block.materials, block.method);
      particle_forces(p, block.neighbors, block.method, Real(dt));
      v += dt * double(host_copy(p.force)(middle, 0)) * sign[std::size_t(middle)] / mass;
      most = std::max(most, std::abs(v));
    }
    return most / start;
  }

  double limit = 0; // of the step, s

 private:
  void set(const VectorField& field, double value, bool moved) const {
    const auto f = host_copy(field), rest = host_copy(at_rest);
    for (int i = 0; i < block.particles.count; ++i)
      for (int d = 0; d < 3; ++d)
        f(i, d) = (moved ? rest(i, d) : Real(0)) + (d == 0 ? Real(value * sign[std::size_t(i)]) : Real(0));
    Kokkos::deep_copy(field, f);
  }

  ParticleBlock block;
  VectorField at_rest;
  std::vector<int> sign;
  int middle = 0;
};

ParticleMethod with(double viscosity_linear, double hourglass_stiffness) {
  ParticleMethod method;
  method.viscosity_linear = Real(viscosity_linear);
  method.hourglass_stiffness = Real(hourglass_stiffness);
  return method;
}

} // namespace

// At the limit as it is given out, and what it leaves: the sums of this lattice are 1.607 of 1.61 and 3.53 of
// 4.05.
TEST(LatticeMotion, IsStableUpToTheStableStep) {
  for (const auto& [viscosity, stiffness, margin] :
       {std::tuple(5.0, 0.0, 1.05), std::tuple(0.0, 10.0, 1.1), std::tuple(2.0, 10.0, 1.1)}) {
    Planes planes(with(viscosity, stiffness));
    EXPECT_LT(planes.limit, 0.75 * of_waves);
    EXPECT_LT(planes.growth(0.999), 3) << viscosity << ", " << stiffness; // swings, the wider the nearer
    EXPECT_GT(planes.growth(margin), 1e3) << viscosity << ", " << stiffness;
  }
}

// A stiffness without any viscosity keeps the energy at every step.
TEST(LatticeMotion, IsNotDrivenByTheStiffness) {
  Planes planes(with(0, 2));
  for (const double courant : {0.1, 0.6}) EXPECT_LT(planes.growth(courant), 1.01) << courant;
}

// Within the margin of h / c nothing changes, to the last bit.
TEST(LatticeMotion, CostsNoStepAtTheShippedValues) {
  const Planes bare(with(0, 0));
  ParticleMethod shipped = with(0.3, 0.3);
  shipped.viscosity_quadratic = 1;
  EXPECT_EQ(Planes(shipped).limit, bare.limit);
  EXPECT_NEAR(bare.limit / of_waves, 1, 10 * round_off);
  EXPECT_EQ(Planes(with(0.3, 1)).limit, bare.limit);
  shipped.viscosity_linear = 10;
  EXPECT_LT(Planes(shipped).limit, 0.3 * bare.limit);
}

} // namespace swarf::test
