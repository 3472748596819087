// Whether a closed surface bounds each point of space once.
#include "src/geometry/facet_tree.hpp"
#include <cmath>
#include <fmt/format.h>

namespace swarf {
namespace {

using Point = Eigen::Vector3d;
constexpr double little = 1e-6;    // of the surface's diagonal: corners of STL files are that exact
constexpr double round_off = 1e-9; // of a facet

class PartsCheck {
 public:
  PartsCheck(const FacetSurface& of, const std::string& named)
      : surface(of), name(named), tree(make_facet_tree(of)) {
    for (int f = 0; f < facets(); ++f)
      for (int k = 0; k < 3; ++k) box.extend(corner(f, k));
    grain = little * box.diagonal().norm();
  }

  void run() const {
    for (int f = 0; f < facets(); ++f) look_for_cuts(f);
    for (int f = 0; f < facets(); ++f) look_out(f);
  }

 private:
  const FacetSurface& surface;
  std::string name;
  FacetTree tree;
  FacetTree::Box box;
  double grain = 0;

  int facets() const { return int(surface.facets.size()); }
  Point corner(int f, int k) const {
    return Eigen::Map<const Point>(
        surface.vertices[std::size_t(surface.facets[std::size_t(f)][std::size_t(k)])].data());
  }
  Point normal(int f) const { // unit
    return (corner(f, 1) - corner(f, 0)).cross(corner(f, 2) - corner(f, 0)).normalized();
  }
  bool has_corner(int f, int vertex) const {
    const auto& c = surface.facets[std::size_t(f)];
    return c[0] == vertex || c[1] == vertex || c[2] == vertex;
  }

  [[noreturn]] void refuse(int f, const Point& x, const std::string& what) const {
    throw DeckError(
        fmt::format("{}: facet {} {}, at ({:.6g}, {:.6g}, {:.6g}) m: expected a surface that bounds "
                    "one body; join the parts to one (a union in CAD), or move them apart",
                    name, f + 1, what, x.x(), x.y(), x.z()));
  }

  // Where the line from p along `way` meets the facet, in units of `way`; NaN: nowhere. Its sides belong to
  // it: edges often go through the middle of a square, where two facets meet.
  double meet(int f, const Point& p, const Point& way) const {
    const Point a = corner(f, 0), n = (corner(f, 1) - a).cross(corner(f, 2) - a);
    const double slope = n.dot(way);
    if (slope == 0) return NAN;
    const double t = n.dot(a - p) / slope;
    const Point x = p + t * way;
    for (int k = 0; k < 3; ++k) {
      const Point from = corner(f, k), to = corner(f, (k + 1) % 3);
      if (!((to - from).cross(x - from).dot(n) > -round_off * n.squaredNorm())) return NAN;
    }
    return t;
  }

  // Two facets cut each other where a side of one goes through the other, with its ends on both sides of it.
  void look_for_cuts(int f) const {
    FacetTree::Box own;
    for (int k = 0; k < 3; ++k) own.extend(corner(f, k));
    tree.search([&](const FacetTree::Box& other) { return other.intersects(own); },
                [](const FacetTree::Box&) { return 0.0; },
                [&](int g) {
                  if (g == f) return;
                  for (int k = 0; k < 3; ++k) cut(f, k, g);
                });
  }
  void cut(int f, int k, int g) const {
    const auto& c = surface.facets[std::size_t(f)];
    if (has_corner(g, c[std::size_t(k)]) || has_corner(g, c[std::size_t((k + 1) % 3)])) return;
    const Point p = corner(f, k), q = corner(f, (k + 1) % 3), n = normal(g);
    const double from = n.dot(p - corner(g, 0)), to = n.dot(q - corner(g, 0));
    if (!(from * to < 0) || std::min(std::abs(from), std::abs(to)) <= grain) return;
    const double t = meet(g, p, q - p);
    if (t > 0 && t < 1) refuse(f, p + t * (q - p), fmt::format("goes through facet {}", g + 1));
  }

  // A ray that leaves the middle of a facet outwards comes into the body as often as it leaves it. One that
  // hits a side of a facet is followed in another direction.
  void look_out(int f) const {
    const Point n = normal(f), middle = (corner(f, 0) + corner(f, 1) + corner(f, 2)) / 3;
    for (const Point& lean : {Point(0.1137, 0.0719, -0.0433), Point(-0.0911, 0.1273, 0.0517),
                              Point(0.0377, -0.1091, 0.1329), Point(-0.1213, -0.0571, -0.0883)}) {
      const auto inside = crossings(f, middle, (n + lean).normalized());
      if (!inside) continue;
      if (*inside != 0) refuse(f, middle, "lies in or on another part of the surface");
      return;
    }
  }

  // Leaving minus entering; nothing if it cannot be told.
  std::optional<int> crossings(int f, const Point& from, const Point& way) const {
    int sum = 0;
    bool is_clear = true;
    const auto enter = [&](const FacetTree::Box& other) { return ray_meets(other, from, way); };
    tree.search(
        enter, [](const FacetTree::Box&) { return 0.0; },
        [&](int g) {
          if (g == f) return;
          const Point a = corner(g, 0), cross = (corner(g, 1) - a).cross(corner(g, 2) - a);
          const double slope = cross.dot(way), t = cross.dot(a - from) / slope;
          if (slope == 0 || t <= -grain) return;
          double least = 1; // how far inside of the sides, as a share of the facet
          for (int k = 0; k < 3; ++k) {
            const Point p = corner(g, k), q = corner(g, (k + 1) % 3);
            least = std::min(least, (q - p).cross(from + t * way - p).dot(cross) / cross.squaredNorm());
          }
          if (std::abs(least) <= round_off) is_clear = false;
          if (least > 0) sum += slope > 0 ? 1 : -1;
        });
    return is_clear ? std::optional(sum) : std::nullopt;
  }

  static bool ray_meets(const FacetTree::Box& other, const Point& from, const Point& way) {
    double first = 0, last = INFINITY;
    const double margin = 1e-9 * other.diagonal().norm();
    for (int d = 0; d < 3; ++d) {
      const double a = (other.min()[d] - margin - from[d]) / way[d];
      const double b = (other.max()[d] + margin - from[d]) / way[d];
      first = std::max(first, std::min(a, b)), last = std::min(last, std::max(a, b));
    }
    return first <= last;
  }
};

} // namespace

void check_parts(const FacetSurface& surface, const std::string& name) { PartsCheck(surface, name).run(); }

} // namespace swarf
