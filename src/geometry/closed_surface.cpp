#include "src/geometry/closed_surface.hpp"
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace swarf {
namespace {

using Point = Eigen::Vector3d;

Point at(const FacetSurface& s, int v) { return Eigen::Map<const Point>(s.vertices[std::size_t(v)].data()); }
Vector3 to_vector(const Triple& t) { return {Real(t[0]), Real(t[1]), Real(t[2])}; }

// By the divergence theorem, about a corner of the box: no large numbers cancel.
double volume_of(const FacetSurface& s, const Point& corner) {
  double sum = 0;
  for (const auto& [a, b, c] : s.facets)
    sum += (at(s, a) - corner).dot((at(s, b) - corner).cross(at(s, c) - corner)) / 6;
  return sum;
}

int count_parts(const FacetSurface& s) {
  std::vector<int> part(s.vertices.size());
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](int v) {
    while (part[std::size_t(v)] != v) v = part[std::size_t(v)] = part[std::size_t(part[std::size_t(v)])];
    return v;
  };
  for (const auto& [a, b, c] : s.facets)
    part[std::size_t(root(b))] = root(a), part[std::size_t(root(c))] = root(a);
  std::set<int> roots;
  for (const auto& facet : s.facets) roots.insert(root(facet[0]));
  return int(roots.size());
}

} // namespace

FacetTree make_facet_tree(const FacetSurface& s) {
  std::vector<FacetTree::Box> boxes(s.facets.size());
  for (std::size_t f = 0; f < boxes.size(); ++f)
    for (const int v : s.facets[f]) boxes[f].extend(at(s, v));
  return FacetTree(boxes);
}

ClosedSurface::ClosedSurface(const FacetSurface& s, const Triple& origin)
    : shift(origin[0], origin[1], origin[2]), normals(find_pseudonormals(s)), tree(make_facet_tree(s)) {
  for (std::size_t f = 0; f < s.facets.size(); ++f) {
    const auto& [a, b, c] = s.facets[f];
    triangles.push_back({to_vector(s.vertices[std::size_t(a)]), to_vector(s.vertices[std::size_t(b)]),
                         to_vector(s.vertices[std::size_t(c)]), to_vector(normals[f][0])});
    for (const int v : {a, b, c}) bounds.extend(at(s, v));
  }
  enclosed = volume_of(s, bounds.min());
  pieces = count_parts(s);
  bounds.translate(shift);
}

double ClosedSurface::signed_distance(const Point& world) const {
  const Point local = world - shift;
  const Vector3 x{Real(local.x()), Real(local.y()), Real(local.z())};
  double best = std::numeric_limits<double>::infinity();
  double side = 1;
  tree.search([&](const FacetTree::Box& box) { return box.squaredExteriorDistance(local) <= best; },
              [&](const FacetTree::Box& box) { return box.squaredExteriorDistance(local); },
              [&](int f) {
                const NearestOnTriangle nearest = nearest_on_triangle(triangles[std::size_t(f)], x);
                const Vector3 d = x - nearest.point;
                const double squared = double(dot(d, d));
                if (squared >= best) return;
                best = squared;
                side = double(dot(d, to_vector(normals[std::size_t(f)][std::size_t(nearest.feature)])));
              });
  return side < 0 ? -std::sqrt(best) : std::sqrt(best);
}

} // namespace swarf
