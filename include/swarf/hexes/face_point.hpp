// Where a point is nearest to a face of a hex. Pure functions.
#pragma once
#include "swarf/tool/signed_distance.hpp"

namespace swarf {

// The face as four triangles about its middle: of one form from whichever corner, flat or warped.
struct FacePoint {
  Real weight[4]{0, 0, 0, 0};                            // of the corners, sum 1
  Vector3 point{0, 0, 0};                                // nearest of the face
  Vector3 normal{0, 0, 0};                               // of its triangle, unit, outward
  Real squared = Kokkos::Experimental::infinity_v<Real>; // distance, m2
};

SWARF_FN FacePoint nearest_on_face(const Vector3* corner, const Vector3& x) {
  const Vector3 middle = Real(0.25) * (corner[0] + corner[1] + corner[2] + corner[3]);
  FacePoint best;
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    const Vector3 n = cross(corner[next] - corner[k], middle - corner[k]);
    const Triangle t{corner[k], corner[next], middle, (Real(1) / norm(n)) * n};
    const Vector3 p = nearest_on_triangle(t, x).point, d = x - p;
    if (!(dot(d, d) < best.squared)) continue;
    const Vector3 at = barycentric(t.a, t.b, t.c, p);
    best.squared = dot(d, d), best.point = p, best.normal = t.normal;
    for (int a = 0; a < 4; ++a) best.weight[a] = Real(0.25) * at.z;
    best.weight[k] += at.x, best.weight[next] += at.y;
  }
  return best;
}

SWARF_FN Real area_of_face(const Vector3* corner) {
  return Real(0.5) * norm(cross(corner[2] - corner[0], corner[3] - corner[1]));
}

} // namespace swarf
