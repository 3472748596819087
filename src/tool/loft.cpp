// Closed surfaces from a plane section: caps by ear clipping, sides by quads cut along the shorter diagonal.
#include "src/tool/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swarf {
namespace {

using Point = std::array<double, 2>;

double twice_area(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
double squared(const Point& a, const Point& b) { return std::pow(b[0] - a[0], 2) + std::pow(b[1] - a[1], 2); }

// Twice the area over the longest side squared: 0.87 for an equilateral triangle, <= 0 for a reflex corner.
double shape(const Point& a, const Point& b, const Point& c) {
  return twice_area(a, b, c) / std::max({squared(a, b), squared(b, c), squared(c, a)});
}

bool holds(const Point& a, const Point& b, const Point& c, const Point& p) {
  return twice_area(a, b, p) >= 0 && twice_area(b, c, p) >= 0 && twice_area(c, a, p) >= 0;
}

bool is_ear(const Section& s, const std::vector<int>& ring, int k) {
  const int n = int(ring.size()), before = (k + n - 1) % n, after = (k + 1) % n;
  for (int j = 0; j < n; ++j)
    if (j != before && j != k && j != after && holds(s[ring[before]], s[ring[k]], s[ring[after]], s[ring[j]]))
      return false;
  return true;
}

bool crosses(const Point& a, const Point& b, const Point& c, const Point& d) {
  return twice_area(a, b, c) * twice_area(a, b, d) <= 0 && twice_area(c, d, a) * twice_area(c, d, b) <= 0;
}

void require_simple(const Section& s) {
  const int n = int(s.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && crosses(s[i], s[i + 1], s[j], s[(j + 1) % n]))
        throw DeckError(
            "tool: the section crosses itself: its angles, edge radius and core do not fit together; "
            "take a smaller rake, clearance, edge_radius or core_ratio");
}

} // namespace

// The best-shaped ear first, so that long thin facets are rare.
std::vector<std::array<int, 3>> triangulate(const Section& s) {
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> ring(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) ring[i] = int(i);
  while (ring.size() >= 3) {
    const int n = int(ring.size());
    int best = -1;
    double best_shape = 0;
    for (int k = 0; k < n; ++k) {
      const double quality = shape(s[ring[(k + n - 1) % n]], s[ring[k]], s[ring[(k + 1) % n]]);
      if (quality > best_shape && is_ear(s, ring, k)) best = k, best_shape = quality;
    }
    if (best < 0) throw DeckError("tool: the section cannot be closed by facets; is it wound clockwise?");
    triangles.push_back({ring[(best + n - 1) % n], ring[best], ring[(best + 1) % n]});
    ring.erase(ring.begin() + best);
  }
  return triangles;
}

FacetSurface loft(const Section& section, const std::vector<Layer>& layers) {
  require_simple(section);
  FacetSurface surface;
  const int n = int(section.size()), top = int(layers.size()) - 1;
  for (const Layer& layer : layers) {
    const double c = std::cos(layer.angle), s = std::sin(layer.angle);
    for (const Point& p : section)
      surface.vertices.push_back({c * p[0] - s * p[1], s * p[0] + c * p[1], layer.z});
  }
  for (const auto& [a, b, c] : triangulate(section)) {
    surface.facets.push_back({a, c, b});
    surface.facets.push_back({top * n + a, top * n + b, top * n + c});
  }
  const auto length = [&](int a, int b) {
    const Triple &p = surface.vertices[a], &q = surface.vertices[b];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  for (int l = 0; l < top; ++l)
    for (int i = 0; i < n; ++i) {
      const int a = l * n + i, b = l * n + (i + 1) % n, c = b + n, d = a + n;
      const bool rising = length(a, c) <= length(b, d);
      surface.facets.push_back(rising ? std::array{a, b, c} : std::array{a, b, d});
      surface.facets.push_back(rising ? std::array{a, c, d} : std::array{b, c, d});
    }
  return surface;
}

Section round_edge(Point centre, double radius, double from, double middle, double to) {
  if (radius == 0) return {centre};
  const double widest = std::min(5 * std::numbers::pi / 180, (to - from) / 12);
  Section points;
  const auto add_part = [&](double begin, double end, bool with_end) {
    const int parts = int(std::ceil((end - begin) / widest));
    for (int k = 0; k < parts + with_end; ++k) {
      const double angle = begin + (end - begin) * k / parts;
      points.push_back({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
    }
  };
  add_part(from, middle, false);
  add_part(middle, to, true);
  return points;
}

} // namespace swarf
