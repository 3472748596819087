// press_bodies, of particles: on particles of another body, and on hexes.
#include "support/particle_block.hpp"
#include "support/two_blocks.hpp"
#include "swarf/tool/contact_law.hpp"
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double depth = 1e-3;
constexpr int across = 6, high = 3;

void add_contact(Particles& p, int rows) {
  p.body_friction = VectorField("body_friction", rows);
  p.body_contact_energy = ScalarField("body_contact_energy", rows);
  Kokkos::deep_copy(p.contact_gap, Real(0.5)), Kokkos::deep_copy(p.contact_area, Real(1));
}

// Two blocks of particles of unit spacing; the upper one is moved along x, and by `depth` into the lower.
struct TwoPiles {
  ParticleBlock block;
  HexMesh mesh;
  ContactGroups groups;
  BodyContact contact;

  explicit TwoPiles(double shift) : block(particle_block(across, across, 2 * high, 1)) {
    Particles& p = block.particles;
    add_contact(p, p.total);
    const auto x = host_copy(p.position);
    const auto body = host_copy(p.body);
    for (int i = 0; i < p.count; ++i)
      if (x(i, 2) > high) body(i) = 1, x(i, 0) += Real(shift), x(i, 2) -= Real(depth);
    Kokkos::deep_copy(p.position, x), Kokkos::deep_copy(p.body, body);
    groups.count = 2, groups.of_particles = true, groups.skin = Real(0.3);
    groups.of_body = IndexField("of_body", 2);
    const auto of_body = host_copy(groups.of_body);
    of_body(1) = 1;
    Kokkos::deep_copy(groups.of_body, of_body);
    mesh.points.count = mesh.nodes = 0;
    find_body_contact(contact, mesh, p, groups);
  }
};

// On the upper block, and on both.
struct Sums {
  Vector3 upper{0, 0, 0}, all{0, 0, 0};
};
Sums press(TwoPiles& piles, const ContactLaw& law, double dt) {
  Particles& p = piles.block.particles;
  press_bodies(piles.contact, piles.mesh, p, {law, piles.block.materials, Real(1), Real(dt)});
  const auto f = host_copy(p.force);
  const auto body = host_copy(p.body);
  Sums sums;
  for (int i = 0; i < p.count; ++i) {
    sums.all = sums.all + load_vector(f, i);
    if (body(i) == 1) sums.upper = sums.upper + load_vector(f, i);
  }
  return sums;
}

// N/m of the material between two layers, M A / (2 gaps): both passes together.
double stiffness_between() {
  const double c = double(longitudinal_wave_speed(elastic_steel()));
  return 7800 * c * c;
}

constexpr double short_step = 1e-6; // so that the material is the softer spring

} // namespace

TEST(PressParticles, layers_over_each_other_press_like_the_material_between_them) {
  TwoPiles piles(0);
  ContactLaw law;
  law.stiffness = 1;
  const Sums s = press(piles, law, short_step);
  const double force = across * across * stiffness_between() * depth;
  EXPECT_NEAR(double(s.upper.z) / force, 1, 1e-3); // the second layer weighs a little
  EXPECT_NEAR(double(norm(s.all)) / force, 0, 1e-13);
}

// Wherever the upper lattice is over the lower one: no bumps to slide over. 5 of 6 columns have a face below
// them all the way, so that at most a sixth fades.
TEST(PressParticles, a_lattice_slides_on_a_lattice_without_bumps) {
  ContactLaw law;
  law.stiffness = 1;
  const double force = across * across * stiffness_between() * depth;
  for (const double shift : {0.1, 0.25, 0.4, 0.5}) {
    TwoPiles piles(shift);
    const Sums s = press(piles, law, short_step);
    EXPECT_NEAR(double(s.upper.z) / force, 1, 0.02) << shift;
    EXPECT_NEAR(double(s.upper.x) / force, 0, 0.02) << shift;
    EXPECT_NEAR(double(norm(s.all)) / force, 0, 1e-13) << shift;
  }
}

TEST(PressParticles, apart_they_feel_nothing) {
  TwoPiles piles(0.3);
  Particles& p = piles.block.particles;
  set_rows(p.position, p.count, [](const Vector3& x) {
    return x.z > high ? Vector3{x.x, x.y, x.z + Real(1.5 * depth)} : x;
  });
  ContactLaw law;
  law.stiffness = 1, law.friction = Real(0.5);
  const Sums s = press(piles, law, short_step);
  EXPECT_EQ(norm(s.upper), 0);
}

// Particles on the upper side of hexes, the hexes over them deleted.
TEST(PressParticles, on_hexes_with_the_spring_of_half_a_particle) {
  TwoBlocks b = two_blocks(across, 2, Real(1), 0.5);
  const auto active = host_copy(b.mesh.active);
  for (int e = 2 * across * across; e < b.mesh.points.count; ++e) active(e) = 0;
  Kokkos::deep_copy(b.mesh.active, active);
  ParticleBlock block = particle_block(4, 4, 1, 1);
  Particles& p = block.particles;
  add_contact(p, p.total);
  set_rows(p.position, p.count, [](const Vector3& x) {
    return Vector3{x.x + Real(0.7), x.y + Real(0.2), Real(2.5 - depth)};
  });
  Kokkos::deep_copy(p.body, 1);
  const auto of_body = host_copy(b.groups.of_body);
  of_body(1) = 1;
  Kokkos::deep_copy(b.groups.of_body, of_body);
  find_body_contact(b.contact, b.mesh, p, b.groups);
  ContactLaw law;
  law.stiffness = 1;
  press_bodies(b.contact, b.mesh, p, {law, b.materials, Real(1), Real(short_step)});
  double on_particles = 0, on_nodes = 0;
  const auto f = host_copy(p.force), g = host_copy(b.mesh.force);
  for (int i = 0; i < p.count; ++i) on_particles += double(f(i, 2));
  for (int a = 0; a < b.mesh.nodes; ++a) on_nodes += double(g(a, 2));
  const double force = 16 * 2 * stiffness_between() * depth;
  EXPECT_NEAR(on_particles / force, 1, 1e-10);
  EXPECT_NEAR((on_particles + on_nodes) / force, 0, 1e-13);
}
