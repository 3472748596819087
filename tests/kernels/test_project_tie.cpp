// The kernels of the tie on a disordered block of hexes with tied particles at random places in it.
// Theory: shape functions of the trilinear hex sum to 1 and reproduce x, so constant and linear fields are
// exact.
#include "support/materials.hpp"
#include "support/tied_block.hpp"
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;

namespace {

// What the tied particles give and what the nodes take: force, moment about the origin, power, and the size
// of the terms of each sum, which bounds its round-off.
struct Balance {
  Vector3 force{0, 0, 0}, moment{0, 0, 0};
  double power = 0, force_size = 0, moment_size = 0, power_size = 0;
};

Balance sum_balance(const VectorField& position, const VectorField& velocity, const VectorField& force,
                    int begin, int end) {
  const auto x = host_copy(position), v = host_copy(velocity), f = host_copy(force);
  Balance sum;
  for (int i = begin; i < end; ++i) {
    const Vector3 x_i = load_vector(x, i), v_i = load_vector(v, i), f_i = load_vector(f, i);
    sum.force = sum.force + f_i, sum.moment = sum.moment + cross(x_i, f_i),
    sum.power += double(dot(v_i, f_i));
    sum.force_size += double(norm(f_i)), sum.moment_size += double(norm(x_i) * norm(f_i));
    sum.power_size += double(norm(v_i) * norm(f_i));
  }
  return sum;
}

void set_random(const VectorField& field, int seed) {
  const auto f = host_copy(field);
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < f.extent(0); ++i)
    for (int d = 0; d < 3; ++d) f(i, d) = Real(random_unit(random));
  Kokkos::deep_copy(field, f);
}

} // namespace

TEST(ProjectTie, LinearVelocityPasses) {
  const TiedBlock b = make_tied_block({3, 3, 3}, 500);
  const double G[3][3] = {{10, -3, 7}, {2, 5, -8}, {-4, 6, 9}}, v0[3] = {1, -2, 0.5}; // m/s per 10 um
  const auto linear = [&](const Point& x) {
    Point v{};
    for (int i = 0; i < 3; ++i) v[i] = v0[i] + (G[i][0] * x[0] + G[i][1] * x[1] + G[i][2] * x[2]) * 1e5;
    return v;
  };
  set_nodal(b.hexes.velocity, b.hexes.position, linear);
  project_tie(b.tie, b.particles, b.hexes);
  const auto x = host_copy(b.particles.position), v = host_copy(b.particles.velocity);
  for (int i = 5; i < 505; ++i) {
    const Point exact = linear({double(x(i, 0)), double(x(i, 1)), double(x(i, 2))});
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(double(v(i, d)), exact[d], 60 * round_off);
  }
  for (int i = 0; i < 5; ++i) EXPECT_EQ(v(i, 0), 0); // rows of particles are not touched
}

TEST(ProjectTie, ConstantVelocityPasses) {
  const TiedBlock b = make_tied_block({3, 3, 3}, 100);
  set_nodal(b.hexes.velocity, b.hexes.position, [](const Point&) { return Point{3, -7, 11}; });
  project_tie(b.tie, b.particles, b.hexes);
  const auto v = host_copy(b.particles.velocity);
  for (int i = 5; i < 105; ++i) {
    EXPECT_NEAR(double(v(i, 0)), 3, 3 * round_off);
    EXPECT_NEAR(double(v(i, 1)), -7, 7 * round_off);
    EXPECT_NEAR(double(v(i, 2)), 11, 11 * round_off);
  }
}

// sum_a N_a = 1 keeps the force, sum_a N_a x_a = x_k the moment, v_k = sum_a N_a v_a the power on any motion
// of the nodes: each to round-off, with random forces (N) on all rows and random node velocities (m/s).
TEST(GatherTieForces, ForceMomentAndPowerAreConserved) {
  const TiedBlock b = make_tied_block({3, 3, 3}, 500);
  set_random(b.hexes.velocity, 10);
  project_tie(b.tie, b.particles, b.hexes);
  set_random(b.particles.force, 11); // also of the rows that are not tied: they must not count
  Kokkos::deep_copy(b.hexes.force, Real(0));
  gather_tie_forces(b.tie, b.particles, b.hexes);
  const Balance given = sum_balance(b.particles.position, b.particles.velocity, b.particles.force, 5, 505);
  const Balance taken = sum_balance(b.hexes.position, b.hexes.velocity, b.hexes.force, 0, b.hexes.nodes);
  EXPECT_LT(double(norm(taken.force - given.force)), round_off * given.force_size);
  EXPECT_LT(double(norm(taken.moment - given.moment)), round_off * given.moment_size);
  EXPECT_NEAR(taken.power, given.power, round_off * given.power_size);
}

TEST(GatherTieForces, HeldNodesGetNone) {
  const TiedBlock b = make_tied_block({3, 3, 3}, 500);
  const auto bits = host_copy(b.hexes.constraints);
  for (int a = 0; a < b.hexes.nodes; a += 2) bits(a) |= held_bit;
  Kokkos::deep_copy(b.hexes.constraints, bits);
  set_random(b.particles.force, 13);
  gather_tie_forces(b.tie, b.particles, b.hexes);
  const auto force = host_copy(b.hexes.force);
  for (int a = 0; a < b.hexes.nodes; ++a) EXPECT_EQ(norm(load_vector(force, a)) == 0, a % 2 == 0) << a;
}

// The force of the hexes is there before: the tie adds to it.
TEST(GatherTieForces, AddsToTheForceOfTheNodes) {
  const TiedBlock b = make_tied_block({3, 3, 3}, 10);
  set_random(b.hexes.force, 12);
  const auto before = host_copy(b.hexes.force);
  Kokkos::deep_copy(b.particles.force, Real(0));
  gather_tie_forces(b.tie, b.particles, b.hexes);
  const auto after = host_copy(b.hexes.force);
  for (int a = 0; a < b.hexes.nodes; ++a)
    for (int d = 0; d < 3; ++d) EXPECT_EQ(after(a, d), before(a, d));
}
