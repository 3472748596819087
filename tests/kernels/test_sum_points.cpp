// Energies, momentum and extremes against sums by hand.
#include "support/hex_block.hpp"
#include "support/particle_block.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

template <class Field, class Value>
void put(const Field& field, const std::vector<Value>& values) {
  const auto f = host_copy(field);
  for (std::size_t i = 0; i < values.size(); ++i) f(i) = values[i];
  Kokkos::deep_copy(field, f);
}

// Particles of 1 and 3 kg, and a tied one: its stress does work, its mass is its hex's.
TEST(SumPoints, OfParticlesAndTiedParticles) {
  Particles p;
  p.count = 2, p.tied = 1, p.stored = p.total = p.points.count = 3;
  allocate(p, 3);
  put<ScalarField, Real>(p.points.mass, {1, 3, 100});
  const auto v = host_copy(p.velocity);
  store_vector(v, 0, {1, 2, 2}), store_vector(v, 1, {0, 0, -4}), store_vector(v, 2, {50, 0, 0});
  Kokkos::deep_copy(p.velocity, v);
  put<ScalarField, Real>(p.points.internal_work, {1, 2, 4});
  put<ScalarField, Real>(p.points.plastic_work, {Real(0.5), 1, 2});
  put<ScalarField, Real>(p.viscous_work, {1, 1, 1});
  put<ScalarField, Real>(p.external_work, {5, 6, 7});
  put<ScalarField, Real>(p.points.temperature, {300, 500, 400});
  put<ScalarField, Real>(p.points.equivalent_plastic_strain, {Real(0.1), Real(0.3), Real(0.2)});
  const PointSums s = sum_particles(p, 2);
  EXPECT_EQ(s.kinetic, 2 * (0.5 * 1 * 9 + 0.5 * 3 * 16));
  EXPECT_EQ(norm(s.momentum - Vector3{2, 4, -20}), 0);
  EXPECT_EQ(s.internal, 7);
  EXPECT_EQ(s.plastic, 3.5);
  EXPECT_EQ(s.viscous, 3);
  EXPECT_EQ(s.external, 11);
  EXPECT_EQ(s.max_speed, 4);
  EXPECT_EQ(s.hottest, 1);
  EXPECT_EQ(s.max_temperature, 500);
  EXPECT_EQ(s.max_plastic_strain, Real(0.3));
}

// A block that moves as one: m v and m v^2 / 2, the mass of its hexes times the factor.
TEST(SumPoints, OfAMovingBlockOfHexes) {
  HexMesh m = make_hex_block({3, 4, 5}, elastic_steel(), 0.1);
  m.friction_work = ScalarField("friction_work", m.nodes);
  m.contact_energy = ScalarField("contact_energy", m.nodes);
  set_rows(m.velocity, {2, 0, -1});
  const PointSums s = sum_hexes(m, 10);
  const double mass = 10 * 7800 * 0.3 * 0.4 * 0.5, exact = sizeof(Real) == 8 ? 1e-13 : 1e-5;
  EXPECT_NEAR(double(s.kinetic) / (0.5 * mass * 5), 1, exact);
  EXPECT_NEAR(double(s.momentum.x) / (2 * mass), 1, exact);
  EXPECT_NEAR(double(s.momentum.z) / -mass, 1, exact);
}

// More points than a block of the sum holds: 1 + 2 + ... + n, exact in integers.
TEST(SumPoints, OfManyBlocks) {
  Particles p;
  p.count = p.stored = p.total = p.points.count = 3001;
  allocate(p, p.count);
  std::vector<Real> number;
  for (int i = 1; i <= p.count; ++i) number.push_back(Real(i % 1000));
  put(p.external_work, number);
  Real sum = 0;
  for (const Real n : number) sum += n;
  EXPECT_EQ(sum_particles(p, 1).external, sum);
  PointSums parts = sum_particles(p, 1, 0, 1500); // active, and frozen
  parts.add(sum_particles(p, 1, 1500, p.stored));
  EXPECT_EQ(parts.external, sum);
}

} // namespace
} // namespace swarf::test
