// A block of hexes for tests: nx x ny x nz cells, each node moved by a map.
#pragma once
#include "swarf/hexes/hex8.hpp"

#include "support/points.hpp"

#include <array>
#include <functional>
#include <memory>
#include <random>
#include <vector>

namespace swarf::test {

using Cells = std::array<int, 3>;
using Point = std::array<double, 3>;

inline int block_node(const Cells& n, int i, int j, int k) { return i + (n[0] + 1) * (j + (n[1] + 1) * k); }

// map: position of the node at (i, j, k), m. Lumped mass: an eighth of the hex's to each corner.
inline HexMesh make_hex_block(const Cells& n, const Material& mat,
                              const std::function<Point(int, int, int)>& map) {
  HexMesh m;
  const int hexes = n[0] * n[1] * n[2];
  m.points = make_points(hexes, mat);
  m.nodes = (n[0] + 1) * (n[1] + 1) * (n[2] + 1);
  m.connectivity = View<int* [8]>("connectivity", hexes);
  m.volume = ScalarField("volume", hexes);
  m.share = ScalarField("share", hexes);
  Kokkos::deep_copy(m.share, Real(1));
  m.gradient = View<Real* [8][3]>("gradient", hexes);
  m.corner_force = View<Real* [8][3]>("corner_force", hexes);
  m.hourglass = View<Real* [4][3]>("hourglass", hexes);
  m.hourglass_work = ScalarField("hourglass_work", hexes);
  m.viscous_work = ScalarField("viscous_work", hexes);
  m.active = View<int*>("active", hexes);
  m.position = VectorField("position", m.nodes), m.velocity = VectorField("velocity", m.nodes);
  m.force = VectorField("force", m.nodes), m.mass = ScalarField("mass", m.nodes);
  m.external_work = ScalarField("external_work", m.nodes);
  m.constraints = View<unsigned*>("constraints", m.nodes);
  Kokkos::deep_copy(m.active, 1);

  auto connectivity = Kokkos::create_mirror_view(m.connectivity);
  auto position = Kokkos::create_mirror_view(m.position);
  auto mass = Kokkos::create_mirror_view(m.mass), hex_mass = Kokkos::create_mirror_view(m.points.mass);
  std::vector<std::vector<int>> corners(m.nodes);
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        const Point x = map(i, j, k);
        for (int d = 0; d < 3; ++d) position(block_node(n, i, j, k), d) = Real(x[d]);
      }
  for (int k = 0, e = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i, ++e) {
        HexVectors x;
        for (int a = 0; a < 8; ++a) {
          connectivity(e, a) = block_node(n, i + ((a + 1) / 2) % 2, j + (a / 2) % 2, k + a / 4);
          x.at[a] = load_vector(position, connectivity(e, a));
        }
        hex_mass(e) = mat.density * mean_gradient(x).volume;
        for (int a = 0; a < 8; ++a) {
          mass(connectivity(e, a)) += hex_mass(e) / 8;
          corners[connectivity(e, a)].push_back(8 * e + a);
        }
      }
  m.corner_start = IndexField("corner_start", m.nodes + 1);
  m.corner_of_node = IndexField("corner_of_node", 8 * hexes);
  auto start = Kokkos::create_mirror_view(m.corner_start);
  auto list = Kokkos::create_mirror_view(m.corner_of_node);
  int at = 0;
  for (int a = 0; a < m.nodes; ++a) {
    start(a) = at;
    for (const int c : corners[a]) list(at++) = c;
  }
  start(m.nodes) = at;
  Kokkos::deep_copy(m.connectivity, connectivity), Kokkos::deep_copy(m.position, position);
  Kokkos::deep_copy(m.mass, mass), Kokkos::deep_copy(m.points.mass, hex_mass),
      Kokkos::deep_copy(m.corner_start, start);
  Kokkos::deep_copy(m.corner_of_node, list);
  return m;
}

// Cubes of the given edge.
inline HexMesh make_hex_block(const Cells& n, const Material& mat, double edge) {
  return make_hex_block(n, mat, [=](int i, int j, int k) { return Point{edge * i, edge * j, edge * k}; });
}

// The same with every node inside and on the surface moved by up to `share` of an edge in each direction.
inline HexMesh make_distorted_block(const Cells& n, const Material& mat, double edge, double share) {
  auto random = std::make_shared<std::mt19937>(7);
  return make_hex_block(n, mat, [=](int i, int j, int k) {
    std::uniform_real_distribution<double> shift(-share * edge, share * edge);
    return Point{edge * i + shift(*random), edge * j + shift(*random), edge * k + shift(*random)};
  });
}

// field(a) = function of the node's position.
template <class Function>
void set_nodal(const VectorField& field, const VectorField& position, Function&& function) {
  auto host = Kokkos::create_mirror_view(field);
  const auto x = host_copy(position);
  for (std::size_t a = 0; a < x.extent(0); ++a) {
    const Point u = function(Point{double(x(a, 0)), double(x(a, 1)), double(x(a, 2))});
    for (int d = 0; d < 3; ++d) host(a, d) = Real(u[d]);
  }
  Kokkos::deep_copy(field, host);
}

// field(i, :) = row for all i of a TensorField, SymmetricField or VectorField.
template <class Field>
void set_rows(const Field& field, const std::vector<double>& row) {
  auto host = Kokkos::create_mirror_view(field);
  for (std::size_t i = 0; i < host.extent(0); ++i)
    for (std::size_t d = 0; d < row.size(); ++d) host(i, d) = Real(row[d]);
  Kokkos::deep_copy(field, host);
}

} // namespace swarf::test
