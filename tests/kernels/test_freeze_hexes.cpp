#include "support/hex_block.hpp"
#include "support/hex_step.hpp"
#include "support/materials.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

constexpr double edge = 1e-5;

// A bar of 30 x 2 x 2 hexes along x whose nodes all move; the active region is at its near end.
struct Bar {
  Material material;
  HexMesh mesh;
  Freeze freeze;
  VectorField region{"active_region", 1};
  TransformTable none{"none", 0};

  Bar() : mesh(make_hex_block({30, 2, 2}, material = ti64(), edge)) {
    mesh.damping = ScalarField("damping", mesh.nodes);
    mesh.friction_work = mesh.contact_energy = ScalarField("zero", mesh.nodes);
    Kokkos::deep_copy(mesh.velocity, Real(2));
    freeze.distance = 10 * edge, freeze.ramp = 5 * edge, freeze.damping = 1e6;
  }
};

TEST(FreezeHexes, only_hexes_without_a_moving_node_freeze) {
  const Bar b;
  freeze_hexes(b.mesh, b.none, b.region, b.freeze);
  const auto x = host_copy(b.mesh.position);
  const auto bits = host_copy(b.mesh.constraints);
  for (int a = 0; a < b.mesh.nodes; ++a)
    EXPECT_EQ((bits(a) & held_bit) != 0, norm(load_vector(x, a)) > 10 * edge) << a;
  const auto active = host_copy(b.mesh.active);
  const auto connectivity = host_copy(b.mesh.connectivity);
  int frozen = 0;
  for (int e = 0; e < b.mesh.points.count; ++e) {
    bool moves = false;
    for (int k = 0; k < 8; ++k) moves |= !(bits(connectivity(e, k)) & held_bit);
    EXPECT_EQ(active(e), moves ? hex_active : hex_frozen);
    frozen += !moves;
  }
  EXPECT_EQ(frozen,
            4 * 19 + 4 - 1); // the node on the bar's edge at 10 edges moves, its three neighbours do not
}

TEST(FreezeHexes, the_energy_of_what_stops_leaves_by_external_work) {
  Bar b;
  b.freeze.mass_factor = 100;
  const Real factor = 100, before = sum_hexes(b.mesh, factor).kinetic;
  freeze_hexes(b.mesh, b.none, b.region, b.freeze);
  const PointSums after = sum_hexes(b.mesh, factor);
  EXPECT_LT(after.kinetic, Real(0.4) * before);
  EXPECT_NEAR(after.kinetic - after.external, before, round_off * before);
}

TEST(FreezeHexes, both_nodes_of_a_periodic_pair_move_if_one_does) {
  Bar b;
  b.mesh.coupled_nodes = View<int* [3]>("coupled_nodes", 1);
  const auto pair = host_copy(b.mesh.coupled_nodes);
  pair(0, 0) = 0, pair(0, 1) = b.mesh.nodes - 1, pair(0, 2) = 0;
  Kokkos::deep_copy(b.mesh.coupled_nodes, pair);
  freeze_hexes(b.mesh, TransformTable("one", 1), b.region, b.freeze);
  const auto bits = host_copy(b.mesh.constraints);
  EXPECT_EQ(bits(0) & held_bit, 0u);
  EXPECT_EQ(bits(b.mesh.nodes - 1) & held_bit, 0u);
}

TEST(FreezeHexes, thawing_frees_all_nodes_and_deleted_hexes_stay_deleted) {
  const Bar b;
  const auto active = host_copy(b.mesh.active);
  active(100) = hex_deleted;
  Kokkos::deep_copy(b.mesh.active, active);
  freeze_hexes(b.mesh, b.none, b.region, b.freeze);
  freeze_hexes(b.mesh, b.none, VectorField("none", 0), b.freeze);
  const auto thawed = host_copy(b.mesh.active);
  const auto bits = host_copy(b.mesh.constraints);
  for (int e = 0; e < b.mesh.points.count; ++e) EXPECT_EQ(thawed(e), e == 100 ? hex_deleted : hex_active);
  for (int a = 0; a < b.mesh.nodes; ++a) EXPECT_EQ(bits(a), 0u);
}

} // namespace
} // namespace swarf::test
