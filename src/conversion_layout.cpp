#include "src/hex_conversion.hpp"
#include "swarf/cell_order.hpp"
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

// Finds the nearest of a set of points within a range.
class NearestPoint {
 public:
  NearestPoint(std::vector<Point> set, double within) : points(std::move(set)), range(within) {
    Point low(1e300, 1e300, 1e300);
    for (const Point& x : points) low = low.cwiseMin(x);
    grid = {to_vector3(Point(low - Point::Constant(range))), Real(range)};
    for (std::size_t k = 0; k < points.size(); ++k) keys.emplace_back(key(points[k], 0, 0), int(k));
    std::sort(keys.begin(), keys.end());
  }
  double distance(const Point& x) const { // at most the range
    double least = range * range;
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j) {
        const CellKey middle = key(x, j, k);
        auto at = std::lower_bound(keys.begin(), keys.end(), std::pair(middle > 0 ? middle - 1 : 0, -1));
        for (; at != keys.end() && at->first <= middle + 1; ++at)
          least = std::min(least, (points[std::size_t(at->second)] - x).squaredNorm());
      }
    return std::sqrt(least);
  }

 private:
  std::vector<Point> points;
  double range;
  CellGrid grid;
  std::vector<std::pair<CellKey, int>> keys;
  CellKey key(const Point& x, int j, int k) const {
    return row_key(grid.index(to_vector3(Point(x + range * Point(0, j, k)))));
  }
};

// Adds the points' images across periodic faces.
void add_images(std::vector<Point>& points, const Faces& faces) {
  for (const Transform& map : faces.transforms) {
    const std::size_t own = points.size();
    const Tensor3 R = transpose(map.R);
    const Transform back{R, Real(-1) * multiply(R, map.t)};
    for (std::size_t k = 0; k < own; ++k) {
      points.push_back(apply_to(map, points[k])), points.push_back(apply_to(back, points[k]));
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
  std::vector<Point> front;
  for (int e = 0; e < int(of.hex.size()); ++e)
    if (behind[std::size_t(e)] && converted[std::size_t(e)] && of.body[std::size_t(e)] == body)
      for (int c = 0; c < of.cells_of(e); ++c) front.push_back(of.place(e, c));
  if (front.empty()) return;
  add_images(front, of.faces);
  const NearestPoint nearest(std::move(front), depth + lattice.spacing);
  for (int e = 0; e < int(of.hex.size()); ++e) {
    if (!rest[std::size_t(e)] || of.body[std::size_t(e)] != body) continue;
    double sum = 0;
    const int cells = of.cells_of(e);
    for (int c = 0; c < cells; ++c) {
      const double d = nearest.distance(of.place(e, c)) - 0.5 * lattice.spacing;
      const double weight = std::clamp(1 - d / depth, 0.0, 1.0);
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
