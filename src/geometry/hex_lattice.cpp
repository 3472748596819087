#include "src/geometry/body_file.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace swarf {
namespace {

using std::numbers::pi;
using Index = std::array<int, 3>;

Point origin_of(const BodyDeck& b) { return {b.origin[0], b.origin[1], b.origin[2]}; }

// --- block and ring: cells of a box of indices, a closed ring's first direction wraps
class Box {
 public:
  explicit Box(const Shape& s)
      : shape(s), nodes{s.cells[0] + (s.closed ? 0 : 1), s.cells[1] + 1, s.cells[2] + 1} {}

  HexSet fill() const {
    HexSet set;
    const auto names = shape.face_names();
    visit(nodes, [&](const Index& i) {
      const int row = int(set.node.size());
      for (int d = 0; d < 3; ++d) {
        if (i[d] == 0 && !names[d][0].empty()) set.faces[names[d][0]].push_back(row);
        if (i[d] == nodes[d] - 1 && !names[d][1].empty()) set.faces[names[d][1]].push_back(row);
      }
      set.node.push_back(shape.body->shape == BodyShape::block ? block_node(i) : ring_node(i));
    });
    visit(shape.cells, [&](const Index& i) {
      const auto [a, b, c] = i;
      set.hex.push_back({node(a, b, c), node(a + 1, b, c), node(a + 1, b + 1, c), node(a, b + 1, c),
                         node(a, b, c + 1), node(a + 1, b, c + 1), node(a + 1, b + 1, c + 1),
                         node(a, b + 1, c + 1)});
    });
    return set;
  }

 private:
  const Shape& shape;
  Index nodes;

  template <class Visit>
  static void visit(const Index& n, Visit&& call) {
    for (int i = 0; i < n[0]; ++i)
      for (int j = 0; j < n[1]; ++j)
        for (int k = 0; k < n[2]; ++k) call(Index{i, j, k});
  }
  int node(int a, int b, int c) const { return ((a % nodes[0]) * nodes[1] + b) * nodes[2] + c; }
  Point block_node(const Index& i) const {
    Point x = origin_of(*shape.body);
    for (int d = 0; d < 3; ++d) x[d] += shape.body->size[d] * i[d] / shape.cells[d];
    return x;
  }
  Point ring_node(const Index& i) const {
    const BodyDeck& b = *shape.body;
    const double angle = b.start_angle + (b.end_angle - b.start_angle) * i[0] / shape.cells[0];
    const double z = b.height * i[1] / shape.cells[1];
    const double inner = shape.inner(angle, b.origin[2] + z), outward = double(i[2]) / shape.cells[2];
    const double r = inner + (b.outer_radius - inner) * outward;
    return origin_of(b) + Point(r * std::cos(angle), r * std::sin(angle), z);
  }
};

// --- cylinder: quads of the disc, extruded
struct Disc {
  std::vector<Eigen::Vector2d> node;
  std::vector<std::array<int, 4>> quad; // counter-clockwise
  std::vector<bool> rim;
};

// Square to disc with equal angles along the sides (Shirley & Chiu 1997).
Eigen::Vector2d map_to_disc(double u, double v) {
  if (u == 0 && v == 0) return {0, 0};
  if (std::abs(u) >= std::abs(v)) return {u * std::cos(pi / 4 * v / u), u * std::sin(pi / 4 * v / u)};
  return {v * std::sin(pi / 4 * u / v), v * std::cos(pi / 4 * u / v)};
}

// `core` cells across the core, its sides half way between straight and round, corners at radius rho; `shell`
// layers from it to the rim.
Disc mesh_disc(int across, double radius) {
  const int shell = std::max(1, int(std::lround(across / 5.0))), core = across - 2 * shell, ring = 4 * core;
  const double bulge = 0.5, side = (1 - bulge) * std::numbers::sqrt2 / 2 + bulge;
  const double rho = radius * core / (across * side); // equal cells along the axes
  Disc disc;
  std::map<std::pair<int, int>, int> grid;
  for (int i = 0; i <= core; ++i)
    for (int j = 0; j <= core; ++j) {
      const double u = 2.0 * i / core - 1, v = 2.0 * j / core - 1;
      grid[{i, j}] = int(disc.node.size());
      disc.node.push_back(
          rho * ((1 - bulge) * std::numbers::sqrt2 / 2 * Eigen::Vector2d(u, v) + bulge * map_to_disc(u, v)));
    }
  for (int i = 0; i < core; ++i)
    for (int j = 0; j < core; ++j)
      disc.quad.push_back({grid[{i, j}], grid[{i + 1, j}], grid[{i + 1, j + 1}], grid[{i, j + 1}]});

  std::vector<int> last; // around the core, counter-clockwise from the corner at -135 degrees
  for (int t = 0; t < core; ++t) last.push_back(grid[{t, 0}]);
  for (int t = 0; t < core; ++t) last.push_back(grid[{core, t}]);
  for (int t = 0; t < core; ++t) last.push_back(grid[{core - t, core}]);
  for (int t = 0; t < core; ++t) last.push_back(grid[{0, core - t}]);
  const std::vector<int> border = last;
  for (int layer = 1; layer <= shell; ++layer) {
    std::vector<int> next;
    for (int t = 0; t < ring; ++t) {
      const double angle = -0.75 * pi + 2 * pi * t / ring, share = double(layer) / shell;
      next.push_back(int(disc.node.size()));
      disc.node.push_back((1 - share) * disc.node[border[t]] +
                          share * radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    for (int t = 0; t < ring; ++t) {
      const int s = (t + 1) % ring;
      disc.quad.push_back({last[t], next[t], next[s], last[s]});
    }
    last = next;
  }
  disc.rim.assign(disc.node.size(), false);
  for (int node : last) disc.rim[node] = true;
  return disc;
}

HexSet extrude(const Shape& shape) {
  const BodyDeck& b = *shape.body;
  const Disc disc = mesh_disc(shape.cells[0], b.radius);
  const int layer = int(disc.node.size()), layers = shape.cells[1];
  HexSet set;
  for (int j = 0; j <= layers; ++j)
    for (int n = 0; n < layer; ++n) {
      const int row = int(set.node.size());
      if (j == 0) set.faces["bottom"].push_back(row);
      if (j == layers) set.faces["top"].push_back(row);
      if (disc.rim[n]) set.faces["side"].push_back(row);
      set.node.push_back(origin_of(b) + Point(disc.node[n].x(), disc.node[n].y(), b.height * j / layers));
    }
  for (int j = 0; j < layers; ++j)
    for (const auto& q : disc.quad) {
      const int low = j * layer, high = low + layer;
      set.hex.push_back({low + q[0], low + q[1], low + q[2], low + q[3], high + q[0], high + q[1],
                         high + q[2], high + q[3]});
    }
  return set;
}

// --- hollow sphere: a block outward from each side of a cube
HexSet fill_shell(const Shape& shape) {
  const BodyDeck& b = *shape.body;
  const int n = shape.cells[0], layers = shape.cells[2];
  std::map<Index, int> surface; // place on the cube, 0..n each way -> row of nodes, layers + 1 of them
  HexSet set;
  const auto node = [&](const Index& place, int layer) {
    const auto [at, is_new] = surface.try_emplace(place, int(set.node.size()));
    if (is_new) {
      Point direction;
      for (int d = 0; d < 3; ++d) direction[d] = std::tan(pi / 4 * (2.0 * place[d] / n - 1));
      for (int k = 0; k <= layers; ++k) {
        const double r = b.inner_radius + (b.outer_radius - b.inner_radius) * k / layers;
        if (k == 0) set.faces["inner"].push_back(int(set.node.size()));
        if (k == layers) set.faces["outer"].push_back(int(set.node.size()));
        set.node.push_back(origin_of(b) + r * direction.normalized());
      }
    }
    return at->second + layer;
  };
  for (int side = 0; side < 6; ++side)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < layers; ++k) {
          const int d = side / 2, low = side % 2; // on the low side the two other axes change places
          const auto at = [&](int u, int v) {
            Index place{};
            place[d] = low ? 0 : n;
            place[(d + 1) % 3] = low ? v : u, place[(d + 2) % 3] = low ? u : v;
            return place;
          };
          const Index corner[4] = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
          std::array<int, 8> hex{};
          for (int c = 0; c < 4; ++c) hex[c] = node(corner[c], k), hex[c + 4] = node(corner[c], k + 1);
          set.hex.push_back(hex);
        }
  return set;
}

} // namespace

HexSet fill_hexes(const Shape& shape) {
  if (shape.body->shape == BodyShape::stl) return fill_hexes_of_stl(shape);
  if (shape.body->shape == BodyShape::mesh) return fill_hexes_of_mesh(shape);
  if (shape.body->shape == BodyShape::cylinder) return extrude(shape);
  if (shape.body->shape == BodyShape::sphere) return fill_shell(shape);
  return Box(shape).fill();
}

} // namespace swarf
