// What leaves and what stays, that no list sees it again, that the sums keep what it took
// along, its flight, and what it meets there.
#include "support/box_tool.hpp"
#include "support/materials.hpp"
#include "support/particle_block.hpp"
#include "swarf/region/retire.hpp"
#include <gtest/gtest.h>

namespace swarf {
namespace {

constexpr Real dx = 1e-6;

// A row of 40 x 4 x 4 particles along x, far from where they began; the work is one point at its near end.
struct FlyingRow {
  test::ParticleBlock block = test::particle_block(40, 4, 4, dx);
  Tool tool; // none
  VectorField work{"work", 1};
  VectorField first{"first", block.particles.stored};

  FlyingRow() {
    const auto identity = host_copy(p().identity);
    const auto v = host_copy(p().velocity);
    const auto work_done = host_copy(p().points.internal_work), heat = host_copy(p().points.temperature);
    for (int i = 0; i < p().stored; ++i) {
      identity(i) = i, store_vector(v, i, {Real(2 + i % 7), -2, Real(0.5)});
      work_done(i) = Real(1e-9 * (1 + i)), heat(i) = Real(300 + i);
    }
    Kokkos::deep_copy(p().identity, identity), Kokkos::deep_copy(p().velocity, v);
    Kokkos::deep_copy(p().points.internal_work, work_done), Kokkos::deep_copy(p().points.temperature, heat);
    Kokkos::deep_copy(first, Real(-100 * dx));
    place_work({0, 2 * dx, 2 * dx});
  }
  Particles& p() { return block.particles; }
  void place_work(const Vector3& x) { test::set_row(work, 0, x); }
  Retire settings(Real elapsed = 0) const { return {10 * dx, Real(1.1) * dx, elapsed, first}; }
  void retire(Real elapsed = 0) { retire_particles(p(), work, {tool, {}}, settings(elapsed)); }
  void freeze() { freeze_particles(p(), Tie{}, VectorField("none", 0), freeze_limits()); }
  Freeze freeze_limits() const {
    Freeze s;
    s.distance = 10 * dx, s.ramp = 5 * dx, s.margin = s.reach = block.neighbors.cutoff, s.cell = dx;
    return s;
  }
  std::vector<int> with_bit(unsigned bit) {
    std::vector<int> rows;
    const auto bits = host_copy(p().constraints);
    for (int i = 0; i < p().stored; ++i)
      if (bits(i) & bit) rows.push_back(i);
    return rows;
  }
  // Every ninth particle is where it began.
  void leave_ninth() {
    const auto x = host_copy(p().position), from = host_copy(first);
    for (int i = 0; i < p().stored; i += 9) store_vector(from, i, load_vector(x, i));
    Kokkos::deep_copy(first, from);
  }
};

std::vector<Vector3> positions(const Particles& p) {
  const auto x = host_copy(p.position);
  std::vector<Vector3> all;
  for (int i = 0; i < p.stored; ++i) all.push_back(load_vector(x, i));
  return all;
}

TEST(RetireParticles, only_what_has_moved_and_is_far_from_the_work_leaves) {
  FlyingRow row;
  row.leave_ninth();
  row.p().whole = 600; // the last 40 are tied
  row.retire();
  const auto x = positions(row.p());
  const auto bits = host_copy(row.p().constraints);
  int left = 0;
  for (int i = 0; i < row.p().stored; ++i) {
    const bool far = norm(x[std::size_t(i)] - Vector3{0, 2 * dx, 2 * dx}) > 10 * dx;
    EXPECT_EQ((bits(i) & retired_bit) != 0, far && i % 9 != 0 && i < 600) << i;
    left += (bits(i) & retired_bit) != 0;
  }
  EXPECT_GT(left, 300);
}

// 72 of 640 are where they began; of the others the tool comes near to a layer.
TEST(RetireParticles, the_work_is_what_has_not_moved_and_what_the_tool_comes_near_to) {
  FlyingRow row;
  row.leave_ninth();
  EXPECT_EQ(int(find_work(row.p(), HexMesh{}, {row.tool, {}}, row.settings()).extent(0)), 72);
  row.tool = test::make_box_tool({double(2 * dx), double(10 * dx), double(10 * dx)}, double(dx));
  ToolPose pose;
  pose.position = {-2 * dx, 0, 0}; // its face at x = 0, its reach to 1 dx: 16 particles, of them 2 ninths
  int ninths = 0;
  for (int i = 0; i < row.p().stored; i += 40) ninths += i % 9 == 0;
  EXPECT_EQ(int(find_work(row.p(), HexMesh{}, {row.tool, pose}, row.settings()).extent(0)), 72 + 16 - ninths);
}

TEST(RetireParticles, nothing_leaves_where_there_is_no_work) {
  FlyingRow row;
  row.work = VectorField("none", 0);
  row.retire();
  EXPECT_TRUE(row.with_bit(retired_bit).empty());
}

TEST(RetireParticles, no_list_and_no_active_region_sees_it_again) {
  FlyingRow row;
  Particles& p = row.p();
  row.retire(), row.freeze();
  const auto retired = row.with_bit(retired_bit);
  EXPECT_EQ(p.count + int(retired.size()), p.stored);
  EXPECT_EQ(retired.front(), p.listed);
  test::build_lists(row.block);
  const auto neighbor = host_copy(row.block.neighbors.neighbor);
  const auto start = host_copy(row.block.neighbors.start);
  for (long k = 0; k < start(row.block.neighbors.clusters); ++k) EXPECT_LT(neighbor(k), p.listed);
  const auto region = host_copy(find_active_region(p, HexMesh{}, {row.tool, {}}, row.freeze_limits()));
  for (std::size_t k = 0; k < region.extent(0); ++k) EXPECT_LT(region(k, 0), 12 * dx);
  row.retire(), row.freeze();
  EXPECT_EQ(row.with_bit(retired_bit), retired);
}

TEST(RetireParticles, mass_momentum_and_energy_stay_in_the_sums_bit_by_bit_of_each_particle) {
  FlyingRow row;
  const Real factor = 100, exact = 10 * test::round_off;
  const PointSums before = sum_particles(row.p(), factor);
  row.retire(), row.freeze();
  const PointSums after = sum_particles(row.p(), factor);
  EXPECT_NEAR(after.kinetic / before.kinetic, 1, exact);
  EXPECT_NEAR(after.internal / before.internal, 1, exact);
  EXPECT_NEAR(norm(after.momentum - before.momentum) / norm(before.momentum), 0, exact);
  EXPECT_EQ(after.external, before.external);
  EXPECT_EQ(before.max_temperature, 939);
  EXPECT_LT(after.max_temperature, 939); // extremes are of what is computed
  const auto identity = host_copy(row.p().identity);
  const auto v = host_copy(row.p().velocity);
  const auto heat = host_copy(row.p().points.temperature);
  for (int i = 0; i < row.p().stored; ++i) {
    EXPECT_EQ(v(i, 0), 2 + identity(i) % 7);
    EXPECT_EQ(heat(i), 300 + identity(i));
  }
}

TEST(RetireParticles, it_flies_on_in_a_straight_line) {
  FlyingRow row;
  row.retire();
  const auto from = positions(row.p());
  const auto retired = row.with_bit(retired_bit);
  const Real elapsed = 1e-6;
  row.retire(elapsed);
  const auto to = positions(row.p());
  const auto v = host_copy(row.p().velocity);
  for (const int i : retired) {
    const Vector3 flown = to[std::size_t(i)] - from[std::size_t(i)];
    EXPECT_NEAR(norm(flown - elapsed * load_vector(v, i)), 0, 1e3 * test::round_off * dx) << i;
  }
  EXPECT_EQ(to[0].x, from[0].x);
}

TEST(RetireParticles, what_the_work_or_the_tool_meets_is_marked_for_good) {
  FlyingRow row;
  row.retire();
  EXPECT_TRUE(row.with_bit(met_bit).empty());
  row.place_work({Real(20.5) * dx, Real(1.5) * dx, Real(1.5) * dx}); // where a particle is
  row.retire();
  EXPECT_EQ(row.with_bit(met_bit).size(), 7u); // it, and its neighbours at one spacing
  row.place_work({-5 * dx, 0, 0});
  row.retire();
  EXPECT_EQ(row.with_bit(met_bit).size(), 7u);
  row.tool = test::make_box_tool({double(2 * dx), double(10 * dx), double(10 * dx)}, double(dx));
  ToolPose pose;
  pose.position = {30 * dx, 0, 0};
  retire_particles(row.p(), row.work, {row.tool, pose}, row.settings());
  EXPECT_EQ(row.with_bit(met_bit).size(), 7u + 4 * 16u); // four layers lie within the box
}

} // namespace
} // namespace swarf
