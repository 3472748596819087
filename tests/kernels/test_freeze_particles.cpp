#include "support/materials.hpp"
#include "support/particle_block.hpp"
#include <gtest/gtest.h>
#include <set>

namespace swarf {
namespace {

constexpr Real dx = 1e-6;

Freeze freeze_for(const test::ParticleBlock& b, Real distance) {
  Freeze s;
  s.distance = distance, s.ramp = distance / 2, s.damping = 1e6;
  s.margin = s.reach = b.neighbors.cutoff;
  return s;
}

VectorField region_at(const Vector3& x) {
  const VectorField region("active_region", 1);
  auto host = Kokkos::create_mirror_view(region);
  store_vector(host, 0, x);
  Kokkos::deep_copy(region, host);
  return region;
}

// A row of 40 x 4 x 4 particles that all move; the active region is at its near end.
test::ParticleBlock moving_row() {
  test::ParticleBlock b = test::particle_block(40, 4, 4, dx);
  const auto identity = host_copy(b.particles.identity);
  const auto v = host_copy(b.particles.velocity);
  for (int i = 0; i < b.particles.count; ++i) identity(i) = i, v(i, 0) = Real(1 + i % 7), v(i, 1) = -2;
  Kokkos::deep_copy(b.particles.identity, identity), Kokkos::deep_copy(b.particles.velocity, v);
  return b;
}

Real energy(const Particles& p, Real mass_factor) {
  const PointSums s = sum_particles(p, mass_factor);
  return s.kinetic - s.external;
}

TEST(FreezeParticles, what_moves_feels_only_what_is_active_and_what_is_active_only_what_is_listed) {
  test::ParticleBlock b = moving_row();
  Particles& p = b.particles;
  const Freeze s = freeze_for(b, 10 * dx);
  freeze_particles(p, Tie{}, region_at({0, 2 * dx, 2 * dx}), s);
  ASSERT_LT(p.count, p.listed);
  ASSERT_LT(p.listed, p.stored);
  EXPECT_EQ(p.stored, 640);
  test::build_lists(b);
  const auto x = host_copy(p.position);
  const auto bits = host_copy(p.constraints);
  int moving = 0, held = 0;
  for (int i = 0; i < p.count; ++i)
    for (int j = 0; j < p.stored; ++j) {
      if (norm(load_vector(x, i) - load_vector(x, j)) >= b.neighbors.cutoff) continue;
      EXPECT_LT(j, p.listed);
      const bool moves = !(bits(i) & held_bit);
      EXPECT_TRUE(!moves || j < p.count) << i;
      (moves ? moving : held) += j == i;
    }
  EXPECT_GT(moving, 100);
  EXPECT_GT(held, 30);
  // The lists hold rows that are listed, and no others.
  const auto neighbor = host_copy(b.neighbors.neighbor);
  const auto start = host_copy(b.neighbors.start);
  std::set<int> seen;
  for (long k = 0; k < start(b.neighbors.clusters); ++k) seen.insert(neighbor(k));
  EXPECT_LT(*seen.rbegin(), p.listed);
  EXPECT_GE(*seen.rbegin(), p.count);
}

// 600 cells: more than the 16 by 16 that one box of boxes holds.
TEST(FreezeParticles, finds_the_nearest_of_many_cells_of_the_active_region) {
  test::ParticleBlock b = moving_row();
  const Freeze s = freeze_for(b, Real(2.2) * dx);
  std::vector<Vector3> cells;
  for (int k = 0; k < 600; ++k) cells.push_back({(k % 24) * dx, -(k * 7 % 13) * dx, (k * 5 % 11) * dx});
  const VectorField region("active_region", cells.size());
  const auto host = Kokkos::create_mirror_view(region);
  for (int k = 0; k < 600; ++k) store_vector(host, k, cells[std::size_t(k)]);
  Kokkos::deep_copy(region, host);
  freeze_particles(b.particles, Tie{}, region, s);
  const auto x = host_copy(b.particles.position);
  const auto bits = host_copy(b.particles.constraints);
  int held = 0;
  for (int i = 0; i < b.particles.stored; ++i) {
    Real nearest = 1;
    for (const Vector3& cell : cells) nearest = std::min(nearest, norm(load_vector(x, i) - cell));
    EXPECT_EQ((bits(i) & held_bit) != 0, nearest > s.distance) << i;
    EXPECT_EQ(i < b.particles.count, nearest <= s.distance + s.margin) << i;
    EXPECT_EQ(i < b.particles.listed, nearest <= s.distance + s.margin + s.reach) << i;
    held += (bits(i) & held_bit) != 0;
  }
  EXPECT_GT(held, 100);
  EXPECT_LT(held, 600);
}

// Beyond distance + reach only what is tied is active, and what is near to what a hex moves.
TEST(FreezeParticles, a_hex_thaws_no_more_than_what_is_near_to_what_it_moves) {
  test::ParticleBlock b = test::particle_block(40, 14, 3, dx);
  Particles& p = b.particles;
  Freeze s = freeze_for(b, 10 * dx);
  const Real hex = 6 * dx, tied_from = 11 * dx;
  s.margin = s.reach + hex;
  std::vector<Vector3> x;
  std::vector<int> tied;
  const auto identity = host_copy(p.identity);
  for (int i = 0; i < p.stored; ++i) x.push_back(load_vector(host_copy(p.position), i));
  for (int i = 0, whole = 0; i < p.stored; ++i) {
    if (x[std::size_t(i)].y > tied_from)
      tied.push_back(i);
    else
      identity(i) = whole++;
  }
  p.whole = p.stored - int(tied.size());
  for (std::size_t k = 0; k < tied.size(); ++k) identity(tied[k]) = p.whole + int(k);
  Kokkos::deep_copy(p.identity, identity);
  Tie tie;
  tie.count = int(tied.size()), tie.row = IndexField("row", tied.size());
  const Vector3 region{0, 2 * dx, dx};
  freeze_particles(p, tie, region_at(region), s);

  const auto expected = [&](const Vector3& at) {
    const Real d = norm(at - region);
    if (at.y > tied_from || d <= s.distance + s.reach) return d <= s.distance + s.margin;
    bool near = false;
    for (const int k : tied)
      near |= norm(x[std::size_t(k)] - at) <= s.reach && norm(x[std::size_t(k)] - region) <= s.distance + hex;
    return near && d <= s.distance + s.margin;
  };
  const auto now = host_copy(p.position);
  int frozen_in_margin = 0, thawed = 0;
  for (int i = 0; i < p.stored; ++i) {
    const Vector3 at = load_vector(now, i);
    EXPECT_EQ(i < p.count + p.tied, expected(at)) << i;
    if (at.y > tied_from || norm(at - region) <= s.distance + s.reach) continue;
    thawed += expected(at), frozen_in_margin += !expected(at) && norm(at - region) <= s.distance + s.margin;
  }
  EXPECT_GT(thawed, 10);
  EXPECT_GT(frozen_in_margin, 50);
}

TEST(FreezeParticles, a_row_that_stays_frozen_is_left_where_it_is) {
  test::ParticleBlock b = moving_row();
  Particles& p = b.particles;
  const Freeze s = freeze_for(b, 10 * dx);
  freeze_particles(p, Tie{}, region_at({39 * dx, 2 * dx, 2 * dx}), s);
  std::vector<int> before;
  for (int i = 0; i < p.stored; ++i) before.push_back(host_copy(p.identity)(i));
  const int far = p.stored - p.listed;
  freeze_particles(p, Tie{}, region_at({37 * dx, 2 * dx, 2 * dx}), s);
  int moved = 0;
  for (int i = 0; i < p.stored; ++i) moved += before[std::size_t(i)] != host_copy(p.identity)(i);
  EXPECT_LT(moved, far / 2);
  EXPECT_GT(moved, 0);
}

TEST(FreezeParticles, the_energy_of_what_stops_leaves_by_external_work) {
  test::ParticleBlock b = moving_row();
  const Real factor = 100, before = energy(b.particles, factor);
  Freeze s = freeze_for(b, 10 * dx);
  s.mass_factor = factor;
  freeze_particles(b.particles, Tie{}, region_at({0, 2 * dx, 2 * dx}), s);
  const PointSums after = sum_particles(b.particles, factor);
  EXPECT_LT(after.kinetic, Real(0.4) * before);
  EXPECT_NEAR(after.kinetic - after.external, before, test::round_off * before);
}

TEST(FreezeParticles, freezing_and_thawing_keep_the_state_of_every_particle) {
  test::ParticleBlock b = moving_row();
  Particles& p = b.particles;
  const auto temperature = host_copy(p.points.temperature);
  for (int i = 0; i < p.count; ++i) temperature(i) = 300 + i;
  Kokkos::deep_copy(p.points.temperature, temperature);
  std::vector<Vector3> x;
  for (int i = 0; i < p.count; ++i) x.push_back(load_vector(host_copy(p.position), i));
  freeze_particles(p, Tie{}, region_at({39 * dx, 2 * dx, 2 * dx}), freeze_for(b, 10 * dx));
  EXPECT_LT(p.count, 400);
  freeze_particles(p, Tie{}, VectorField("none", 0), freeze_for(b, 10 * dx));
  EXPECT_EQ(p.count, 640);
  EXPECT_EQ(p.listed, 640);
  const auto identity = host_copy(p.identity);
  const auto kept = host_copy(p.points.temperature);
  const auto now = host_copy(p.position);
  const auto bits = host_copy(p.constraints);
  for (int i = 0; i < p.count; ++i) {
    EXPECT_EQ(kept(i), 300 + identity(i));
    EXPECT_EQ(norm(load_vector(now, i) - x[std::size_t(identity(i))]), 0);
    EXPECT_EQ(bits(i), 0u);
  }
}

TEST(FreezeParticles, damping_rises_with_the_square_of_the_depth_in_the_ramp) {
  test::ParticleBlock b = moving_row();
  const Freeze s = freeze_for(b, 20 * dx);
  freeze_particles(b.particles, Tie{}, region_at({0, 0, 0}), s);
  const auto x = host_copy(b.particles.position);
  const auto damping = host_copy(b.particles.damping);
  for (int i = 0; i < b.particles.count; ++i) {
    const Real depth = (norm(load_vector(x, i)) - 10 * dx) / (10 * dx);
    EXPECT_NEAR(damping(i), depth > 0 ? 1e6 * depth * depth : 0, 1e6 * 100 * test::round_off);
  }
}

// What a neighbour reads of a particle goes with it, though the lists are made anew before it is frozen.
TEST(FreezeParticles, pair_fields_stay_with_their_particles) {
  test::ParticleBlock b = moving_row();
  Particles& p = b.particles;
  p.pressure_state = View<Real* [4]>("pressure_state", p.count);
  p.heat_state = View<Real* [2]>("heat_state", p.count);
  p.heat_shape = SymmetricField("heat_shape", p.count);
  const auto pressure = host_copy(p.pressure_state);
  const auto heat = host_copy(p.heat_state);
  for (int i = 0; i < p.count; ++i) pressure(i, 0) = 2 * i, heat(i, 0) = 300 + i, heat(i, 1) = 7;
  Kokkos::deep_copy(p.pressure_state, pressure), Kokkos::deep_copy(p.heat_state, heat);
  test::build_lists(b);
  freeze_particles(p, Tie{}, region_at({39 * dx, 2 * dx, 2 * dx}), freeze_for(b, 10 * dx));
  const auto identity = host_copy(p.identity);
  const auto p_after = host_copy(p.pressure_state);
  const auto h_after = host_copy(p.heat_state);
  for (int i = 0; i < p.stored; ++i) {
    EXPECT_EQ(p_after(i, 0), 2 * identity(i));
    EXPECT_EQ(h_after(i, 0), 300 + identity(i));
    EXPECT_EQ(h_after(i, 1), i < p.count ? 7 : 0); // what is frozen insulates
  }
}

} // namespace
} // namespace swarf
