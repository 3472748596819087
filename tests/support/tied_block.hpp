// A disordered block of hexes with tied particles in it.
#pragma once
#include "support/hex_block.hpp"
#include "support/materials.hpp"
#include "support/particle_block.hpp"

namespace swarf::test {

struct TiedBlock {
  HexMesh hexes;
  Particles particles;
  Tie tie;
};

inline double random_unit(std::mt19937& random) {
  return std::uniform_real_distribution<double>(-1, 1)(random);
}

// 5 particles, and `tied` tied ones at random places, as many in each hex; hexes of 10 um.
inline TiedBlock make_tied_block(const Cells& cells, int tied) {
  TiedBlock b;
  b.hexes = make_distorted_block(cells, ti64(), 10e-6, 0.2);
  b.particles.count = 5, b.particles.tied = tied;
  b.particles.points.count = b.particles.stored = b.particles.total = 5 + tied;
  b.particles.whole = 5;
  allocate(b.particles, 5 + tied);
  b.tie.count = tied;
  b.tie.host = IndexField("host", tied), b.tie.shape = View<Real* [8]>("shape", tied);
  const auto host = host_copy(b.tie.host);
  const auto hex = host_copy(b.hexes.connectivity);
  const auto shape = host_copy(b.tie.shape);
  std::mt19937 random(3);
  std::vector<std::vector<int>> entries(b.hexes.nodes);
  for (int k = 0; k < tied; ++k) {
    host(k) = int(long(k) * b.hexes.points.count / tied);
    const double u = random_unit(random), v = random_unit(random), w = random_unit(random);
    const double low[4] = {(1 - u) * (1 - v) / 4, (1 + u) * (1 - v) / 4, (1 + u) * (1 + v) / 4,
                           (1 - u) * (1 + v) / 4};
    for (int a = 0; a < 4; ++a)
      shape(k, a) = Real(low[a] * (1 - w) / 2), shape(k, a + 4) = Real(low[a] * (1 + w) / 2);
    for (int a = 0; a < 8; ++a) entries[hex(host(k), a)].push_back(8 * k + a);
  }
  std::vector<int> nodes, start{0}, entry;
  for (int node = 0; node < b.hexes.nodes; ++node) {
    const std::vector<int>& list = entries[node];
    if (list.empty()) continue;
    nodes.push_back(node), entry.insert(entry.end(), list.begin(), list.end());
    start.push_back(int(entry.size()));
  }
  const auto upload = [](IndexField& field, const std::vector<int>& values) {
    field = IndexField("index", values.size());
    const auto f = Kokkos::create_mirror_view(field);
    for (std::size_t i = 0; i < values.size(); ++i) f(i) = values[i];
    Kokkos::deep_copy(field, f);
  };
  upload(b.tie.row_node, nodes), upload(b.tie.start, start), upload(b.tie.entry, entry);
  Kokkos::deep_copy(b.tie.host, host), Kokkos::deep_copy(b.tie.shape, shape);
  const auto identity = host_copy(b.particles.identity);
  for (int i = 0; i < 5 + tied; ++i) identity(i) = i;
  Kokkos::deep_copy(b.particles.identity, identity);
  b.tie.row = IndexField("row", tied);
  find_tied_rows(b.tie, b.particles);
  return b;
}

} // namespace swarf::test
