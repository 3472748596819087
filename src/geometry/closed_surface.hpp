// A closed surface that bounds a body: which points it encloses, and how far they are from it.
#pragma once
#include "src/geometry/facet_tree.hpp"
#include "swarf/tool/signed_distance.hpp"

namespace swarf {

class ClosedSurface {
 public:
  using Point = Eigen::Vector3d;

  // Of a surface that check_surface has passed, with its origin at `origin`.
  ClosedSurface(const FacetSurface& surface, const Triple& origin);

  double signed_distance(const Point& x) const; // negative inside; exact at any distance
  double volume() const { return enclosed; }    // m3
  const Eigen::AlignedBox3d& box() const { return bounds; }
  int parts() const { return pieces; } // that no edge joins

 private:
  Point shift;
  std::vector<Triangle> triangles; // in the file's place
  Pseudonormals normals;
  FacetTree tree;
  Eigen::AlignedBox3d bounds;
  double enclosed = 0;
  int pieces = 0;
};

} // namespace swarf
