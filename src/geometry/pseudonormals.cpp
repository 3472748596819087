// Angle-weighted pseudonormals: Baerentzen & Aanaes, IEEE TVCG 11 (2005) 243.
#include "src/geometry/facet_surface.hpp"
#include <algorithm>
#include <cmath>
#include <map>

namespace swarf {
namespace {

Triple minus(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double product(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
void scale_to_one(Triple& t) {
  const double length = std::sqrt(product(t, t));
  for (double& x : t) x /= length;
}
void add(Triple& sum, double weight, const Triple& t) {
  for (int k = 0; k < 3; ++k) sum[k] += weight * t[k];
}

} // namespace

Pseudonormals find_pseudonormals(const FacetSurface& surface) {
  Pseudonormals normals(surface.facets.size());
  std::vector<Triple> corner(surface.vertices.size(), Triple{});
  std::map<std::pair<int, int>, Triple> edge;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const auto& facet = surface.facets[f];
    const Triple u = minus(surface.vertices[facet[1]], surface.vertices[facet[0]]);
    const Triple v = minus(surface.vertices[facet[2]], surface.vertices[facet[0]]);
    Triple& n =
        normals[f][0] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    scale_to_one(n);
    for (int k = 0; k < 3; ++k) {
      const int a = facet[k], b = facet[(k + 1) % 3], c = facet[(k + 2) % 3];
      Triple ab = minus(surface.vertices[b], surface.vertices[a]);
      Triple ac = minus(surface.vertices[c], surface.vertices[a]);
      scale_to_one(ab), scale_to_one(ac);
      add(corner[a], std::acos(std::clamp(product(ab, ac), -1.0, 1.0)), n);
      add(edge.try_emplace(std::minmax(a, b), Triple{}).first->second, 1, n);
    }
  }
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = surface.facets[f][k], b = surface.facets[f][(k + 1) % 3];
      normals[f][1 + k] = edge.at(std::minmax(a, b));
      normals[f][4 + k] = corner[a];
      scale_to_one(normals[f][1 + k]), scale_to_one(normals[f][4 + k]);
    }
  return normals;
}

} // namespace swarf
