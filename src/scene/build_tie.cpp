#include "src/scene/build_tie.hpp"
#include "src/geometry/box_grid.hpp"
#include "src/geometry/isoparametric.hpp"
#include "src/geometry/upload.hpp"
#include "swarf/core/cell_order.hpp"
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <numbers>

namespace swarf {
namespace {

std::array<Point, 8> corners_of(const HexSet& hexes, int hex) {
  std::array<Point, 8> x;
  for (int a = 0; a < 8; ++a) x[a] = hexes.node[hexes.hex[hex][a]];
  return x;
}

// Finds the hex that holds a point.
class HexFinder {
 public:
  explicit HexFinder(const HexSet& set) : hexes(set), grid(make_boxes(set)) {}
  bool find(TiedPoint& point) const {
    bool found = false;
    grid.find(point.position, [&](int hex) {
      const auto N = locate_in_hex(corners_of(hexes, hex), point.position);
      if (N) point.host = hex, point.shape = *N, found = true;
      return found;
    });
    return found;
  }

 private:
  const HexSet& hexes;
  BoxGrid grid;

  static std::vector<BoxGrid::Box> make_boxes(const HexSet& set) {
    std::vector<BoxGrid::Box> boxes(set.hex.size());
    for (std::size_t h = 0; h < boxes.size(); ++h)
      for (const Point& x : corners_of(set, int(h))) boxes[h].extend(x);
    // Points on a face belong to a hex in spite of round-off.
    for (BoxGrid::Box& b : boxes) b.min() -= 1e-9 * b.sizes(), b.max() += 1e-9 * b.sizes();
    return boxes;
  }
};

// Another body of particles is there, or is tied to the same hexes and nearer: its own lattice goes on there.
bool belongs_to_other(const std::vector<FilledBody>& bodies, int row, const Point& x) {
  const double own = bodies[row].shape.signed_distance(x);
  for (int b = 0; b < int(bodies.size()); ++b) {
    if (b == row || !bodies[b].has_particles()) continue;
    const double other = bodies[b].shape.signed_distance(x);
    const bool nearer = other < own || (other == own && b < row);
    if (other < 0 || (nearer && bodies[b].deck->tie == bodies[row].deck->tie)) return true;
  }
  return false;
}

void sort_along_curve(std::vector<TiedPoint>& points, double cell) {
  Eigen::AlignedBox3d box;
  for (const TiedPoint& p : points) box.extend(p.position);
  const CellGrid grid{to_vector3(box.min()), Real(cell)};
  const auto key = [&](const TiedPoint& p) {
    return hilbert_key(grid.index(to_vector3(p.position)), cell_bits);
  };
  std::stable_sort(points.begin(), points.end(),
                   [&](const TiedPoint& a, const TiedPoint& b) { return key(a) < key(b); });
}

// How the stress passes from a body of particles to its hexes: the tied particles' weight falls from 1 at the
// surface to 0 at the depth of the last whole layer within reach, that of the hexes rises as much. A step
// instead of the ramp lets hexes of one particle each move past their particles, and reflects pulses.
class Overlap {
 public:
  Overlap(const FilledBody& from, double reach) : body(from) {
    const double pitch = 2 * *std::min_element(body.points.gap.begin(), body.points.gap.end());
    depth = std::floor(reach / pitch + 0.5) * pitch;
  }
  double weight(const Point& x) const {
    return std::clamp(1 - body.shape.signed_distance(x) / depth, 0.0, 1.0);
  }

  // Mean weight over the hex, by the midpoints of a 6 x 6 x 6 division.
  double mean_weight(const std::array<Point, 8>& x) const {
    Point centre(0, 0, 0);
    double radius = 0;
    for (const Point& corner : x) centre += corner / 8;
    for (const Point& corner : x) radius = std::max(radius, (corner - centre).norm());
    if (body.shape.signed_distance(centre) - radius > depth) return 0;
    constexpr int n = 6;
    double sum = 0;
    for (int cell = 0; cell < n * n * n; ++cell) {
      const std::array<double, 3> xi{(cell % n + 0.5) / n, (cell / n % n + 0.5) / n,
                                     (cell / n / n + 0.5) / n};
      const auto edge = [&](int a, int b) -> Point { return (1 - xi[0]) * x[a] + xi[0] * x[b]; };
      const Point low = (1 - xi[1]) * edge(0, 1) + xi[1] * edge(3, 2);
      const Point high = (1 - xi[1]) * edge(4, 5) + xi[1] * edge(7, 6);
      sum += weight((1 - xi[2]) * low + xi[2] * high);
    }
    return sum / (n * n * n);
  }

 private:
  const FilledBody& body;
  double depth;
};

} // namespace

bool touches_particles(const HexSet& hexes, const SurfaceQuad& quad, const FilledBody& particles) {
  const auto x = corners_of(hexes, quad);
  const Point centre = 0.25 * (x[0] + x[1] + x[2] + x[3]);
  // Farther out than the chords of a mesh lie inside of its arcs.
  const Point step = 0.25 * particles.points.spacing * area_of(hexes, quad).normalized();
  if (particles.shape.signed_distance(centre + step) < 0) return true;
  return std::any_of(x.begin(), x.end(), [&](const Point& corner) {
    return particles.shape.signed_distance(0.5 * (centre + corner) + step) < 0;
  });
}

std::vector<TiedPoint> place_tied_points(const Deck& deck, const std::vector<FilledBody>& bodies, int row,
                                         double reach) {
  const FilledBody& body = bodies[row];
  const auto host = std::find_if(bodies.begin(), bodies.end(), [&](const FilledBody& b) {
    return b.deck->name == body.deck->tie && !b.has_particles();
  });
  if (host == bodies.end())
    reject(deck, *body.deck, "tie",
           fmt::format("is tied to \"{}\", which is no body of hexes", body.deck->tie));
  std::vector<SurfaceQuad> faces;
  for (const SurfaceQuad& quad : find_surface(host->hexes))
    if (touches_particles(host->hexes, quad, body)) faces.push_back(quad);

  const double pitch = 2 * *std::min_element(body.points.gap.begin(), body.points.gap.end());
  const int layers = int(std::ceil(reach / pitch));
  const PointSet around = continue_points(body.shape, layers);
  const HexFinder finder(host->hexes);
  const Overlap overlap(body, reach);
  std::vector<TiedPoint> points;
  for (std::size_t k = 0; k < around.position.size(); ++k) {
    TiedPoint p;
    p.position = around.position[k], p.body = row;
    p.volume = around.volume[k] * overlap.weight(p.position);
    if (p.volume > 0 && !belongs_to_other(bodies, row, p.position) && finder.find(p)) points.push_back(p);
  }
  if (points.empty() || faces.empty())
    reject(deck, *body.deck, "tie",
           fmt::format("does not touch \"{}\": expected a common face. Move or enlarge one of the two",
                       host->deck->name));
  for (TiedPoint& p : points) p.host += host->first_hex;
  sort_along_curve(points, 2 * pitch);
  return points;
}

std::vector<double> stress_shares(const std::vector<FilledBody>& bodies, double reach) {
  std::vector<double> shares;
  for (const FilledBody& host : bodies) {
    const std::size_t first = shares.size();
    shares.resize(first + host.hexes.hex.size(), 1);
    for (const FilledBody& body : bodies) {
      if (!body.has_particles() || body.deck->tie != host.deck->name) continue;
      const Overlap overlap(body, reach);
      for (std::size_t hex = 0; hex < host.hexes.hex.size(); ++hex)
        shares[first + hex] =
            std::min(shares[first + hex], 1 - overlap.mean_weight(corners_of(host.hexes, int(hex))));
    }
  }
  return shares;
}

Tie make_tie(const std::vector<TiedPoint>& points, const HexMesh& mesh) {
  Tie tie;
  const int n = tie.count = int(points.size());
  tie.host = upload<IndexField>("tie.host", n, [&](auto& f, int k) { f(k) = points[k].host; });
  tie.shape = upload<View<Real* [8]>>("tie.shape", n, [&](auto& f, int k) {
    for (int a = 0; a < 8; ++a) f(k, a) = Real(points[k].shape[a]);
  });
  const auto corner = host_copy(mesh.connectivity);
  std::map<int, std::vector<int>> entries; // node -> 8 k + corner
  for (int k = 0; k < n; ++k)
    for (int a = 0; a < 8; ++a) entries[corner(points[k].host, a)].push_back(8 * k + a);
  std::vector<int> nodes, start{0}, entry;
  for (const auto& [node, of_node] : entries) {
    nodes.push_back(node);
    entry.insert(entry.end(), of_node.begin(), of_node.end());
    start.push_back(int(entry.size()));
  }
  tie.row_node = upload("tie.row_node", nodes);
  tie.start = upload("tie.start", start);
  tie.entry = upload("tie.entry", entry);
  return tie;
}

} // namespace swarf
