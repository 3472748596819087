#include "support/box_tool.hpp"
#include "support/particle_block.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <tuple>

namespace swarf {
namespace {

constexpr Real dx = 1e-6;

std::vector<Vector3> found(const test::ParticleBlock& b, const Tool& tool, const Freeze& s,
                           const std::vector<Transform>& maps = {}) {
  const auto region =
      host_copy(with_images(find_active_region(b.particles, HexMesh{}, {tool, ToolPose{}}, s), maps));
  std::vector<Vector3> out;
  for (std::size_t k = 0; k < region.extent(0); ++k) out.push_back(load_vector(region, int(k)));
  std::sort(out.begin(), out.end(), [](const Vector3& u, const Vector3& v) {
    return std::tie(u.z, u.y, u.x) < std::tie(v.z, v.y, v.x);
  });
  return out;
}

void set_speed(const test::ParticleBlock& b, int row, Real speed) {
  const auto v = host_copy(b.particles.velocity);
  v(row, 1) = speed;
  Kokkos::deep_copy(b.particles.velocity, v);
}

TEST(FindActiveRegion, is_nowhere_in_a_body_at_rest_without_a_tool) {
  Freeze s;
  s.speed = 1, s.cell = dx;
  EXPECT_TRUE(found(test::particle_block(5, 5, 5, dx), Tool{}, s).empty());
}

TEST(FindActiveRegion, is_where_points_move_faster_than_the_limit) {
  const test::ParticleBlock b = test::particle_block(5, 5, 5, dx);
  Freeze s;
  s.speed = 1, s.cell = dx;
  set_speed(b, 7, Real(1.01)), set_speed(b, 9, Real(-1.01)), set_speed(b, 30, Real(0.99));
  const auto region = found(b, Tool{}, s);
  ASSERT_EQ(region.size(), 2u);
  EXPECT_NEAR(region[0].x, Real(2.5) * dx, Real(1e-3) * dx); // the middle of a cell, where the particle is
  EXPECT_NEAR(region[1].x, Real(4.5) * dx, Real(1e-3) * dx);
}

TEST(FindActiveRegion, keeps_one_point_for_each_cell) {
  const test::ParticleBlock b = test::particle_block(8, 8, 8, dx);
  for (int i = 0; i < 512; ++i) set_speed(b, i, 2);
  Freeze s;
  s.speed = 1, s.cell = Real(4) * dx;
  EXPECT_EQ(found(b, Tool{}, s).size(), 8u);
}

// A face of the box lies at x = 5 um; rows of particles at 4.5, 5.5, 6.5 um.
TEST(FindActiveRegion, is_what_is_nearer_to_the_tool_than_asked) {
  const test::ParticleBlock b = test::particle_block(20, 3, 3, dx);
  const Tool tool = test::make_box_tool({5 * dx, 5 * dx, 5 * dx}, 2 * dx);
  Freeze s;
  s.speed = 1, s.cell = dx;
  for (const auto& [near, columns] : {std::pair{0.4, 5u}, {0.6, 6u}, {1.6, 7u}}) {
    s.near = Real(near) * dx;
    EXPECT_EQ(found(b, tool, s).size(), columns * 9) << near;
  }
}

TEST(FindActiveRegion, has_images_across_periodic_planes) {
  const test::ParticleBlock b = test::particle_block(5, 5, 5, dx);
  set_speed(b, 0, 2);
  Freeze s;
  s.speed = 1, s.cell = dx;
  const auto region = found(b, Tool{}, s, {Transform{identity3(), {0, 0, 5 * dx}}});
  ASSERT_EQ(region.size(), 2u);
  EXPECT_NEAR(region[1].z - region[0].z, 5 * dx, Real(1e-3) * dx);
}

} // namespace
} // namespace swarf
