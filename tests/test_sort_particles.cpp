// Sorting moves whole particles: every column of every field, whatever its width, goes where its row goes.
#include "support/particle_block.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

// By particle and column, exact in every type of field.
template <class Visit>
void for_each_entry(Particles& p, const Visit& visit) {
  p.for_each_field([&](const std::string& name, auto& field) {
    using Field = std::decay_t<decltype(field)>;
    if (name == "position" || field.extent(0) == 0) return;
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
  sort_particles(p, b.neighbors.cutoff / 16);
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

} // namespace
} // namespace swarf::test
