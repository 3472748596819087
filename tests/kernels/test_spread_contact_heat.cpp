#include "support/materials.hpp"
#include "support/tied_block.hpp"
#include "swarf/kernels.hpp"
#include <gtest/gtest.h>

namespace swarf {
namespace {

// Hexes with tied particles in them; each node's capacity is what its hexes and tied particles give it.
test::TiedBlock heated_block(bool conducts) {
  test::TiedBlock b = test::make_tied_block({3, 4, 2}, 48);
  HexMesh& m = b.hexes;
  const Real c = test::ti64().specific_heat;
  m.heat_capacity = ScalarField("heat_capacity", m.nodes), m.nodal_heat = ScalarField("nodal_heat", m.nodes);
  m.contact_heat = ScalarField("contact_heat", m.nodes);
  if (conducts) m.nodal_temperature = ScalarField("nodal_temperature", m.nodes);
  Kokkos::deep_copy(b.particles.points.mass, Real(0.3));
  const auto C = host_copy(m.heat_capacity), Q = host_copy(m.contact_heat), mass = host_copy(m.points.mass),
             of_particle = host_copy(b.particles.points.mass);
  const auto corner = host_copy(m.connectivity);
  const auto host = host_copy(b.tie.host);
  const auto shape = host_copy(b.tie.shape);
  for (int e = 0; e < m.points.count; ++e)
    for (int a = 0; a < 8; ++a) C(corner(e, a)) += mass(e) * c / 8;
  for (int k = 0; k < b.tie.count; ++k)
    for (int a = 0; a < 8; ++a) C(corner(host(k), a)) += shape(k, a) * of_particle(5 + k) * c;
  for (int a = 0; a < m.nodes; ++a) Q(a) = Real(a % 5);
  Kokkos::deep_copy(m.heat_capacity, C), Kokkos::deep_copy(m.contact_heat, Q);
  return b;
}

double heat_of(const test::TiedBlock& b) {
  const double c = test::ti64().specific_heat;
  double sum = 0;
  const auto of = [&](const MaterialPoints& p, int begin, int end) {
    const auto m = host_copy(p.mass), T = host_copy(p.temperature);
    for (int i = begin; i < end; ++i) sum += c * double(m(i)) * double(T(i));
  };
  of(b.hexes.points, 0, b.hexes.points.count), of(b.particles.points, 5, 5 + b.tie.count);
  return sum;
}

TEST(SpreadContactHeat, KeepsHeatToRoundOff) {
  for (const bool conducts : {false, true}) {
    const test::TiedBlock b = heated_block(conducts);
    double given = 0;
    for (int a = 0; a < b.hexes.nodes; ++a) given += a % 5;
    Kokkos::deep_copy(b.hexes.points.temperature, Real(0)),
        Kokkos::deep_copy(b.particles.points.temperature, Real(0));
    for (int time = 0; time < 2; ++time) { // the second time there is nothing left to spread
      spread_contact_heat(b.tie, b.particles, b.hexes, {}, test::make_material_table({test::ti64()}));
      EXPECT_NEAR(heat_of(b) / given, 1, test::round_off);
    }
  }
}

// Conduction takes what differs from the mean of the nodes for the hex's own heat: contact must leave none.
TEST(SpreadContactHeat, HexesFollowTheirNodes) {
  const test::TiedBlock b = heated_block(true);
  Kokkos::deep_copy(b.hexes.nodal_temperature, Real(300)),
      Kokkos::deep_copy(b.hexes.points.temperature, Real(300));
  spread_contact_heat(b.tie, b.particles, b.hexes, {}, test::make_material_table({test::ti64()}));
  const auto T = host_copy(b.hexes.points.temperature), nodal = host_copy(b.hexes.nodal_temperature);
  const auto corner = host_copy(b.hexes.connectivity);
  for (int e = 0; e < b.hexes.points.count; ++e) {
    double mean = 0;
    for (int a = 0; a < 8; ++a) mean += double(nodal(corner(e, a))) / 8;
    EXPECT_NEAR(double(T(e)) / mean, 1, test::round_off);
  }
}

} // namespace
} // namespace swarf
