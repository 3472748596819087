// The row at a held face moves by a lever between the face and the next row: against Lagrange's equation of
// the one degree of freedom that is left, v_i = (1 - c) v_f + c v_m, c = 1/3.
#include "support/box_tool.hpp"
#include "swarf/kernels.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

constexpr Real round_off = Kokkos::Experimental::epsilon_v<Real> * 100;

struct Lever {
  Motion motion; // row 0: the host, 5 kg; rows 1, 2: of the held row, 2 and 3 kg
  HeldRows rows;
  ConstraintTable table;
};

IndexField indices(const std::vector<int>& values) {
  const IndexField f("indices", values.size());
  for (std::size_t k = 0; k < values.size(); ++k) Kokkos::deep_copy(Kokkos::subview(f, k), values[k]);
  return f;
}

Lever make_lever(const Vector3& face_velocity) {
  Lever l;
  Motion& m = l.motion;
  m.count = 3;
  m.position = VectorField("position", 3), m.velocity = VectorField("velocity", 3);
  m.force = VectorField("force", 3), m.mass = ScalarField("mass", 3);
  m.external_work = ScalarField("external_work", 3), m.constraints = View<unsigned*>("constraints", 3);
  m.plastic_strain = ScalarField("plastic_strain", 3);
  const auto mass = host_copy(m.mass);
  mass(0) = 5, mass(1) = 2, mass(2) = 3;
  Kokkos::deep_copy(m.mass, mass);
  const auto bits = host_copy(m.constraints);
  bits(1) = bits(2) = 1u | follows_bit;
  Kokkos::deep_copy(m.constraints, bits);
  l.rows = {1, indices({0}), indices({0, 2}), indices({1, 2}), indices({0, 0}), indices({0, 1, 2})};
  l.table = ConstraintTable("table", 1);
  Kokkos::deep_copy(l.table, Constraint{true, {1, 0, 0}, face_velocity});
  return l;
}

void step(const Lever& l, Real mass_factor, Real dt) {
  kick(l.motion, l.table, {0, 0, 0}, mass_factor, dt);
  hold_faces(l.rows, l.motion, l.table, {mass_factor, dt});
}

// (m_0 + c^2 (m_1 + m_2)) dv_0/dt = f_0 + c (f_1 + f_2); the fixed face does no work.
TEST(HoldFaces, TheForceOfTheRowPassesByTheLever) {
  for (const Real factor : {Real(1), Real(100)}) {
    const Lever l = make_lever({0, 0, 0});
    set_row(l.motion.force, 0, {4, 0, 1}), set_row(l.motion.force, 1, {0, 6, 1}),
        set_row(l.motion.force, 2, {9, 0, 0});
    const Real inertia = factor * (5 + Real(5) / 9);
    Vector3 v{0, 0, 0};
    for (int k = 0; k < 20; ++k) {
      step(l, factor, Real(0.1));
      v = v + (Real(0.1) / inertia) * Vector3{7, 2, Real(4) / 3};
    }
    EXPECT_LT(norm(get_row(l.motion.velocity, 0) - v), round_off * norm(v));
    for (int i : {1, 2})
      EXPECT_LT(norm(get_row(l.motion.velocity, i) - (Real(1) / 3) * v), round_off * norm(v));
    Real external = 0;
    for (int i = 0; i < 3; ++i) external += get_row(l.motion.external_work, i);
    EXPECT_LT(std::abs(external), round_off * inertia * dot(v, v));
  }
}

// A driven face does the work that is missing: what the masses gain less what the forces give.
TEST(HoldFaces, ADrivenFaceDoesTheWorkOfItsReaction) {
  const Vector3 face{3, 0, -1};
  const Lever l = make_lever(face);
  set_row(l.motion.velocity, 1, (Real(2) / 3) * face), set_row(l.motion.velocity, 2, (Real(2) / 3) * face);
  const Vector3 f[3] = {{-40, 10, 0}, {-5, 3, 8}, {2, 2, 2}};
  for (int i = 0; i < 3; ++i) set_row(l.motion.force, i, f[i]);
  const Real mass[3] = {5, 2, 3}, dt = Real(0.05);
  const auto kinetic = [&] {
    Real sum = 0;
    for (int i = 0; i < 3; ++i)
      sum += mass[i] / 2 * dot(get_row(l.motion.velocity, i), get_row(l.motion.velocity, i));
    return sum;
  };
  const Real before = kinetic();
  Real given = 0, external = 0;
  Vector3 reaction{0, 0, 0}; // impulse of the face: of the row less the lever's share of the host
  for (int k = 0; k < 30; ++k) {
    Vector3 old[3];
    for (int i = 0; i < 3; ++i) old[i] = get_row(l.motion.velocity, i);
    step(l, 1, dt);
    for (int i = 0; i < 3; ++i) {
      const Vector3 now = get_row(l.motion.velocity, i);
      given += dt / 2 * dot(f[i], old[i] + now);
      if (i > 0) reaction = reaction + (Real(2) / 3) * (mass[i] * (now - old[i]) - dt * f[i]);
    }
  }
  for (int i = 0; i < 3; ++i) external += get_row(l.motion.external_work, i);
  EXPECT_NEAR(kinetic() - before - given, external, round_off * std::abs(given));
  EXPECT_NEAR(external, dot(reaction, face), round_off * std::abs(given));
}

// A host that is frozen stands still, and so does what follows it at a fixed face.
TEST(HoldFaces, OfAFrozenHostTheRowStands) {
  const Lever l = make_lever({0, 0, 0});
  const auto bits = host_copy(l.motion.constraints);
  bits(0) |= held_bit;
  Kokkos::deep_copy(l.motion.constraints, bits);
  set_row(l.motion.force, 1, {1, 2, 3});
  step(l, 1, Real(0.1));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(norm(get_row(l.motion.velocity, i)), 0);
}

// A host that flows goes elsewhere: the row is the face's, and the host is free.
TEST(HoldFaces, OfAHostThatFlowsTheRowIsTheFaces) {
  const Vector3 face{3, 0, -1};
  const Lever l = make_lever(face);
  Kokkos::deep_copy(l.motion.plastic_strain, Real(0.1));
  set_row(l.motion.force, 0, {10, 0, 0}), set_row(l.motion.force, 1, {1, 2, 3});
  step(l, 1, Real(0.5));
  EXPECT_LT(norm(get_row(l.motion.velocity, 0) - Vector3{1, 0, 0}), round_off);
  for (int i : {1, 2}) EXPECT_EQ(norm(get_row(l.motion.velocity, i) - face), 0);
}

} // namespace
} // namespace swarf::test
