// press_bodies, of particles on hexes.
#include "support/particle_block.hpp"
#include "support/two_blocks.hpp"
#include "swarf/tool/contact_law.hpp"
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double depth = 1e-3;
constexpr int across = 6;

void add_contact(Particles& p, int rows) {
  p.body_friction = VectorField("body_friction", rows);
  p.body_contact_energy = ScalarField("body_contact_energy", rows);
  Kokkos::deep_copy(p.contact_gap, Real(0.5)), Kokkos::deep_copy(p.contact_area, Real(1));
}

constexpr double short_step = 1e-6; // s, so that the material is the softer spring

} // namespace

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
  const double c = double(longitudinal_wave_speed(elastic_steel()));
  const double force = 16 * 2 * 7800 * c * c * depth; // M area / gap of each
  EXPECT_NEAR(on_particles / force, 1, 1e-10);
  EXPECT_NEAR((on_particles + on_nodes) / force, 0, 1e-13);
}
