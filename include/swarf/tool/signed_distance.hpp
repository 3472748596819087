// Signed distance of a point from the tool's surface: negative inside. Pure functions; all in the tool's
// frame.
#pragma once
#include "swarf/tool/tool.hpp"

namespace swarf {

// Nearest point of a triangle, and where it lies: 0 face; 1, 2, 3 edges 01, 12, 20; 4, 5, 6 corners 0, 1, 2.
struct NearestOnTriangle {
  Vector3 point;
  int feature;
};

struct Triangle {
  Vector3 a, b, c;
  Vector3 normal; // unit
};

// Voronoi regions of the triangle's corners, edges and face by the signs of the barycentric coordinates:
// Ericson, Real-Time Collision Detection (2005), section 5.1.5.
SWARF_FN NearestOnTriangle nearest_on_triangle(const Triangle& t, const Vector3& x) {
  const Vector3 ab = t.b - t.a, ac = t.c - t.a, bc = t.c - t.b;
  const Vector3 ax = x - t.a, bx = x - t.b, cx = x - t.c;
  const Real ab_ax = dot(ab, ax), ac_ax = dot(ac, ax);
  if (ab_ax <= 0 && ac_ax <= 0) return {t.a, 4};
  const Real ab_bx = dot(ab, bx), ac_bx = dot(ac, bx);
  if (ab_bx >= 0 && ac_bx <= ab_bx) return {t.b, 5};
  const Real ab_cx = dot(ab, cx), ac_cx = dot(ac, cx);
  if (ac_cx >= 0 && ab_cx <= ac_cx) return {t.c, 6};
  const Real weight_c = ab_ax * ac_bx - ab_bx * ac_ax;
  if (weight_c <= 0 && ab_ax >= 0 && ab_bx <= 0) return {t.a + (ab_ax / (ab_ax - ab_bx)) * ab, 1};
  const Real weight_b = ab_cx * ac_ax - ab_ax * ac_cx;
  if (weight_b <= 0 && ac_ax >= 0 && ac_cx <= 0) return {t.a + (ac_ax / (ac_ax - ac_cx)) * ac, 3};
  const Real weight_a = ab_bx * ac_cx - ab_cx * ac_bx;
  const Real from_b = ac_bx - ab_bx, from_c = ab_cx - ac_cx; // bc . bx, -(bc . cx)
  if (weight_a <= 0 && from_b >= 0 && from_c >= 0) return {t.b + (from_b / (from_b + from_c)) * bc, 2};
  return {x - dot(ax, t.normal) * t.normal, 0};
}

struct ToolDistance {
  enum class Where : int { outside, near, deep_inside };
  Where where = Where::outside; // distance, normal and point only when near
  Real distance = 0;            // m
  Vector3 normal{0, 0, 0};      // unit, outward: direction in which the distance grows
  Vector3 point{0, 0, 0};       // nearest on the surface
  int facet = -1;
};

SWARF_FN Triangle load_facet(const Tool& tool, int f) {
  return {{tool.vertex(f, 0, 0), tool.vertex(f, 0, 1), tool.vertex(f, 0, 2)},
          {tool.vertex(f, 1, 0), tool.vertex(f, 1, 1), tool.vertex(f, 1, 2)},
          {tool.vertex(f, 2, 0), tool.vertex(f, 2, 1), tool.vertex(f, 2, 2)},
          {tool.pseudonormal(f, 0, 0), tool.pseudonormal(f, 0, 1), tool.pseudonormal(f, 0, 2)}};
}

struct CellPlace {
  int cell = -1;        // -1: outside the grid
  Real from_centre = 0; // m
};

SWARF_FN CellPlace find_cell(const Tool& tool, const Vector3& x) {
  const Vector3 r = (Real(1) / tool.cell_size) * (x - tool.grid_origin);
  // Compared as reals: a far or non-finite point must not overflow the integer.
  if (!(r.x >= 0 && r.y >= 0 && r.z >= 0)) return {};
  if (!(r.x < Real(tool.cells[0]) && r.y < Real(tool.cells[1]) && r.z < Real(tool.cells[2]))) return {};
  const int i = int(r.x), j = int(r.y), k = int(r.z);
  const Real half = Real(0.5);
  const Vector3 d{r.x - Real(i) - half, r.y - Real(j) - half, r.z - Real(k) - half};
  return {i + tool.cells[0] * (j + tool.cells[1] * k), tool.cell_size * norm(d)};
}

// Sign by the angle-weighted pseudonormal of the nearest feature: Baerentzen & Aanaes, IEEE TVCG 11 (2005)
// 243.
SWARF_FN ToolDistance signed_distance(const Tool& tool, const Vector3& x) {
  ToolDistance result;
  const CellPlace place = find_cell(tool, x);
  if (place.cell < 0) return result;
  const int begin = tool.cell_start(place.cell), end = tool.cell_start(place.cell + 1);
  if (begin == end) return result;
  if (tool.cell_facet(begin) == Tool::deep_inside) {
    result.where = ToolDistance::Where::deep_inside;
    return result;
  }
  Real best = Kokkos::Experimental::infinity_v<Real>;
  Real last = best; // a facet farther than this from the cell's centre is farther from x than the best one
  int feature = 0;
  for (int e = begin; e < end && tool.facet_distance(e) <= last; ++e) {
    const int f = tool.cell_facet(e);
    const NearestOnTriangle nearest = nearest_on_triangle(load_facet(tool, f), x);
    const Vector3 d = x - nearest.point;
    const Real squared = dot(d, d);
    if (squared >= best) continue;
    best = squared, feature = nearest.feature, result.point = nearest.point, result.facet = f;
    last = Real(1.00001) * (Kokkos::sqrt(best) + place.from_centre); // more than round-off
  }
  const Vector3 pseudonormal{tool.pseudonormal(result.facet, feature, 0),
                             tool.pseudonormal(result.facet, feature, 1),
                             tool.pseudonormal(result.facet, feature, 2)};
  const Vector3 d = x - result.point;
  const Real sign = dot(d, pseudonormal) < 0 ? Real(-1) : Real(1);
  const Real length = Kokkos::sqrt(best);
  // Below the round-off of the coordinates the difference has no direction.
  const Real size = tool.cell_size * Real(tool.cells[0] + tool.cells[1] + tool.cells[2]);
  const bool has_direction = length > Real(100) * Kokkos::Experimental::epsilon_v<Real> * size;
  result.where = ToolDistance::Where::near;
  result.distance = sign * length;
  result.normal = feature == 0 || !has_direction ? pseudonormal : (sign / length) * d;
  return result;
}

// Whether x lies outside the tool and surely farther from it than `gap`, by what is known of its cell: a
// distance changes by no more than the point moves.
SWARF_FN bool is_beyond(const Tool& tool, const Vector3& x, Real gap) {
  const CellPlace place = find_cell(tool, x);
  return place.cell < 0 || tool.cell_distance(place.cell) > Real(1.00001) * (gap + place.from_centre);
}

// Whether x lies in the tool, or nearer to it than `distance`, which is at most tool.reach.
SWARF_FN bool is_within(const Tool& tool, const Vector3& x, Real distance) {
  if (tool.facets == 0) return false;
  const ToolDistance at = signed_distance(tool, x);
  return at.where == ToolDistance::Where::deep_inside ||
         (at.where == ToolDistance::Where::near && at.distance < distance);
}

} // namespace swarf
