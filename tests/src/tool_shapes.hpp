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
