#include "support/box_tool.hpp"
#include "support/materials.hpp"
#include "support/points.hpp"
#include "support/tool_bar.hpp"
#include "swarf/kernels.hpp"
#include "swarf/material/flow_law.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace swarf {
namespace {

constexpr double precision = sizeof(Real) == 8 ? 1 : 1e6; // how much worse float may be

// Steps as the simulation does: kick half, drift, contact, kick half. One material, one pose per step.
struct Slider {
  Tool tool;
  ContactPoints points;
  ContactLaw law;
  MaterialTable materials = test::make_material_table({test::ti64()});
  Vector3 gravity{0, 0, 0};
  double time = 0;

  template <class Pose>
  void run(double end, double dt, const Pose& pose_at, Real mass_factor = 1) {
    for (long steps = std::lround((end - time) / dt); steps > 0; --steps) {
      kick_half(dt, mass_factor);
      drift_points(dt);
      time += dt;
      Kokkos::deep_copy(points.force, Real(0));
      tool_contact(points, tool, pose_at(time), law, materials, mass_factor, Real(dt));
      kick_half(dt, mass_factor);
    }
  }
  void kick_half(double dt, Real mass_factor);
  void drift_points(double dt);
};

void kick_points(const ContactPoints& p, Vector3 gravity, Real half, Real mass_factor) {
  Kokkos::parallel_for(
      "kick_points", Range(0, p.count), KOKKOS_LAMBDA(const int i) {
        const Vector3 acceleration =
            (Real(1) / (mass_factor * p.mass(i))) * load_vector(p.force, i) + gravity;
        store_vector(p.velocity, i, load_vector(p.velocity, i) + half * acceleration);
      });
}
void move_points(const ContactPoints& p, Real dt) {
  Kokkos::parallel_for(
      "move_points", Range(0, p.count), KOKKOS_LAMBDA(const int i) {
        store_vector(p.position, i, load_vector(p.position, i) + dt * load_vector(p.velocity, i));
      });
}
void Slider::kick_half(double dt, Real mass_factor) {
  kick_points(points, gravity, Real(dt / 2), mass_factor);
}
void Slider::drift_points(double dt) { move_points(points, Real(dt)); }

ToolPose at_rest(double) { return {}; }

// A point of 2 kg on top of a box whose upper face is z = 1; pressed in by its weight from the start.
Slider make_slider(double friction) {
  Slider s;
  s.tool = test::make_box_tool({1, 1, 1}, 1);
  s.points = test::make_contact_points(1, 2);
  s.law.friction = Real(friction), s.law.stiffness = Real(0.1);
  s.gravity = {0, 0, -10};
  return s;
}
void rest_on_box(Slider& s, double dt) {
  const double k = 0.1 * 2 / (dt * dt);
  test::set_row(s.points.position, 0, {0, 0, Real(1 - 2 * 10 / k)});
  test::set_row(s.points.force, 0, {0, 0, 20});
}

// v^2 / (2 mu g) = 0.1 m, v / (mu g) = 0.2 s; all of m v^2 / 2 = 1 J becomes friction work.
TEST(ToolContact, SlidingBlockStopsWhereCoulombSays) {
  Slider s = make_slider(0.5);
  const double dt = 1e-4;
  rest_on_box(s, dt);
  test::set_row(s.points.velocity, 0, {1, 0, 0});
  s.run(0.198, dt, at_rest);
  EXPECT_GT(test::get_row(s.points.velocity, 0).x, 0.005);
  s.run(0.202, dt, at_rest);
  EXPECT_NEAR(test::get_row(s.points.velocity, 0).x, 0, 0.01);
  s.run(0.4, dt, at_rest);
  EXPECT_NEAR(test::get_row(s.points.position, 0).x, 0.1, 0.001);
  EXPECT_NEAR(test::get_row(s.points.friction_work, 0), 1, 0.001);
  const Vector3 v = test::get_row(s.points.velocity, 0);
  const double left =
      dot(v, v) + test::get_row(s.points.contact_energy, 0) - 0.5 * 20 * 20 / (0.2 / (dt * dt));
  EXPECT_NEAR(test::get_row(s.points.friction_work, 0) + left, 1, 1e-6 * precision); // the ledger closes
}

// A belt at 1 m/s takes a point along: at speed after 0.2 s and 0.1 m; the belt loses twice what the point
// gains.
TEST(ToolContact, BeltTakesAPointAlongAndThenDoesNotSlip) {
  Slider s = make_slider(0.5);
  const double dt = 1e-4;
  s.tool = test::make_box_tool({1, 1, 1}, 1);
  rest_on_box(s, dt);
  const auto belt = [](double t) {
    ToolPose pose;
    pose.velocity = {1, 0, 0}, pose.position = {Real(t - 0.2), 0, 0};
    return pose;
  };
  s.run(0.2, dt, belt);
  EXPECT_NEAR(test::get_row(s.points.velocity, 0).x, 1, 0.01);
  s.run(0.3, dt, belt);
  EXPECT_NEAR(test::get_row(s.points.position, 0).x, 0.1 + 0.1, 0.002);
  const double work = test::get_row(s.points.friction_work, 0);
  EXPECT_NEAR(work, 1, 0.01);
  s.run(0.4, dt, belt);
  EXPECT_NEAR(test::get_row(s.points.friction_work, 0), work, 0.001 * work);
}

// A point fixed to a tool that turns and travels feels no friction, however fast.
TEST(ToolContact, PointThatMovesWithTheToolDoesNotSlip) {
  Slider s = make_slider(0.5);
  const Vector3 local{Real(0.5), Real(-0.3), Real(0.999)};
  ToolPose pose;
  pose.velocity = {3, 4, 0}, pose.angular_velocity = 100;
  for (int step = 0; step < 50; ++step) {
    pose.angle = Real(-0.03 * step), pose.position = {Real(0.1 * step), 0, 0};
    const Vector3 x = pose.position + direction_to_world(make_frame(pose), local);
    test::set_row(s.points.position, 0, x);
    test::set_row(s.points.velocity, 0, surface_velocity(pose, x));
    tool_contact(s.points, s.tool, pose, s.law, s.materials, 1, Real(1e-3));
    const Vector3 f = test::get_row(s.points.contact_force, 0);
    ASSERT_GT(f.z, 0);
    ASSERT_NEAR(std::hypot(f.x, f.y), 0, 1e-9 * precision * f.z);
  }
  EXPECT_NEAR(test::get_row(s.points.friction_work, 0), 0, 1e-12 * precision);
}

// Mass on a spring for half a period: pi sqrt(m / k) in contact, and the same speed back. The first and the
// last step only graze the spring, so the error falls with the stiffness number.
TEST(ToolContact, PenaltyReboundKeepsTheSpeed) {
  for (const Real mass_factor : {Real(1), Real(100)}) {
    Slider s = make_slider(0);
    s.gravity = {0, 0, 0}, s.law.stiffness = Real(1e-4);
    const double dt = 1e-5, contact_time = std::acos(-1) * dt / std::sqrt(1e-4);
    test::set_row(s.points.position, 0, {0, 0, Real(1 + 0.5 * dt)});
    test::set_row(s.points.velocity, 0, {0, 0, -1});
    int touching = 0;
    for (int step = 0; step < 1000; ++step) {
      s.run(s.time + dt, dt, at_rest, mass_factor);
      touching += test::get_row(s.points.contact_force, 0).z > 0;
    }
    EXPECT_NEAR(test::get_row(s.points.velocity, 0).z, 1, 1e-3);
    EXPECT_NEAR(touching * dt, contact_time, 0.01 * contact_time);
    EXPECT_EQ(test::get_row(s.points.contact_energy, 0), 0);
  }
}

TEST(ToolContact, GapIsThePointsOwnRadius) {
  Slider s = make_slider(0);
  Kokkos::deep_copy(s.points.gap, Real(0.25));
  test::set_row(s.points.position, 0, {0, 0, Real(1.125)});
  tool_contact(s.points, s.tool, {}, s.law, s.materials, 3, Real(0.5));
  EXPECT_NEAR(test::get_row(s.points.contact_force, 0).z, 0.1 * 3 * 2 / 0.25 * 0.125, 1e-12 * precision);
  s.law.reference_step = Real(0.25); // the same stiffness whatever the step
  tool_contact(s.points, s.tool, {}, s.law, s.materials, 3, Real(0.5));
  EXPECT_NEAR(test::get_row(s.points.contact_force, 0).z, 0.1 * 3 * 2 / 0.0625 * 0.125, 1e-12 * precision);
}

TEST(ToolContact, PointThatLeavesForgetsFrictionAndEnergy) {
  Slider s = make_slider(0.5);
  test::set_row(s.points.position, 0, {0, 0, Real(0.999)});
  test::set_row(s.points.velocity, 0, {1, 0, 0});
  tool_contact(s.points, s.tool, {}, s.law, s.materials, 1, Real(1e-3));
  EXPECT_LT(test::get_row(s.points.friction_force, 0).x, 0);
  test::set_row(s.points.position, 0, {0, 0, Real(1.001)});
  tool_contact(s.points, s.tool, {}, s.law, s.materials, 1, Real(1e-3));
  for (const VectorField& field : {s.points.friction_force, s.points.contact_force})
    EXPECT_EQ(norm(test::get_row(field, 0)), 0);
  EXPECT_EQ(test::get_row(s.points.contact_energy, 0), 0);
}

TEST(ToolContact, PointWithoutAreaIsLeftAlone) {
  Slider s = make_slider(0.5);
  Kokkos::deep_copy(s.points.area, Real(0));
  test::set_row(s.points.position, 0, {0, 0, Real(0.9)});
  tool_contact(s.points, s.tool, {}, s.law, s.materials, 1, Real(1e-3));
  EXPECT_EQ(norm(test::get_row(s.points.force, 0)), 0);
}

// dT = share W / (m c), with the true mass.
TEST(ToolContact, FrictionHeatsThePointByItsShare) {
  Slider s = make_slider(0.5);
  s.points.temperature = ScalarField("temperature", 1);
  s.law.heat_to_workpiece = Real(0.3);
  test::set_row(s.points.position, 0, {0, 0, Real(0.999)});
  test::set_row(s.points.velocity, 0, {1, 0, 0});
  for (int step = 0; step < 20; ++step)
    tool_contact(s.points, s.tool, {}, s.law, s.materials, 100, Real(1e-3));
  const double work = test::get_row(s.points.friction_work, 0);
  EXPECT_GT(work, 0);
  EXPECT_NEAR(test::get_row(s.points.temperature, 0), 0.3 * work / (2 * 526.3), 1e-12 * precision * work);
}

// A bed of points on springs, pressed and rubbed by the tool: a start that is 1e-4 of the spacing farther
// away shifts the force by that share of the way, 2e-4 of it, and by nothing else.
Vector3 press_bed(double farther) {
  const int n = 25;
  const double spacing = 0.1, dt = 1e-3, end = 0.5, depth = 0.5 * spacing;
  Slider s = make_slider(0.4);
  s.points = test::make_contact_points(n, 1), s.gravity = {0, 0, 0};
  Kokkos::deep_copy(s.points.gap, Real(spacing / 2));
  const auto x = host_copy(s.points.position);
  for (int i = 0; i < n; ++i) store_vector(x, i, {Real(spacing * (i % 5)), Real(spacing * (i / 5)), 0});
  Kokkos::deep_copy(s.points.position, x);
  Vector3 sum{0, 0, 0};
  for (int step = 0; step <= end / dt; ++step) {
    const double t = step * dt;
    ToolPose pose; // its lower face, z = -1 in its frame, comes down onto the bed and moves along x
    pose.velocity = {Real(0.3), 0, Real(-depth / end)};
    pose.position = {Real(0.3 * t), 0, Real(1 + spacing / 2 * (1 + 2 * farther) - depth / end * t)};
    tool_contact(s.points, s.tool, pose, s.law, s.materials, 1, Real(dt));
    // The bed: each point held by a spring of 1e4 N/m, without inertia; the velocity is what it moved.
    const auto f = host_copy(s.points.contact_force), at = host_copy(s.points.position);
    const auto v = host_copy(s.points.velocity);
    sum = {0, 0, 0};
    for (int i = 0; i < n; ++i) {
      sum = sum + load_vector(f, i);
      const Vector3 home{Real(spacing * (i % 5)), Real(spacing * (i / 5)), 0};
      const Vector3 old = load_vector(at, i);
      const Vector3 now = old + Real(0.05) * (home + Real(1e-4) * load_vector(f, i) - old);
      store_vector(at, i, now), store_vector(v, i, Real(1 / dt) * (now - old));
    }
    Kokkos::deep_copy(s.points.position, at);
    Kokkos::deep_copy(s.points.velocity, v);
  }
  return sum;
}
TEST(ToolContact, TinyChangeOfTheStartGivesATinyChangeOfForce) {
  const Vector3 force = press_bed(0), shifted = press_bed(1e-4);
  EXPECT_GT(-force.z, 0);
  EXPECT_GT(force.x, 0.1 * -force.z);
  EXPECT_LT(norm(shifted - force), 1e-3 * norm(force));
  EXPECT_GT(norm(shifted - force), 0);
}

// --- the law itself
TEST(ContactLaw, MemoryTurnsWithTheNormalAndKeepsItsLength) {
  std::mt19937 generator(3);
  std::normal_distribution<Real> normal;
  for (int k = 0; k < 100; ++k) {
    Vector3 n{normal(generator), normal(generator), normal(generator)};
    n = (1 / norm(n)) * n;
    const Vector3 f{normal(generator), normal(generator), normal(generator)};
    const Vector3 turned = turn_into_plane(f, n);
    EXPECT_NEAR(norm(turned), norm(f), test::round_off * 10);
    EXPECT_NEAR(dot(turned, n), 0, test::round_off * 10);
    EXPECT_GT(dot(turned, f), 0);
  }
  EXPECT_EQ(norm(turn_into_plane({0, 0, 2}, {0, 0, 1})), 0);
}

TEST(ContactLaw, ShearLimitCapsFriction) {
  ContactLaw law;
  law.friction = Real(0.5), law.shear_limit = 100;
  ContactStep step{1, {0, 0, 1}, {-10, 0, 0}, {0, 0, 0}};
  EXPECT_NEAR(respond_to_contact(step, law, 1000, 2).force.x, 200,
              1e-9 * precision); // tau area < mu f_n = 500
  EXPECT_NEAR(respond_to_contact(step, law, 1000, 20).force.x, 500, 1e-9 * precision);
  law.shear_limit = 0;
  EXPECT_NEAR(respond_to_contact(step, law, 1000, 2).force.x, 500, 1e-9 * precision);
}

// von Mises: a material that flows at sigma_y in tension carries the shear sigma_y / sqrt 3, at its
// temperature.
TEST(ContactLaw, FrictionIsNoMoreThanTheMaterialCarries) {
  const Material mat = test::ti64();
  ContactLaw law;
  law.friction = Real(0.5), law.shear_limit = Real(1e12);
  const Real warm = Real(900), melt = mat.johnson_cook.melt_temperature, strain = Real(0.2),
             area = Real(1e-12);
  const Real yield = (mat.johnson_cook.A + mat.johnson_cook.B * Kokkos::pow(strain, mat.johnson_cook.n)) *
                     (1 + mat.johnson_cook.C * Kokkos::log(Real(1e4))) *
                     (1 - Kokkos::pow((warm - mat.johnson_cook.reference_temperature) /
                                          (melt - mat.johnson_cook.reference_temperature),
                                      mat.johnson_cook.m));
  ContactStep step{1, {0, 0, 1}, {-10, 0, 0}, {0, 0, 0}, shear_strength(mat, strain, Real(1e4), warm)};
  const Real friction = respond_to_contact(step, law, 1000, area).force.x;
  EXPECT_NEAR(friction / (yield / std::sqrt(Real(3)) * area), 1, test::round_off);
  step.shear_strength = shear_strength(mat, strain, Real(1e4), melt);
  EXPECT_EQ(respond_to_contact(step, law, 1000, area).force.x, 0);
  step.shear_strength = shear_strength(test::elastic_solid(1, 1, 1), 0, 0, 300);
  EXPECT_NEAR(respond_to_contact(step, law, 1000, 1).force.x, 500, 1e-9 * precision);
}

// The kernel asks the material of each point: a cold one holds by Coulomb's law, a molten one not at all.
TEST(ToolContact, MoltenPointsDoNotRub) {
  for (const bool molten : {false, true}) {
    Slider s = make_slider(0.5);
    const double dt = 1e-4;
    rest_on_box(s, dt);
    test::set_row(s.points.velocity, 0, {1, 0, 0});
    s.points.plastic_strain = ScalarField("plastic_strain", 1);
    s.points.plastic_strain_rate = ScalarField("plastic_strain_rate", 1);
    s.points.temperature = ScalarField("temperature", 1), s.points.material = IndexField("material", 1);
    Kokkos::deep_copy(s.points.temperature, molten ? test::ti64().johnson_cook.melt_temperature : Real(298));
    s.run(0.1, dt, at_rest);
    EXPECT_NEAR(test::get_row(s.points.velocity, 0).x, molten ? 1 : 0.5, 1e-3);
  }
}

TEST(ContactLaw, SlipIsOneVectorWhateverItsDirection) {
  ContactLaw law;
  law.friction = Real(0.5);
  for (int k = 0; k < 12; ++k) {
    const Real angle = Real(0.5 * k);
    const Vector3 along{Kokkos::cos(angle), Kokkos::sin(angle), 0};
    const Vector3 f = respond_to_contact({1, {0, 0, 1}, Real(10) * along, {0, 0, 0}}, law, 1000, 1).force;
    EXPECT_NEAR(dot(f, along), -500, 1e-9 * precision);
    EXPECT_NEAR(norm(cross(f, along)), norm(cross(Vector3{0, 0, 1000}, along)), 1e-9 * precision);
  }
}

// Trapezoidal work of the friction force on the point + energy of the spring + dissipated = 0, over stick,
// slip, reversal, change of load and parting.
TEST(ContactLaw, FrictionLedgerClosesToRoundOff) {
  ContactLaw law;
  law.friction = Real(0.3);
  const Real k = 1000;
  std::mt19937 generator(5);
  std::uniform_real_distribution<Real> uniform(-1, 1);
  Vector3 f{0, 0, 0};
  double work = 0, dissipated = 0, largest = 0;
  for (int s = 0; s < 2000; ++s) {
    const ContactStep step{uniform(generator) + Real(0.7),
                           {0, 0, 1},
                           Real(0.2) * Vector3{uniform(generator), uniform(generator), 0},
                           f};
    const ContactResponse r = respond_to_contact(step, law, k, 1);
    work += 0.5 * dot(f + r.friction_force, step.slip);
    dissipated += r.dissipated;
    largest = std::max(largest, double(norm(r.friction_force)));
    f = r.friction_force;
  }
  const double stored = dot(f, f) / (2 * k);
  EXPECT_GT(dissipated, 10);
  EXPECT_LE(largest, 0.3 * 1000 * 1.7 * (1 + test::round_off));
  EXPECT_NEAR(work + stored + dissipated, 0, test::round_off * 100 * dissipated);
}

// A point that slides at 0.5 m/s over a face of the box, pressed in by a millimetre: each of its two patches
// is 2 m2. One point on a patch, in steps of 10 ms, for 1 s.
Slider slide_over_patches(double friction, double wear_A, double wear_B) {
  Slider s = make_slider(friction);
  s.law.reference_step = Real(1e-2); // k = 0.1 * 2 kg / (10 ms)^2 = 2000 N/m: 2 N
  s.gravity = {0, 0, 0};
  ToolSurface& patches = s.tool.surface;
  patches.patches = s.tool.facets;
  patches.tree = IndexField("tree", 12), patches.halved = IndexField("halved", 12);
  patches.corner = s.tool.vertex, patches.area = ScalarField("area", 12);
  patches.sums = View<Real* [surface_sums]>("sums", 12);
  patches.first = IndexField("first", 13), patches.source = IndexField("source", 1);
  patches.spread_start = IndexField("start", 13),
  patches.spread_from = IndexField("from", 12); // each to itself
  patches.spread_share = ScalarField("share", 12);
  patches.wear_A = Real(wear_A), patches.wear_B = Real(wear_B);
  const auto tree = host_copy(patches.tree), start = host_copy(patches.spread_start),
             from = host_copy(patches.spread_from);
  for (int f = 0; f < 12; ++f) tree(f) = -1 - f, from(f) = f, start(f + 1) = f + 1;
  Kokkos::deep_copy(patches.spread_start, start), Kokkos::deep_copy(patches.spread_from, from);
  Kokkos::deep_copy(patches.spread_share, Real(1));
  Kokkos::deep_copy(patches.tree, tree), Kokkos::deep_copy(patches.area, Real(2));
  s.points.on_tool = View<Real* [surface_sums]>("on_tool", 1), s.points.tool_patch = IndexField("patch", 1);
  test::set_row(s.points.position, 0, {Real(0.1), Real(-0.5), Real(0.999)});
  return s;
}

void slide_for_a_second(const Slider& s) {
  ToolPose pose;
  pose.velocity = {Real(-0.5), 0, 0};
  for (int step = 0; step < 100; ++step)
    tool_contact(s.points, s.tool, pose, s.law, s.materials, 1, Real(1e-2));
  gather_tool_surface(s.points, s.tool.surface);
}

// Of the patch that the point touches; the others show nothing.
std::array<double, shown_on_tool> shown_of(const Slider& s) {
  const auto shown = host_copy(show_tool_surface(s.tool, 1));
  const int touched = host_copy(s.points.tool_patch)(0);
  std::array<double, shown_on_tool> out{};
  for (int p = 0; p < 12; ++p)
    for (int q = 0; q < shown_on_tool; ++q) {
      if (p == touched) out[std::size_t(q)] = double(shown(p, q));
      if (p != touched && q != shown_temperature) {
        EXPECT_EQ(shown(p, q), 0) << p << " " << q;
      }
    }
  return out;
}

TEST(ToolContact, PatchesShowPressureSpeedAndFriction) {
  const Slider s = slide_over_patches(0.25, 0, 0);
  slide_for_a_second(s);
  const auto shown = shown_of(s);
  EXPECT_NEAR(shown[shown_pressure], 1, 1e-9 * precision); // 2 N / 2 m2
  EXPECT_NEAR(shown[shown_speed], 0.5, 1e-9 * precision);
  // All that friction has dissipated: 0.5 N * 5 mm in each step but the first, in which the force rises to
  // 0.5 N from nothing, (0 + 0.5) * (10 - 0.5) / (2 * 2000) J by the trapezoidal rule.
  EXPECT_NEAR(2 * shown[shown_friction], double(test::get_row(s.points.friction_work, 0)), 1e-12 * precision);
  EXPECT_NEAR(2 * shown[shown_friction], 99 * 2.5e-3 + 1.1875e-3, 1e-9 * precision);
  EXPECT_EQ(shown[shown_wear], 0);
}

// Usui's law with constant pressure, speed and temperature: A p v t exp(-B / T) = 1e-3 / Pa * 1 Pa * 0.5 m *
// exp(-1800 / 900) = 6.76676416e-5 m. The tool is held at the temperature of the point, so no heat flows.
TEST(ToolContact, WearsAsUsuiSaysUnderConstantConditions) {
  Slider s = slide_over_patches(0, 1e-3, 1800);
  Material conductor = test::ti64();
  conductor.conductivity = 7;
  s.materials = test::make_material_table({conductor});
  s.tool.heat = test::make_tool_bar(0, 1);
  test::hold_cell(s.tool.heat, 0);
  Kokkos::deep_copy(s.tool.heat.temperature, Real(900));
  s.points.temperature = ScalarField("temperature", 1), s.points.gap = ScalarField("gap", 1);
  Kokkos::deep_copy(s.points.temperature, Real(900));
  s.points.heat_to_tool = ScalarField("heat_to_tool", 1), s.points.tool_cell = IndexField("tool_cell", 1);
  slide_for_a_second(s);
  const auto shown = shown_of(s);
  EXPECT_NEAR(shown[shown_wear] / 6.76676416e-5, 1, 1e-8 * precision);
  EXPECT_NEAR(shown[shown_temperature], 900, 1e-9 * precision);
  slide_for_a_second(s);
  EXPECT_NEAR(shown_of(s)[shown_wear] / (2 * 6.76676416e-5), 1, 1e-8 * precision); // it goes on
}

} // namespace
} // namespace swarf
