// The tool's surface as patches, and what the contact does to each. Pure functions.
#pragma once
#include "swarf/core/tensor.hpp"

namespace swarf {

// What a point of the work has done to the tool, or all points to a patch: integrals over the time of contact
// of the normal force f, N.
enum SurfaceSum : int {
  sum_impulse,     // of f, N s
  sum_slide,       // of f v, v the speed of the point along the surface, N m
  sum_friction,    // of what friction dissipates, J
  sum_temperature, // of f T, T the temperature of the tool's side of the interface, N s K
  sum_wear,        // of f v exp(-B / T), N m
  surface_sums
};

// Facets halved at the middle of their longest edges until they are about as large as a face of the work's
// particles where the work comes, by neighbours together, so that no corner lies within a neighbour's edge
// (Rivara, Int. J. Numer. Meth. Eng. 20 (1984) 745). Node f of the tree is facet f; a node has children
// tree(n) and tree(n) + 1, or is patch -1 - tree(n). Halving edge e of corners e, e + 1 and the opposite e +
// 2 gives (e, middle, e + 2), then (middle, e + 1, e + 2).
struct ToolSurface {
  int patches = 0;             // 0: nothing is kept
  IndexField tree, halved;     // of each node: its children or patch; the edge that is halved
  View<Real* [3][3]> corner;   // m, of each patch in the tool's frame, counter-clockwise from outside
  ScalarField area;            // m2
  Real wear_A = 0, wear_B = 0; // 1/Pa, K, of Usui's law; A = 0: none

  // A point presses on more than the patch in which it touches: on all whose middle is less than half a
  // spacing from that one's and that face the same way. Patch p takes spread_share(k) of the sums of
  // spread_from(k), k from spread_start(p) to spread_start(p + 1): its area's share of all that the other
  // presses on.
  IndexField spread_start, spread_from;
  ScalarField spread_share;

  View<Real* [surface_sums]> sums; // of each patch: wear since the run began, the others since the last frame
  IndexField first, source;        // scratch of gather_tool_surface: rows of points by patch
};

// The patch of a facet at the point of these barycentric coordinates. In the half of the corner that is
// nearer: with the middle m = (a + b) / 2 of edge ab, a point la a + lb b + lc c with la >= lb is
// (la - lb) a + 2 lb m + lc c.
SWARF_FN int find_patch(const ToolSurface& s, int facet, const Vector3& at) {
  int node = facet;
  Real weight[3] = {at.x, at.y, at.z};
  while (s.tree(node) >= 0) {
    const int e = s.halved(node);
    const Real a = weight[e], b = weight[(e + 1) % 3], c = weight[(e + 2) % 3];
    const bool first = a >= b;
    weight[0] = first ? a - b : Real(2) * a, weight[1] = first ? Real(2) * b : b - a, weight[2] = c;
    node = s.tree(node) + (first ? 0 : 1);
  }
  return -1 - s.tree(node);
}

// Barycentric coordinates of a point of the triangle abc.
SWARF_FN Vector3 barycentric(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& x) {
  const Vector3 n = cross(b - a, c - a);
  const Real scale = Real(1) / dot(n, n);
  const Real of_b = scale * dot(cross(x - a, c - a), n), of_c = scale * dot(cross(b - a, x - a), n);
  return {Real(1) - of_b - of_c, of_b, of_c};
}

// Depth of wear per time: A p v exp(-B / T) (Usui, Shirakashi & Kitagawa, Wear 100 (1984) 129). Its
// exponential; without a temperature there is none.
SWARF_FN Real wear_factor(const ToolSurface& s, Real temperature) {
  return s.wear_A > Real(0) && temperature > Real(0) ? Kokkos::exp(-s.wear_B / temperature) : Real(0);
}

// What patch p has of sum q, of what all points have done.
SWARF_FN Real spread_sum(const ToolSurface& s, int p, SurfaceSum q) {
  Real sum = 0;
  for (int k = s.spread_start(p); k < s.spread_start(p + 1); ++k)
    sum += s.spread_share(k) * s.sums(s.spread_from(k), q);
  return sum;
}

// What is shown of a patch. Means over the time since the last frame: pressure and power over all of it, the
// speed weighted by the normal force; the temperature, too, where there was contact, else that of the tool's
// cell below. Wear since the run began.
enum ShownOnTool : int {
  shown_temperature, // K
  shown_pressure,    // Pa
  shown_speed,       // m/s
  shown_friction,    // W/m2
  shown_wear,        // m
  shown_on_tool
};

} // namespace swarf
