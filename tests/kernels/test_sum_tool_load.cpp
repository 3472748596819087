#include "support/bits.hpp"
#include "support/box_tool.hpp"
#include "support/materials.hpp"
#include "swarf/kernels.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <random>
#include <string>

namespace swarf {
namespace {

// Points around the axis, two of three of them in contact, over several blocks of the sum.
ContactPoints make_loaded_points(int count) {
  ContactPoints p = test::make_contact_points(count, 1);
  const auto x = host_copy(p.position), f = host_copy(p.contact_force);
  std::mt19937 generator(11);
  std::uniform_real_distribution<Real> uniform(-1, 1);
  for (int i = 0; i < count; ++i) {
    store_vector(x, i, {uniform(generator), uniform(generator), uniform(generator)});
    if (i % 3 != 0) store_vector(f, i, {uniform(generator), uniform(generator), uniform(generator) + 1});
  }
  Kokkos::deep_copy(p.position, x);
  Kokkos::deep_copy(p.contact_force, f);
  return p;
}

Tool make_toothed_tool() {
  Tool tool;
  tool.teeth = 3;
  return tool;
}

ToolPose make_pose() {
  ToolPose pose;
  pose.position = {Real(0.2), Real(-0.1), Real(0.3)}, pose.angle = Real(0.7);
  pose.velocity = {Real(0.5), Real(0.25), 0}, pose.angular_velocity = Real(-2);
  return pose;
}

ToolLoad read_total(const ToolLoadSums& sums) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, sums.total)();
}

ToolLoad sum_once(const ContactPoints& p, const ToolPose& pose, Real dt) {
  const ToolLoadSums sums = make_tool_load_sums(p.count);
  sum_tool_load(p, make_toothed_tool(), pose, dt, sums);
  return read_total(sums);
}

// Newton's third law, and the moment about the pose's position, summed here in long double.
TEST(SumToolLoad, IsMinusTheSumOverThePointsToRoundOff) {
  const int n = 5000;
  const ContactPoints p = make_loaded_points(n);
  const ToolPose pose = make_pose();
  const ToolLoad load = sum_once(p, pose, Real(0.125));
  const auto x = host_copy(p.position), f = host_copy(p.contact_force);
  long double force[3] = {}, moment[3] = {}, power = 0;
  for (int i = 0; i < n; ++i) {
    const long double r[3] = {x(i, 0) - (long double)pose.position.x, x(i, 1) - (long double)pose.position.y,
                              x(i, 2) - (long double)pose.position.z};
    for (int d = 0; d < 3; ++d) {
      const int b = (d + 1) % 3, c = (d + 2) % 3;
      force[d] -= f(i, d);
      moment[d] -= r[b] * f(i, c) - r[c] * f(i, b);
    }
    power += (pose.velocity.x - pose.angular_velocity * r[1]) * f(i, 0) +
             (pose.velocity.y + pose.angular_velocity * r[0]) * f(i, 1);
  }
  const double tolerance = n * test::round_off;
  EXPECT_NEAR(load.force.x, double(force[0]), tolerance);
  EXPECT_NEAR(load.force.y, double(force[1]), tolerance);
  EXPECT_NEAR(load.force.z, double(force[2]), tolerance);
  EXPECT_NEAR(load.moment.x, double(moment[0]), tolerance);
  EXPECT_NEAR(load.moment.y, double(moment[1]), tolerance);
  EXPECT_NEAR(load.moment.z, double(moment[2]), tolerance);
  EXPECT_NEAR(load.power, double(power), tolerance);
  EXPECT_NEAR(load.work, double(power) * 0.125, tolerance);
  EXPECT_EQ(load.contacts, Real(n - (n + 2) / 3));
}

// Power = F . V + M . omega of a rigid body, with the opposite sign of the load on the tool.
TEST(SumToolLoad, PowerIsForceTimesFeedPlusTorqueTimesSpin) {
  const ToolPose pose = make_pose();
  const ToolLoad load = sum_once(make_loaded_points(3000), pose, 1);
  EXPECT_NEAR(load.power, -(dot(load.force, pose.velocity) + load.moment.z * pose.angular_velocity),
              1e4 * test::round_off);
}

TEST(SumToolLoad, TeethShareTheForceAndNoneIsLost) {
  const ToolLoad load = sum_once(make_loaded_points(3000), make_pose(), 1);
  Vector3 sum{0, 0, 0};
  for (const Vector3& tooth : load.tooth_force) sum = sum + tooth;
  EXPECT_NEAR(norm(sum - load.force), 0, 1e4 * test::round_off);
  EXPECT_GT(norm(load.tooth_force[2]), 0);
  EXPECT_EQ(norm(load.tooth_force[3]), 0);
}

TEST(SumToolLoad, GivesAForceToTheToothWhoseEdgeIsThere) {
  ContactPoints p = test::make_contact_points(1, 1);
  test::set_row(p.position, 0, {1, Real(0.1), 0});
  test::set_row(p.contact_force, 0, {0, 0, 5});
  ToolPose pose;
  pose.angle = -Kokkos::numbers::pi_v<Real> / 2; // immersion 90 deg: tooth 0 is at +x
  EXPECT_EQ(sum_once(p, pose, 1).tooth_force[0].z, -5);
  pose.angle = pose.angle - 2 * Kokkos::numbers::pi_v<Real> / 3; // one pitch on, tooth 1 is there
  EXPECT_EQ(sum_once(p, pose, 1).tooth_force[1].z, -5);
}

TEST(SumToolLoad, AddsStepsUp) {
  const ContactPoints p = make_loaded_points(2000);
  const ToolLoadSums sums = make_tool_load_sums(p.count);
  for (int step = 0; step < 4; ++step) sum_tool_load(p, make_toothed_tool(), make_pose(), Real(0.5), sums);
  const ToolLoad once = sum_once(p, make_pose(), Real(0.5)), four = read_total(sums);
  EXPECT_EQ(four.force.x, 4 * once.force.x);
  EXPECT_EQ(four.work, 4 * once.work);
  EXPECT_EQ(four.contacts, 4 * once.contacts);
}

// Contact and load of one step printed as bits, by this program run with other numbers of threads.
TEST(SumToolLoad, PrintsItsBits) {
  const int n = 20000;
  ContactPoints p = make_loaded_points(n);
  const auto x = host_copy(p.position);
  for (int i = 0; i < n; ++i) x(i, 2) = Real(0.9) + Real(0.2) * x(i, 2);
  Kokkos::deep_copy(p.position, x);
  Kokkos::deep_copy(p.velocity, Real(0.1));
  const Tool tool = test::make_box_tool({1, 1, 1}, 1);
  ContactLaw law;
  law.friction = Real(0.3), law.stiffness = Real(0.1);
  const MaterialTable materials("materials", 1);
  const ToolLoadSums sums = make_tool_load_sums(n);
  for (int step = 0; step < 3; ++step) {
    tool_contact(p, tool, make_pose(), law, materials, 1, Real(1e-2));
    sum_tool_load(p, tool, make_pose(), Real(1e-2), sums);
  }
  const ToolLoad load = read_total(sums);
  unsigned char bytes[sizeof load];
  std::memcpy(bytes, &load, sizeof load);
  std::printf("bits ");
  for (const unsigned char b : bytes) std::printf("%02x", b);
  std::printf("\n");
}

TEST(SumToolLoad, SameBitsOnOneAndTwoThreads) {
  const std::string one = test::bits_with_threads("SumToolLoad.PrintsItsBits", 1);
  ASSERT_GT(one.size(), 100u);
  EXPECT_EQ(one, test::bits_with_threads("SumToolLoad.PrintsItsBits", 2));
}

TEST(CountPointsInside, CountsThoseDeeperThanTheDepth) {
  ContactPoints p = test::make_contact_points(5, 1);
  const double z[] = {1.1, 0.95, 0.8, 0, 0.7};
  for (int i = 0; i < 5; ++i) test::set_row(p.position, i, {0, 0, Real(z[i])});
  const auto area = host_copy(p.area);
  area(4) = 0; // inside the body: never touches
  Kokkos::deep_copy(p.area, area);
  const Tool tool = test::make_box_tool({1, 1, 1}, 1);
  EXPECT_EQ(count_points_inside(p, tool, {}, 0), 3);
  EXPECT_EQ(count_points_inside(p, tool, {}, Real(0.1)), 2);
  EXPECT_EQ(count_points_inside(p, tool, {}, Real(0.5)), 1);
}

} // namespace
} // namespace swarf
