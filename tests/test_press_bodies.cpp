#include "support/two_blocks.hpp"
#include "swarf/tool/contact_law.hpp"
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr int n = 3, layers = 2;
constexpr double depth = 1e-3, dt = 1e-6;

struct Pressed {
  Vector3 lower{0, 0, 0}, upper{0, 0, 0};
  double energy = 0, work = 0, heat = 0;
};

Pressed press(TwoBlocks& b, const ContactLaw& law) {
  press_bodies(b.contact, b.mesh, b.particles, {law, b.materials, Real(1), Real(dt)});
  Pressed sum;
  const auto f = host_copy(b.mesh.force);
  const auto energy = host_copy(b.mesh.body_contact_energy), work = host_copy(b.mesh.friction_work),
             heat = host_copy(b.mesh.contact_heat);
  for (int a = 0; a < b.mesh.nodes; ++a) {
    const bool is_lower = a / ((n + 1) * (n + 1)) <= layers;
    (is_lower ? sum.lower : sum.upper) = (is_lower ? sum.lower : sum.upper) + load_vector(f, a);
    sum.energy += double(energy(a)), sum.work += double(work(a)), sum.heat += double(heat(a));
  }
  return sum;
}

ContactLaw law_of(double friction) {
  ContactLaw law;
  law.friction = Real(friction), law.stiffness = 1;
  return law;
}

// N/m of one point: a quarter of the mass behind it, an eighth of its hex's.
constexpr double stiffness = 0.25 * 7800.0 / 8 / (dt * dt);
constexpr double points = 4.0 * n * n; // of each side

} // namespace

TEST(PressBodies, both_sides_press_with_the_springs_of_all_points) {
  TwoBlocks b = two_blocks(n, layers, Real(1), -depth);
  find_body_contact(b.contact, b.mesh, b.particles, b.groups);
  const Pressed p = press(b, law_of(0));
  const double force = 2 * points * stiffness * depth;
  EXPECT_NEAR(p.upper.z / force, 1, 1e-12);
  EXPECT_NEAR((p.upper.z + p.lower.z) / force, 0, 1e-14);
  EXPECT_NEAR(p.upper.x / force, 0, 1e-14);
  EXPECT_NEAR(p.energy / (2 * points * 0.5 * stiffness * depth * depth), 1, 1e-12);
}

TEST(PressBodies, blocks_apart_feel_nothing) {
  TwoBlocks b = two_blocks(n, layers, Real(1), depth);
  find_body_contact(b.contact, b.mesh, b.particles, b.groups);
  EXPECT_GT(b.contact.items, 0);
  const Pressed p = press(b, law_of(0.5));
  EXPECT_EQ(norm(p.upper), 0), EXPECT_EQ(norm(p.lower), 0), EXPECT_EQ(p.energy, 0);
}

// The upper block slides by a tenth of a cell in a step: Coulomb's force against it, and its work as heat.
TEST(PressBodies, sliding_is_braked_by_coulomb_and_heats_both) {
  TwoBlocks b = two_blocks(n, layers, Real(1), -depth);
  const double slip = 0.1, mu = 0.3;
  const auto v = host_copy(b.mesh.velocity); // by node: the blocks overlap
  for (int a = 0; a < b.mesh.nodes; ++a)
    v(a, 0) = a / ((n + 1) * (n + 1)) > layers ? Real(slip / dt) : Real(0);
  Kokkos::deep_copy(b.mesh.velocity, v);
  find_body_contact(b.contact, b.mesh, b.particles, b.groups);
  const Pressed p = press(b, law_of(mu));
  const double normal = 2 * points * stiffness * depth;
  EXPECT_NEAR(p.upper.z / normal, 1, 1e-12);
  EXPECT_NEAR(p.upper.x / (-mu * normal), 1, 1e-12);
  EXPECT_NEAR((p.upper.x + p.lower.x) / normal, 0, 1e-14);
  // (old + held).(trial - held) / 2 k of each point, old = 0: the first step also loads the spring.
  const double held = mu * stiffness * depth,
               work = 2 * points * held * (stiffness * slip - held) / (2 * stiffness);
  EXPECT_NEAR(p.work / work, 1, 1e-12);
  EXPECT_NEAR(p.heat / work, 1, 1e-12);
}

// A side whose hex has gone presses nothing.
TEST(PressBodies, deleted_hexes_neither_press_nor_are_pressed) {
  TwoBlocks b = two_blocks(n, layers, Real(1), -depth);
  find_body_contact(b.contact, b.mesh, b.particles, b.groups);
  const auto active = host_copy(b.mesh.active);
  for (int e = n * n; e < 2 * n * n; ++e) active(e) = 0;
  Kokkos::deep_copy(b.mesh.active, active);
  const Pressed p = press(b, law_of(0.3));
  EXPECT_EQ(norm(p.upper), 0), EXPECT_EQ(norm(p.lower), 0);
}
