// Sorting moves whole particles: every column of every field, whatever its width, goes where its row goes.
#include "support/particle_block.hpp"
#include <array>
#include <gtest/gtest.h>
#include <set>

namespace swarf::test {
namespace {

// By particle and column, exact in every type of field.
template <class Visit>
void for_each_entry(Particles& p, const Visit& visit) {
  for_each_field(p, [&](const std::string& name, auto& field, auto facts) {
    using Field = std::decay_t<decltype(field)>;
    if (facts.life == Life::derived || name == "position" || field.extent(0) == 0) return;
    const auto host = host_copy(field);
    for (int i = 0; i < p.count; ++i)
      if constexpr (Field::rank == 1)
        visit(name, i, 0, host(i));
      else
        for (int c = 0; c < int(field.extent(1)); ++c) visit(name, i, c, host(i, c));
    Kokkos::deep_copy(field, host);
  });
}

TEST(SortParticles, MovesEveryColumnOfEveryFieldWithItsParticle) {
  ParticleBlock b = particle_block(9, 8, 7, Real(1e-3), Real(0.2));
  Particles& p = b.particles;
  const auto before = host_copy(p.position);
  for_each_entry(p, [&](const std::string& name, int i, int column, auto& value) {
    value = std::decay_t<decltype(value)>(name == "identity" ? i : 1000 * column + i);
  });
  const auto start = Kokkos::create_mirror(p.position);
  Kokkos::deep_copy(start, p.position);
  sort_particles(p, b.lattice);
  const auto identity = host_copy(p.identity);
  const auto after = host_copy(p.position);
  int moved = 0;
  for (int i = 0; i < p.count; ++i) {
    moved += identity(i) != i;
    for (int c = 0; c < 3; ++c) EXPECT_EQ(after(i, c), start(identity(i), c));
  }
  EXPECT_GT(moved, p.count / 2);
  for_each_entry(p, [&](const std::string& name, int i, int column, auto& value) {
    if (name == "identity") return;
    EXPECT_EQ(value, std::decay_t<decltype(value)>(1000 * column + identity(i))) << name;
  });
}

// So that the rows of a pack have as few neighbours in common as can be, wherever the lattice lies.
TEST(SortParticles, PutsTheCornersOfACubeOfTheLatticeOneAfterTheOther) {
  const Real spacing = Real(1e-3);
  for (const Real moved : {Real(0), Real(0.3), Real(0.5), Real(1.2)}) {
    ParticleBlock b = particle_block(12, 10, 8, spacing, Real(0.1));
    Particles& p = b.particles;
    const auto x = host_copy(p.position);
    for (int i = 0; i < p.count; ++i)
      for (int c = 0; c < 3; ++c) x(i, c) -= moved * spacing;
    Kokkos::deep_copy(p.position, x);
    for (int c = 0; c < 3; ++c) (&b.lattice.origin.x)[c] = -moved * spacing;
    sort_particles(p, b.lattice);
    const auto sorted = host_copy(p.position);
    for (int first = 0; first < p.count; first += 8)
      for (int c = 0; c < 3; ++c) {
        Real low = sorted(first, c), high = low;
        for (int i = first; i < first + 8; ++i)
          low = std::min(low, sorted(i, c)), high = std::max(high, sorted(i, c));
        EXPECT_LT(high - low, Real(1.21) * spacing); // 1 and twice the disorder
      }
  }
}

// Cubes are of cells 2 i and 2 i + 1 of the lattice, also where the least cell with a particle is a 2 i + 1.
TEST(SortParticles, KeepsCubesWholeThatBeginBelowTheParticles) {
  const Real spacing = Real(1e-3);
  for (const int below : {1, 2, 3}) {
    ParticleBlock b = particle_block(12, 10, 8, spacing, Real(0.1));
    const Real origin = -below * spacing;
    b.lattice.origin = {origin, origin, origin};
    sort_particles(b.particles, b.lattice);
    const auto sorted = host_copy(b.particles.position);
    std::set<std::array<int, 3>> cubes;
    std::array<int, 3> last{-1, -1, -1};
    int changes = 0;
    for (int i = 0; i < b.particles.count; ++i) {
      std::array<int, 3> cube;
      for (int c = 0; c < 3; ++c) cube[c] = int((sorted(i, c) - origin) / (2 * spacing));
      changes += cube != last, last = cube;
      cubes.insert(cube);
    }
    EXPECT_EQ(changes, int(cubes.size())) << below;
  }
}

} // namespace
} // namespace swarf::test
