// Decks of tools, and the exact distance from a surface, in another way than the code's: winding number and
// projections, over all facets, in long double.
#pragma once
#include "src/tool/geometry.hpp"
#include "tests/src/scene_decks.hpp"

#include <algorithm>
#include <cmath>

namespace swarf::test {

inline constexpr double coarse = sizeof(Real) == 8 ? 1 : 1e7; // float against double

inline ToolDeck make_mill(int flutes = 2) { // Demiral & Mamedov (2022); angles and core assumed
  ToolDeck t(ToolKind::end_mill);
  t.diameter = 800e-6, t.flutes = flutes, t.helix = 25.2 * degree, t.rake = 5 * degree;
  t.clearance = 10 * degree, t.edge_radius = 6e-6, t.length = 150e-6, t.core_ratio = 0.5;
  return t;
}
inline ToolDeck make_wedge_deck() { // the orthogonal cut of Ti-6Al-4V: rake 15, clearance 2 deg, edge 20 um
  ToolDeck t(ToolKind::wedge);
  t.rake = 15 * degree, t.clearance = 2 * degree, t.edge_radius = 20e-6, t.width = 60e-6;
  t.height = 300e-6;
  return t;
}
inline ToolDeck make_wall_deck() {
  ToolDeck t(ToolKind::wall);
  t.normal = {1, 2, -2}, t.size = 1e-3;
  return t;
}

// An octahedron, its facets divided into four so many times and its corners moved onto the sphere.
inline FacetSurface make_sphere(double radius, int halvings) {
  FacetSurface s;
  s.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  s.facets = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int h = 0; h < halvings; ++h) {
    std::vector<std::array<int, 3>> finer;
    for (const auto& f : s.facets) {
      int m[3];
      for (int k = 0; k < 3; ++k) {
        Triple middle;
        for (int d = 0; d < 3; ++d) middle[d] = s.vertices[f[k]][d] + s.vertices[f[(k + 1) % 3]][d];
        const double length = std::hypot(middle[0], middle[1], middle[2]);
        for (double& x : middle) x /= length;
        const auto found = std::find(s.vertices.begin(), s.vertices.end(), middle);
        m[k] = int(found - s.vertices.begin());
        if (found == s.vertices.end()) s.vertices.push_back(middle);
      }
      finer.insert(finer.end(),
                   {{f[0], m[0], m[2]}, {m[0], f[1], m[1]}, {m[2], m[1], f[2]}, {m[0], m[1], m[2]}});
    }
    s.facets = finer;
  }
  for (Triple& v : s.vertices)
    for (double& x : v) x *= radius;
  return s;
}

using Wide = long double;
struct Difference {
  Wide x, y, z;
};
inline Difference from_to(const Triple& a, const Triple& b) {
  return {Wide(b[0]) - a[0], Wide(b[1]) - a[1], Wide(b[2]) - a[2]};
}
inline Wide inner(const Difference& a, const Difference& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Difference outer(const Difference& a, const Difference& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Wide segment_distance(const Triple& x, const Triple& a, const Triple& b) {
  const Difference ab = from_to(a, b), ax = from_to(a, x);
  const Wide t = std::clamp(inner(ab, ax) / inner(ab, ab), Wide(0), Wide(1));
  const Difference d{ax.x - t * ab.x, ax.y - t * ab.y, ax.z - t * ab.z};
  return std::sqrt(inner(d, d));
}
inline Wide facet_distance(const Triple& x, const Triple& a, const Triple& b, const Triple& c) {
  const Difference n = outer(from_to(a, b), from_to(a, c));
  const auto left_of = [&](const Triple& p, const Triple& q) {
    return inner(outer(from_to(p, q), from_to(p, x)), n) >= 0;
  };
  if (left_of(a, b) && left_of(b, c) && left_of(c, a))
    return std::abs(inner(from_to(a, x), n)) / std::sqrt(inner(n, n));
  return std::min({segment_distance(x, a, b), segment_distance(x, b, c), segment_distance(x, c, a)});
}
// Solid angle of a triangle: van Oosterom & Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125.
inline Wide solid_angle(const Triple& x, const Triple& a, const Triple& b, const Triple& c) {
  const Difference u = from_to(x, a), v = from_to(x, b), w = from_to(x, c);
  const Wide lu = std::sqrt(inner(u, u)), lv = std::sqrt(inner(v, v)), lw = std::sqrt(inner(w, w));
  return 2 * std::atan2(inner(u, outer(v, w)),
                        lu * lv * lw + inner(u, v) * lw + inner(v, w) * lu + inner(w, u) * lv);
}
inline double exact_distance(const FacetSurface& s, const Triple& x) {
  Wide nearest = 1e30L, angle = 0;
  for (const auto& [a, b, c] : s.facets) {
    nearest = std::min(nearest, facet_distance(x, s.vertices[a], s.vertices[b], s.vertices[c]));
    angle += solid_angle(x, s.vertices[a], s.vertices[b], s.vertices[c]);
  }
  return double(angle > Wide(2 * pi) ? -nearest : nearest);
}

} // namespace swarf::test
