#include "support/hex_step.hpp"
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
  EXPECT_EQ(norm(p.upper), 0);
  EXPECT_EQ(norm(p.lower), 0);
  EXPECT_EQ(p.energy, 0);
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
  EXPECT_EQ(norm(p.upper), 0);
  EXPECT_EQ(norm(p.lower), 0);
}

namespace {

// Both blocks in motion, the forces of their hexes and of their contact.
struct Moving {
  TwoBlocks blocks;
  ContactLaw law;
  HexMethod method;
  Surroundings around;
  double step; // s

  Moving(int across, int high, const Vector3& speed, double friction)
      : blocks(two_blocks(across, high, Real(1), 1e-3)), law(law_of(friction)) {
    method.hourglass_coefficient = Real(0.1);
    const int below = (across + 1) * (across + 1) * (high + 1);
    const auto v = host_copy(blocks.mesh.velocity);
    for (int a = below; a < blocks.mesh.nodes; ++a) store_vector(v, a, speed);
    Kokkos::deep_copy(blocks.mesh.velocity, v);
    step = 0.3 / wave_speed();
    law.reference_step = Real(step);
  }
  static double wave_speed() { return double(longitudinal_wave_speed(steel_of_blocks())); }

  void forces() {
    HexMesh& m = blocks.mesh;
    const Status status = make_status();
    hex_velocity_gradient(m, status);
    update_stress(m.points, blocks.materials, Real(step), status, m.active);
    hex_forces(m, blocks.materials, method, Real(step));
    gather_corner_forces(m);
    press_bodies(blocks.contact, m, blocks.particles, {law, blocks.materials, Real(1), Real(step)});
    EXPECT_EQ(read_status(status), no_fault);
  }
  void advance(double time) {
    const Motion motion = motion_of(blocks.mesh);
    find_body_contact(blocks.contact, blocks.mesh, blocks.particles, blocks.groups);
    for (int k = 0; k < int(time / step); ++k) {
      kick(motion, around.constraints, around.gravity, Real(1), Real(0.5 * step));
      drift(motion, Real(step));
      if (way_since(blocks.contact, blocks.mesh, blocks.particles) > Real(0.9) * blocks.contact.room)
        find_body_contact(blocks.contact, blocks.mesh, blocks.particles, blocks.groups);
      forces();
      kick(motion, around.constraints, around.gravity, Real(1), Real(0.5 * step));
    }
  }
  Vector3 momentum(bool upper) const {
    const auto m = host_copy(blocks.mesh.mass);
    const auto v = host_copy(blocks.mesh.velocity);
    Vector3 sum{0, 0, 0};
    for (int a = 0; a < blocks.mesh.nodes; ++a)
      if ((a >= blocks.mesh.nodes / 2) == upper) sum = sum + m(a) * load_vector(v, a);
    return sum;
  }
  double energy(bool kinetic_only) const {
    const auto m = host_copy(blocks.mesh.mass);
    const auto v = host_copy(blocks.mesh.velocity);
    double sum = 0;
    for (int a = 0; a < blocks.mesh.nodes; ++a)
      sum += 0.5 * double(m(a) * dot(load_vector(v, a), load_vector(v, a)));
    if (kinetic_only) return sum;
    for (const ScalarField& field :
         {blocks.mesh.points.internal_work, blocks.mesh.hourglass_work, blocks.mesh.viscous_work,
          blocks.mesh.friction_work, blocks.mesh.body_contact_energy}) {
      const auto values = host_copy(field);
      for (std::size_t k = 0; k < values.extent(0); ++k) sum += double(values(k));
    }
    return sum;
  }
};

} // namespace

// In uniaxial strain a wave of constant strain runs through both and the bars part when it is back: the
// second has taken all the speed (Saint-Venant 1867). What is left as waves is that of the net.
TEST(PressBodies, equal_bars_exchange_their_speeds) {
  constexpr int length = 40;
  constexpr double speed = 6; // a thousandth of the wave speed
  Moving bars(1, length, {0, 0, -speed}, 0);
  bars.around.constraints = ConstraintTable("constraints", 2);
  const auto table = host_copy(bars.around.constraints);
  table(0) = {false, {1, 0, 0}, {0, 0, 0}}, table(1) = {false, {0, 1, 0}, {0, 0, 0}};
  Kokkos::deep_copy(bars.around.constraints, table);
  Kokkos::deep_copy(bars.blocks.mesh.constraints, 3u);
  const double start = bars.energy(true), momentum = double(bars.momentum(true).z);
  bars.advance(1e-3 / speed + 1.3 * 2 * length / Moving::wave_speed());
  const double upper = double(bars.momentum(true).z), lower = double(bars.momentum(false).z);
  EXPECT_NEAR(lower / momentum, 1, 0.02);
  EXPECT_NEAR(upper / momentum, 0, 0.02);
  EXPECT_NEAR((upper + lower) / momentum, 1, 1e-12);
  // Where contact begins and ends in a step costs a node at most (omega dt)^2 / 8 of its speed each (as at
  // the tool, verify_contact.cpp), omega dt = 1 here, and the nodes that touch have an 80th of the mass.
  EXPECT_NEAR(bars.energy(false) / start, 1, 2 * (0.125 + 0.125) / (2 * length));
}

// Askew, with friction: momentum to round-off, and the energy is where the ledger says.
TEST(PressBodies, a_block_that_glances_off_keeps_momentum_and_energy) {
  Moving m(4, 3, {40, 15, -60}, 0.3);
  const double start = m.energy(true);
  const Vector3 before = m.momentum(true) + m.momentum(false);
  const double scale = double(norm(before));
  m.advance(4 * 3 / Moving::wave_speed());
  const Vector3 after = m.momentum(true) + m.momentum(false);
  EXPECT_NEAR(double(norm(after - before)) / scale, 0, 1e-12);
  EXPECT_GT(double(m.momentum(true).z - m.momentum(false).z) / scale, 0.1) << "they part";
  EXPECT_LT(double(m.momentum(true).x) / double(before.x), 0.95) << "and rubbed";
  EXPECT_NEAR(m.energy(false) / start, 1, 0.01);
}
