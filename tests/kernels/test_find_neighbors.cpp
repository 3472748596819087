#include "support/particle_block.hpp"
#include <gtest/gtest.h>
#include <set>

namespace swarf::test {
namespace {

using Pairs = std::set<std::pair<int, int>>;

// Pairs within the cutoff that the lists give, by identity; lists may hold more.
Pairs listed_pairs(const ParticleBlock& b, bool& repeated) {
  const auto x = host_copy(b.particles.position);
  const auto first = host_copy(b.neighbors.first), size = host_copy(b.neighbors.size);
  const auto start = host_copy(b.neighbors.start);
  const auto neighbor = host_copy(b.neighbors.neighbor);
  Pairs pairs;
  for (int c = 0; c < b.neighbors.clusters; ++c)
    for (int i = first(c); i < first(c) + size(c); ++i)
      for (long k = start(c); k < start(c + 1); ++k) {
        const int j = neighbor(k);
        const Vector3 d = load_vector(x, i) - load_vector(x, j);
        if (dot(d, d) < b.neighbors.cutoff * b.neighbors.cutoff && !pairs.insert({i, j}).second)
          repeated = true;
      }
  return pairs;
}

// Brute force, against a sample of rows when there are many.
void expect_same_as_brute_force(const ParticleBlock& b, int every) {
  bool repeated = false;
  const Pairs listed = listed_pairs(b, repeated);
  EXPECT_FALSE(repeated);
  const auto x = host_copy(b.particles.position);
  std::size_t missing = 0, found = 0, listed_here = 0;
  for (const auto& [i, j] : listed) listed_here += i % every == 0;
  for (int i = 0; i < b.particles.count; i += every)
    for (int j = 0; j < b.particles.total; ++j) {
      const Vector3 d = load_vector(x, i) - load_vector(x, j);
      if (dot(d, d) >= b.neighbors.cutoff * b.neighbors.cutoff) continue;
      ++found;
      missing += !listed.count({i, j});
    }
  EXPECT_EQ(missing, 0u);
  EXPECT_EQ(found, listed_here);
}

ParticleBlock scattered(int count, Real clustering) {
  ParticleBlock b = particle_block(count, 1, 1, Real(1e-6));
  const auto x = host_copy(b.particles.position);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> u(0, 1);
  for (int i = 0; i < count; ++i)
    for (int c = 0; c < 3; ++c) x(i, c) = Real(4.6e-5) * std::pow(u(random), clustering);
  Kokkos::deep_copy(b.particles.position, x);
  b.neighbors.cutoff = Real(2.6e-6);
  return b;
}

TEST(FindNeighbors, MatchesBruteForceOnRandomPoints) {
  ParticleBlock b = scattered(100000, 1);
  build_lists(b);
  expect_same_as_brute_force(b, 97);
}

TEST(FindNeighbors, MatchesBruteForceOnClusteredPoints) {
  ParticleBlock b = scattered(20000, 2);
  build_lists(b);
  expect_same_as_brute_force(b, 97);
}

TEST(FindNeighbors, MatchesBruteForceFarFromTheOrigin) {
  ParticleBlock b = particle_block(6, 6, 6, Real(1e-9)); // a nanometre apart: no absolute cut-off
  build_lists(b);
  expect_same_as_brute_force(b, 1);
}

// Two pairs of periodic planes: each particle of a lattice sees the same number of neighbours.
TEST(FindNeighbors, PeriodicLatticeHasNoSurface) {
  const Real s = Real(1e-6);
  ParticleBlock b = particle_block(6, 6, 6, s);
  GhostPlanes planes;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      Vector3 n{Real(axis == 0), Real(axis == 1), Real(axis == 2)};
      if (side) n = Real(-1) * n;
      planes.push_back({n, side ? -6 * s : Real(0), {identity3(), (6 * s) * n}, true, true});
    }
  build_lists(b, planes);
  bool repeated = false;
  const Pairs pairs = listed_pairs(b, repeated);
  EXPECT_FALSE(repeated);
  std::vector<int> neighbors(b.particles.count);
  for (const auto& [i, j] : pairs) ++neighbors[i];
  // lattice points within 2.64 spacings of one: 81 (itself, 6, 12, 8, 6, 24, 24)
  for (const int found : neighbors) EXPECT_EQ(found, 81);
}

TEST(FindNeighbors, SortingSortedParticlesChangesNothing) {
  ParticleBlock b = scattered(5000, 1);
  build_lists(b);
  const auto before = host_copy(b.particles.position);
  const Kokkos::View<int*, Kokkos::HostSpace> list("list", b.neighbors.neighbor.extent(0));
  Kokkos::deep_copy(list, b.neighbors.neighbor);
  build_lists(b);
  const auto after = host_copy(b.particles.position);
  for (int i = 0; i < b.particles.count; ++i)
    for (int c = 0; c < 3; ++c) EXPECT_EQ(before(i, c), after(i, c));
  const auto again = host_copy(b.neighbors.neighbor);
  const auto start = host_copy(b.neighbors.start);
  for (std::size_t k = 0; k < std::size_t(start(b.neighbors.clusters)); ++k) ASSERT_EQ(list(k), again(k));
}

} // namespace
} // namespace swarf::test
