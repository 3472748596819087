#include "swarf/kernels.hpp"

#include "support/hex_block.hpp"
#include "support/materials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace swarf {
namespace {

struct Row {
  int master, slave, transform;
};

HexMesh make_coupled(const std::vector<Row>& rows) {
  HexMesh mesh = test::make_hex_block({2, 2, 1}, test::elastic_solid(1, 1, 1), 1);
  mesh.coupled_nodes = View<int* [3]>("coupled_nodes", rows.size());
  auto host = Kokkos::create_mirror_view(mesh.coupled_nodes);
  for (std::size_t k = 0; k < rows.size(); ++k)
    host(k, 0) = rows[k].master, host(k, 1) = rows[k].slave, host(k, 2) = rows[k].transform;
  Kokkos::deep_copy(mesh.coupled_nodes, host);
  auto force = host_copy(mesh.force), velocity = host_copy(mesh.velocity);
  for (int a = 0; a < mesh.nodes; ++a)
    for (int d = 0; d < 3; ++d)
      force(a, d) = Real(std::cos(3 * a + d)), velocity(a, d) = Real(std::sin(3 * a + d));
  Kokkos::deep_copy(mesh.force, force), Kokkos::deep_copy(mesh.velocity, velocity);
  return mesh;
}

TransformTable make_table(const std::vector<Tensor3>& rotations) {
  TransformTable table("transforms", rotations.size());
  auto host = Kokkos::create_mirror_view(table);
  for (std::size_t k = 0; k < rotations.size(); ++k) host(k) = {rotations[k], {0, 0, 0}};
  Kokkos::deep_copy(table, host);
  return table;
}

// Sector of 60 degrees: slave = R master. The pair's force, seen in the master's frame, is the sum of both
// shares, half of it at each node; other nodes keep theirs.
TEST(CoupleNodes, TurnedPairSharesItsForceAndItsVelocity) {
  const Real c = Real(0.5), s = Real(std::sqrt(0.75));
  const Tensor3 R{c, -s, 0, s, c, 0, 0, 0, 1};
  const HexMesh mesh = make_coupled({{0, 2, 0}});
  couple_nodes(mesh, make_table({R}), true);
  const auto force = host_copy(mesh.force);
  const Vector3 master{Real(std::cos(0.)), Real(std::cos(1.)), Real(std::cos(2.))};
  const Vector3 slave{Real(std::cos(6.)), Real(std::cos(7.)), Real(std::cos(8.))};
  const Vector3 sum = master + multiply(transpose(R), slave);
  const Vector3 now = load_vector(force, 0), image = multiply(R, now);
  EXPECT_LT(norm(now - Real(0.5) * sum), test::round_off);
  EXPECT_LT(norm(image - load_vector(force, 2)), test::round_off);
  EXPECT_EQ(force(1, 0), Real(std::cos(3)));

  couple_nodes(mesh, make_table({R}), false);
  const auto velocity = host_copy(mesh.velocity);
  const Vector3 turned = multiply(R, load_vector(velocity, 0));
  EXPECT_LT(norm(turned - load_vector(velocity, 2)), test::round_off);
  EXPECT_EQ(velocity(0, 1), Real(std::sin(1)));
  EXPECT_EQ(velocity(1, 1), Real(std::sin(4)));
}

// Periodic in x and in y: the four nodes on an edge of the block are one. Each gets a quarter of their sum,
// all get one velocity, and the total force, which is what moves the body, is that before the coupling.
TEST(CoupleNodes, NodesOfTwoPeriodicDirectionsAreOne) {
  const test::Cells n{2, 2, 1};
  std::vector<Row> rows;
  for (int k = 0; k <= 1; ++k) {
    for (int j = 0; j <= 2; ++j)
      rows.push_back({test::block_node(n, 0, j, k), test::block_node(n, 2, j, k), 0});
    for (int i = 0; i <= 2; ++i)
      rows.push_back({test::block_node(n, i, 0, k), test::block_node(n, i, 2, k), 1});
  }
  const HexMesh mesh = make_coupled(rows);
  double before[3] = {}, after[3] = {};
  Vector3 corners{0, 0, 0};
  const auto start = host_copy(mesh.force);
  for (int a = 0; a < mesh.nodes; ++a)
    for (int d = 0; d < 3; ++d) before[d] += start(a, d);
  const int edge[4] = {test::block_node(n, 0, 0, 0), test::block_node(n, 2, 0, 0),
                       test::block_node(n, 0, 2, 0), test::block_node(n, 2, 2, 0)};
  for (const int a : edge) corners = corners + load_vector(start, a);
  const TransformTable table = make_table({identity3(), identity3()});
  couple_nodes(mesh, table, true), couple_nodes(mesh, table, false);
  const auto force = host_copy(mesh.force), velocity = host_copy(mesh.velocity);
  for (int a = 0; a < mesh.nodes; ++a)
    for (int d = 0; d < 3; ++d) after[d] += force(a, d);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(after[d], before[d], 10 * test::round_off);
  for (const int a : edge) {
    EXPECT_LT(norm(load_vector(force, a) - Real(0.25) * corners), test::round_off);
    EXPECT_LT(norm(load_vector(velocity, a) - load_vector(velocity, edge[0])), test::round_off);
  }
}

} // namespace
} // namespace swarf
