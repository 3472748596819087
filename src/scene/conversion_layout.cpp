#include "src/scene/hex_conversion.hpp"
#include "swarf/core/cell_order.hpp"
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace swarf {
namespace {

Point apply_to(const Transform& map, const Point& x) {
  const Vector3 y = apply(map, to_vector3(x));
  return {double(y.x), double(y.y), double(y.z)};
}

// Marks the hexes that share a node with a marked one, `rings` times; periodic faces are no border.
std::vector<bool> grow(const HexConversion& of, std::vector<bool> marked, int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<bool> touched(of.node.size(), false);
    for (std::size_t e = 0; e < of.hex.size(); ++e)
      if (marked[e])
        for (int node : of.hex[e]) touched[std::size_t(of.one_of_pair[std::size_t(node)])] = true;
    for (std::size_t a = 0; a < touched.size(); ++a)
      if (touched[a])
        for (int k = of.hex_start[a]; k < of.hex_start[a + 1]; ++k)
          marked[std::size_t(of.hex_at[std::size_t(k)])] = true;
  }
  return marked;
}

// Where a particle's share of its hex lies.
struct Brick {
  Point centre;
  Eigen::Matrix3d axes; // unit, in columns
  Point half;           // edges
  double distance(const Point& x) const {
    return ((axes.transpose() * (x - centre)).cwiseAbs() - half).cwiseMax(0.0).norm();
  }
};

Brick brick_of(const HexConversion& of, int e, int c) {
  const auto& hex = of.hex[std::size_t(e)];
  const int n = of.lattice[std::size_t(of.body[std::size_t(e)])].n;
  Brick brick{of.place(e, c), Eigen::Matrix3d::Identity(), Point::Zero()};
  const int to[3] = {1, 3, 4};
  for (int d = 0; d < 3; ++d) {
    const Point edge = of.node[std::size_t(hex[std::size_t(to[d])])] - of.node[std::size_t(hex[0])];
    brick.axes.col(d) = edge.normalized(), brick.half[d] = 0.5 * edge.norm() / n;
  }
  return brick;
}

// Finds the nearest of a set of bricks within a range.
class NearestBrick {
 public:
  NearestBrick(std::vector<Brick> set, double within) : bricks(std::move(set)), range(within) {
    Point low = Point::Constant(1e300);
    double radius = 0;
    for (const Brick& b : bricks) low = low.cwiseMin(b.centre), radius = std::max(radius, b.half.norm());
    cell = range + radius;
    grid = {to_vector3(Point(low - Point::Constant(cell))), Real(cell)};
    for (std::size_t k = 0; k < bricks.size(); ++k) keys.emplace_back(key(bricks[k].centre, 0, 0), int(k));
    std::sort(keys.begin(), keys.end());
  }
  double distance(const Point& x) const { // at most the range
    double least = range;
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j) {
        const CellKey middle = key(x, j, k);
        auto at = std::lower_bound(keys.begin(), keys.end(), std::pair(middle > 0 ? middle - 1 : 0, -1));
        for (; at != keys.end() && at->first <= middle + 1; ++at)
          least = std::min(least, bricks[std::size_t(at->second)].distance(x));
      }
    return least;
  }

 private:
  std::vector<Brick> bricks;
  double range, cell = 0;
  CellGrid grid;
  std::vector<std::pair<CellKey, int>> keys;
  CellKey key(const Point& x, int j, int k) const {
    return row_key(grid.index(to_vector3(Point(x + cell * Point(0, j, k)))));
  }
};

// Adds the bricks' images across periodic faces.
void add_images(std::vector<Brick>& bricks, const Faces& faces) {
  for (const Transform& map : faces.transforms) {
    const std::size_t own = bricks.size();
    for (std::size_t k = 0; k < own; ++k)
      for (const Transform& to : {map, inverse(map)}) {
        Brick image = bricks[k];
        image.centre = apply_to(to, image.centre);
        for (int d = 0; d < 3; ++d) image.axes.col(d) = apply_to({to.R, {0, 0, 0}}, image.axes.col(d));
        bricks.push_back(image);
      }
  }
}

using Cell = ConversionLayout::Cell;

// How the stress passes from particles to hexes, as where the scene is built with both (build_tie.cpp): the
// weight of the tied particles falls from 1 at the converted hexes to 0 at the last whole layer within reach.
void tie_body(const HexConversion& of, const std::vector<bool>& converted, int body, ConversionLayout& out) {
  const HexConversion::Lattice& lattice = of.lattice[std::size_t(body)];
  const double depth = std::floor(of.reach / lattice.spacing + 0.5) * lattice.spacing;
  const int rings = int(std::ceil(depth / lattice.spacing / lattice.n)) + 1;
  const std::vector<bool> near = grow(of, converted, rings);
  std::vector<bool> rest(near);
  for (std::size_t e = 0; e < rest.size(); ++e) rest[e] = near[e] && !converted[e];
  const std::vector<bool> behind = grow(of, rest, rings);
  std::vector<Brick> front;
  for (int e = 0; e < int(of.hex.size()); ++e)
    if (behind[std::size_t(e)] && converted[std::size_t(e)] && of.body[std::size_t(e)] == body)
      for (int c = 0; c < of.cells_of(e); ++c) front.push_back(brick_of(of, e, c));
  if (front.empty()) return;
  add_images(front, of.faces);
  const NearestBrick nearest(std::move(front), depth);
  for (int e = 0; e < int(of.hex.size()); ++e) {
    if (!rest[std::size_t(e)] || of.body[std::size_t(e)] != body) continue;
    double sum = 0;
    const int cells = of.cells_of(e);
    for (int c = 0; c < cells; ++c) {
      const double weight = std::clamp(1 - nearest.distance(of.place(e, c)) / depth, 0.0, 1.0);
      if (weight > 0) out.tied.push_back({e, c, weight});
      sum += weight;
    }
    out.share[std::size_t(e)] = 1 - sum / cells;
  }
}

void sort_along_curve(const HexConversion& of, std::vector<Cell>& cells) {
  if (cells.empty()) return;
  Point low(1e300, 1e300, 1e300);
  double spacing = 1e300;
  std::vector<Point> place;
  for (const Cell& c : cells) {
    place.push_back(of.place(c.hex, c.cell)), low = low.cwiseMin(place.back());
    spacing = std::min(spacing, of.lattice[std::size_t(of.body[std::size_t(c.hex)])].spacing);
  }
  const CellGrid grid{to_vector3(low), Real(2 * spacing)};
  std::vector<std::pair<CellKey, int>> order;
  for (int k = 0; k < int(cells.size()); ++k)
    order.emplace_back(hilbert_key(grid.index(to_vector3(place[std::size_t(k)])), cell_bits), k);
  std::sort(order.begin(), order.end());
  std::vector<Cell> sorted;
  for (const auto& entry : order) sorted.push_back(cells[std::size_t(entry.second)]);
  cells = std::move(sorted);
}

} // namespace

int ConversionLayout::converted() const {
  int sum = 0; // each has one cell of number 0
  for (const Cell& c : free) sum += c.cell == 0 ? 1 : 0;
  return sum;
}

ConversionLayout lay_out(const HexConversion& of, const std::vector<bool>& converted) {
  ConversionLayout out;
  out.share.assign(of.hex.size(), 1);
  out.node_mass.assign(of.node.size(), 0), out.contact_area.assign(of.node.size(), 0);
  for (int e = 0; e < int(of.hex.size()); ++e) {
    if (converted[std::size_t(e)]) {
      out.share[std::size_t(e)] = 0;
      for (int c = 0; c < of.cells_of(e); ++c) out.free.push_back({e, c, 1});
    } else {
      for (int node : of.hex[std::size_t(e)]) out.node_mass[std::size_t(node)] += of.mass[std::size_t(e)] / 8;
    }
  }
  for (int body = 0; body < int(of.lattice.size()); ++body)
    if (of.lattice[std::size_t(body)].n > 0) tie_body(of, converted, body, out);
  sort_along_curve(of, out.tied);
  share_masses(out.node_mass, of.faces);
  for (const FreeQuad& quad : of.quads)
    if (!converted[std::size_t(quad.hex)])
      for (int node : quad.node) out.contact_area[std::size_t(node)] += 0.25 * quad.area;
  return out;
}

} // namespace swarf
