// Cells of heat in a row along x, as a tool that is a bar would have: the tree finds each, one layer of
// squares.
#pragma once
#include "swarf/tool/tool_heat.hpp"
#include <limits>

namespace swarf::test {

// 2^levels cells of unit volume, capacity and conductivity, at temperature 0; the bar lies along x from 0,
// and what is beside it in y shows its cells, too.
inline ToolHeat make_tool_bar(int levels, int most_points = 0) {
  ToolHeat t;
  t.cells = 1 << levels;
  t.conductivity = 1, t.size = Real(t.cells), t.finest = 1, t.one_layer = true;
  const auto field = [&](const char* name) { return ScalarField(name, std::size_t(t.cells)); };
  t.capacity = field("capacity"), t.temperature = field("temperature"), t.depth = field("depth");
  t.heat = field("heat"), t.out = field("out");
  Kokkos::deep_copy(t.capacity, Real(1)), Kokkos::deep_copy(t.depth, Real(0.5));
  const int links = 2 * (t.cells - 1);
  t.start = IndexField("start", std::size_t(t.cells) + 1),
  t.neighbor = IndexField("neighbor", std::size_t(links));
  t.conductance = ScalarField("conductance", std::size_t(links));
  Kokkos::deep_copy(t.conductance, Real(1));
  const auto start = host_copy(t.start), neighbor = host_copy(t.neighbor);
  int at = 0;
  for (int c = 0; c < t.cells; ++c) {
    start(c) = at;
    if (c > 0) neighbor(at++) = c - 1;
    if (c + 1 < t.cells) neighbor(at++) = c + 1;
  }
  start(t.cells) = at;
  Kokkos::deep_copy(t.start, start), Kokkos::deep_copy(t.neighbor, neighbor);
  // Level l has 2^l squares side by side; the two upper children of each are the lower ones again.
  std::vector<int> tree(1);
  std::vector<int> level{0};
  for (int l = 0; l < levels; ++l) {
    std::vector<int> next;
    for (const int node : level) {
      tree[std::size_t(node)] = int(tree.size());
      for (int k = 0; k < 4; ++k) {
        if (k < 2) next.push_back(int(tree.size()));
        tree.push_back(0);
      }
    }
    level = next;
  }
  for (int c = 0; c < t.cells; ++c) tree[std::size_t(level[std::size_t(c)])] = -1 - c;
  for (std::size_t n = 0; n < tree.size(); ++n)
    if (tree[n] == 0) tree[n] = -1; // beside the bar
  t.tree = IndexField("tree", tree.size());
  const auto host = host_copy(t.tree);
  for (std::size_t n = 0; n < tree.size(); ++n) host(n) = tree[n];
  Kokkos::deep_copy(t.tree, host);
  t.first = IndexField("first", std::size_t(t.cells) + 1),
  t.source = IndexField("source", std::size_t(most_points));
  return t;
}

inline void hold_cell(const ToolHeat& t, int cell) {
  const auto C = host_copy(t.capacity);
  C(cell) = std::numeric_limits<Real>::infinity();
  Kokkos::deep_copy(t.capacity, C);
}

} // namespace swarf::test
