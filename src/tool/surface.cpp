#include "src/tool/surface.hpp"
#include "src/geometry/upload.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace swarf {
namespace {

constexpr std::size_t most_patches = 1'000'000;

// Triangles of a closed surface, halved at their longest edges. A longest edge that is shared is halved in
// both triangles at once, after the neighbour has been halved at its own as long as that is longer: edges
// only grow on the way, so it ends (Rivara 1984).
class PatchTree {
 public:
  explicit PatchTree(const FacetSurface& surface) : vertices(surface.vertices) {
    for (const auto& facet : surface.facets) add(facet);
  }

  struct Node {
    std::array<int, 3> corner;
    int child = -1, edge = 0; // the first of two, and the edge that was halved; -1: a patch
  };
  std::vector<Node> nodes;
  std::vector<Triple> vertices;

  double longest_of(int node) const { return std::sqrt(order_of(node, longest(node)).squared); }
  Eigen::Vector3d middle_of(int node) const {
    Eigen::Vector3d sum(0, 0, 0);
    for (const int v : nodes[std::size_t(node)].corner)
      sum += Eigen::Map<const Eigen::Vector3d>(vertices[std::size_t(v)].data());
    return sum / 3;
  }

  void halve(int node) {
    while (nodes[std::size_t(node)].child < 0) {
      int at = node, other = beyond(at, longest(at));
      while (!shares_longest(at, other)) at = other, other = beyond(at, longest(at));
      const int middle = middle_of_edge(at, longest(at));
      split(at, middle), split(other, middle);
    }
  }

 private:
  std::map<std::pair<int, int>, int> patch_of; // of each directed edge

  struct Order { // of edges, the same from both sides
    double squared;
    std::pair<int, int> ends;
    bool operator<(const Order& o) const {
      return squared < o.squared || (squared == o.squared && ends < o.ends);
    }
  };

  std::pair<int, int> edge(int node, int e) const {
    const auto& c = nodes[std::size_t(node)].corner;
    return {c[std::size_t(e)], c[std::size_t((e + 1) % 3)]};
  }
  Order order_of(int node, int e) const {
    const std::pair<int, int> ends = std::minmax(edge(node, e).first, edge(node, e).second);
    double squared = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double way = vertices[std::size_t(ends.second)][d] - vertices[std::size_t(ends.first)][d];
      squared += way * way;
    }
    return {squared, ends};
  }
  int longest(int node) const {
    int best = 0;
    for (const int e : {1, 2})
      if (order_of(node, best) < order_of(node, e)) best = e;
    return best;
  }
  int beyond(int node, int e) const {
    const auto [from, to] = edge(node, e);
    return patch_of.at({to, from});
  }
  bool shares_longest(int node, int other) const {
    return order_of(node, longest(node)).ends == order_of(other, longest(other)).ends;
  }
  void add(const std::array<int, 3>& corner) {
    nodes.push_back({corner});
    for (int e = 0; e < 3; ++e) patch_of[edge(int(nodes.size()) - 1, e)] = int(nodes.size()) - 1;
  }
  int middle_of_edge(int node, int e) {
    const auto [from, to] = order_of(node, e).ends;
    Triple middle;
    for (std::size_t d = 0; d < 3; ++d)
      middle[d] = 0.5 * (vertices[std::size_t(from)][d] + vertices[std::size_t(to)][d]);
    vertices.push_back(middle);
    return int(vertices.size()) - 1;
  }
  void split(int node, int middle) {
    const int e = longest(node);
    const auto c = nodes[std::size_t(node)].corner;
    const int a = c[std::size_t(e)], b = c[std::size_t((e + 1) % 3)], apex = c[std::size_t((e + 2) % 3)];
    patch_of.erase({a, b});
    nodes[std::size_t(node)].child = int(nodes.size()), nodes[std::size_t(node)].edge = e;
    add({a, middle, apex}), add({middle, b, apex});
  }
};

PatchTree grow(const FacetSurface& surface, const PatchPlan& plan) {
  for (double finest = 2 * plan.finest;; finest *= 2) {
    PatchTree tree(surface);
    for (std::size_t n = 0; n < tree.nodes.size() && tree.nodes.size() < 2 * most_patches; ++n) {
      if (tree.nodes[n].child >= 0) continue;
      const double edge = tree.longest_of(int(n));
      if (edge <= finest) continue;
      const double nearest = plan.distance_to_work(tree.middle_of(int(n))) - edge;
      if (edge > nearest / 4) tree.halve(int(n));
    }
    if (tree.nodes.size() < 2 * most_patches) return tree;
  }
}

struct Patch {
  Eigen::Vector3d middle, normal;
  double area;
};

Patch patch_of(const PatchTree& tree, int node) {
  const auto at = [&](int k) {
    const int vertex = tree.nodes[std::size_t(node)].corner[std::size_t(k)];
    return Eigen::Map<const Eigen::Vector3d>(tree.vertices[std::size_t(vertex)].data());
  };
  const Eigen::Vector3d n = 0.5 * (at(1) - at(0)).cross(at(2) - at(0));
  return {tree.middle_of(node), n.normalized(), n.norm()};
}

// Patches by the cell of their middle: neighbours within a cell's length are in 27 cells.
class PatchGrid {
 public:
  PatchGrid(const std::vector<Patch>& patches, double cell) : all(patches), length(cell) {
    for (std::size_t p = 0; p < all.size(); ++p) rows[key(all[p].middle)].push_back(int(p));
  }
  // Those that the face of a point in patch q covers, q among them, in order.
  std::vector<int> covered_from(int q) const {
    const Patch& from = all[std::size_t(q)];
    std::vector<int> found;
    const auto [i, j, k] = key(from.middle);
    for (long a = i - 1; a <= i + 1; ++a)
      for (long b = j - 1; b <= j + 1; ++b)
        for (long c = k - 1; c <= k + 1; ++c)
          if (const auto cell = rows.find({a, b, c}); cell != rows.end())
            for (const int p : cell->second) {
              const Patch& to = all[std::size_t(p)];
              const bool near = (to.middle - from.middle).norm() < length && to.normal.dot(from.normal) > 0;
              if (near || p == q) found.push_back(p);
            }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  using Key = std::array<long, 3>;
  Key key(const Eigen::Vector3d& x) const {
    return {std::lround(x[0] / length), std::lround(x[1] / length), std::lround(x[2] / length)};
  }
  const std::vector<Patch>& all;
  double length;
  std::map<Key, std::vector<int>> rows;
};

void add_spread(ToolSurface& s, const std::vector<Patch>& patches, double radius) {
  const PatchGrid grid(patches, radius);
  std::vector<std::vector<std::pair<int, double>>> taken(patches.size());
  for (std::size_t q = 0; q < patches.size(); ++q) {
    const std::vector<int> covered = grid.covered_from(int(q));
    double area = 0;
    for (const int p : covered) area += patches[std::size_t(p)].area;
    for (const int p : covered)
      taken[std::size_t(p)].push_back({int(q), patches[std::size_t(p)].area / area});
  }
  std::vector<int> start{0}, from;
  std::vector<double> share;
  for (const auto& row : taken) {
    for (const auto& [q, part] : row) from.push_back(q), share.push_back(part);
    start.push_back(int(from.size()));
  }
  s.spread_start = upload("spread_start", start), s.spread_from = upload("spread_from", from);
  s.spread_share = upload<ScalarField>("spread_share", int(share.size()),
                                       [&](auto& f, int k) { f(k) = Real(share[std::size_t(k)]); });
}

} // namespace

ToolSurface build_tool_surface(const FacetSurface& surface, const PatchPlan& plan) {
  const PatchTree tree = grow(surface, plan);
  ToolSurface s;
  std::vector<int> patch(tree.nodes.size(), -1), node;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n)
    if (tree.nodes[n].child < 0) patch[n] = int(node.size()), node.push_back(int(n));
  s.patches = int(node.size());
  std::vector<Patch> patches;
  for (const int n : node) patches.push_back(patch_of(tree, n));
  s.tree = upload<IndexField>("patch_tree", int(patch.size()), [&](auto& f, int n) {
    f(n) = patch[std::size_t(n)] < 0 ? tree.nodes[std::size_t(n)].child : -1 - patch[std::size_t(n)];
  });
  s.halved = upload<IndexField>("patch_halved", int(patch.size()),
                                [&](auto& f, int n) { f(n) = tree.nodes[std::size_t(n)].edge; });
  s.corner = upload<View<Real* [3][3]>>("patch_corner", s.patches, [&](auto& f, int p) {
    const auto& corner = tree.nodes[std::size_t(node[std::size_t(p)])].corner;
    for (int k = 0; k < 3; ++k)
      for (int d = 0; d < 3; ++d)
        f(p, k, d) = Real(tree.vertices[std::size_t(corner[std::size_t(k)])][std::size_t(d)]);
  });
  s.area = upload<ScalarField>("patch_area", s.patches,
                               [&](auto& f, int p) { f(p) = Real(patches[std::size_t(p)].area); });
  add_spread(s, patches, plan.finest);
  s.sums = View<Real* [surface_sums]>("patch_sums", s.patches);
  s.first = IndexField("patch_first", std::size_t(s.patches) + 1);
  return s;
}

} // namespace swarf
