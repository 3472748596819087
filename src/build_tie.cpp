#include "src/build_tie.hpp"
#include "src/box_grid.hpp"
#include "src/isoparametric.hpp"
#include "src/upload.hpp"
#include "swarf/z_order.hpp"
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

// Finds the nearest of the faces that touch particles.
class FaceFinder {
 public:
  FaceFinder(const HexSet& set, std::vector<SurfaceQuad> faces, double radius)
      : hexes(set), quads(std::move(faces)), reach(radius), grid(make_boxes()) {}
  void find(TiedPoint& point) const {
    Best best;
    grid.find(point.position, [&](int q) { return improve(best, q, point.position), false; });
    // The cell lists all faces within reach; farther ones need a look at every face.
    if (best.at.distance > reach)
      for (int q = 0; q < int(quads.size()); ++q) improve(best, q, point.position);
    point.face_nodes = quads[best.quad].node;
    point.face_shape = best.at.shape;
  }

 private:
  struct Best {
    NearestOnQuad at{{}, std::numeric_limits<double>::infinity()};
    int quad = -1;
  };
  const HexSet& hexes;
  std::vector<SurfaceQuad> quads;
  double reach;
  BoxGrid grid;

  void improve(Best& best, int q, const Point& x) const {
    const NearestOnQuad at = nearest_on_quad(swarf::corners_of(hexes, quads[q]), x);
    if (at.distance < best.at.distance) best = {at, q};
  }
  std::vector<BoxGrid::Box> make_boxes() const {
    std::vector<BoxGrid::Box> boxes(quads.size());
    for (std::size_t q = 0; q < boxes.size(); ++q) {
      for (const Point& x : swarf::corners_of(hexes, quads[q])) boxes[q].extend(x);
      boxes[q].min().array() -= reach, boxes[q].max().array() += reach;
    }
    return boxes;
  }
};

// Weights of a linear field about the host's centre: a hex reaches from -1 to 1 in its own coordinates, the
// centres at its faces lie at -2 and 2; where one is missing the slope is one-sided.
void weigh_states(TiedPoint& point, const std::array<int, 6>& neighbors) {
  static constexpr int sign[3][8] = {
      {-1, 1, 1, -1, -1, 1, 1, -1}, {-1, -1, 1, 1, -1, -1, 1, 1}, {-1, -1, -1, -1, 1, 1, 1, 1}};
  point.state_hex.fill(point.host);
  point.state_weight = {1, 0, 0, 0, 0, 0, 0};
  for (int d = 0; d < 3; ++d) {
    double xi = 0;
    for (int a = 0; a < 8; ++a) xi += sign[d][a] * point.shape[a];
    const bool low = neighbors[2 * d] >= 0, high = neighbors[2 * d + 1] >= 0;
    if (!low && !high) continue;
    const double slope = xi / (low && high ? 4 : 2); // of the difference between the two that are there
    const int above = high ? 2 + 2 * d : 0, below = low ? 1 + 2 * d : 0;
    if (low) point.state_hex[1 + 2 * d] = neighbors[2 * d];
    if (high) point.state_hex[2 + 2 * d] = neighbors[2 * d + 1];
    point.state_weight[above] += slope, point.state_weight[below] -= slope;
  }
}

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
  const ZGrid grid{to_vector3(box.min()), Real(cell)};
  std::stable_sort(points.begin(), points.end(), [&](const TiedPoint& a, const TiedPoint& b) {
    return grid.key(to_vector3(a.position)) < grid.key(to_vector3(b.position));
  });
}

// -sum_j V x grad_x W over a cubic lattice of unit spacing, 1 in the continuum; h = ratio.
double first_moment(double ratio) {
  const int reach = int(std::ceil(2 * ratio));
  double sum = 0;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      for (int k = -reach; k <= reach; ++k) {
        const double q = std::sqrt(double(i * i + j * j + k * k)) / ratio;
        const double slope = q < 1 ? 2.25 * q - 3 : q < 2 ? -0.75 * (2 - q) * (2 - q) / q : 0; // cubic spline
        sum -= i * i * slope / (std::numbers::pi * std::pow(ratio, 5));
      }
  return sum;
}

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
  std::vector<TiedPoint> points;
  for (std::size_t k = 0; k < around.position.size(); ++k) {
    TiedPoint p;
    p.position = around.position[k], p.volume = around.volume[k], p.body = row;
    if (body.shape.signed_distance(p.position) > reach || belongs_to_other(bodies, row, p.position)) continue;
    if (finder.find(p)) points.push_back(p);
  }
  if (points.empty() || faces.empty())
    reject(deck, *body.deck, "tie",
           fmt::format("does not touch \"{}\": expected a common face. Move or enlarge one of the two",
                       host->deck->name));
  const auto neighbors = find_face_neighbors(host->hexes);
  const FaceFinder nearest(host->hexes, faces, 2 * layers * pitch);
  for (TiedPoint& p : points) {
    nearest.find(p);
    weigh_states(p, neighbors[p.host]);
    p.host += host->first_hex;
    for (int& hex : p.state_hex) hex += host->first_hex;
    for (int& node : p.face_nodes) node += host->first;
  }
  sort_along_curve(points, 2 * pitch);
  return points;
}

Tie make_tie(const std::vector<TiedPoint>& points, const ParticlesDeck& method) {
  Tie tie;
  const int n = tie.count = int(points.size());
  const bool corrected = method.correction && method.correct_forces;
  tie.correction = corrected ? Real(1 / first_moment(method.smoothing_ratio)) : Real(1);
  tie.host = upload<IndexField>("tie.host", n, [&](auto& f, int k) { f(k) = points[k].host; });
  tie.shape = upload<View<Real* [8]>>("tie.shape", n, [&](auto& f, int k) {
    for (int a = 0; a < 8; ++a) f(k, a) = Real(points[k].shape[a]);
  });
  tie.state_hex = upload<View<int* [7]>>("tie.state_hex", n, [&](auto& f, int k) {
    for (int m = 0; m < 7; ++m) f(k, m) = points[k].state_hex[m];
  });
  tie.state_weight = upload<View<Real* [7]>>("tie.state_weight", n, [&](auto& f, int k) {
    for (int m = 0; m < 7; ++m) f(k, m) = Real(points[k].state_weight[m]);
  });
  tie.face_nodes = upload<View<int* [4]>>("tie.face_nodes", n, [&](auto& f, int k) {
    for (int a = 0; a < 4; ++a) f(k, a) = points[k].face_nodes[a];
  });
  tie.face_shape = upload<View<Real* [4]>>("tie.face_shape", n, [&](auto& f, int k) {
    for (int a = 0; a < 4; ++a) f(k, a) = Real(points[k].face_shape[a]);
  });
  std::map<int, std::vector<int>> entries; // node -> 4 k + corner
  for (int k = 0; k < n; ++k)
    for (int a = 0; a < 4; ++a) entries[points[k].face_nodes[a]].push_back(4 * k + a);
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
