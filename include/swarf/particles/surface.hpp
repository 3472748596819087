// The outer row of particles: what a one-sided kernel misses (correct_surface.cpp).
#pragma once
#include "swarf/core/tensor.hpp"

namespace swarf {

// Whether neighbours lack, 0 to 1: from the mean of sum_j w x x, on cubic lattices of h = 1.2 spacings 0.98
// inside, 0.97 one row below a face, 0.68 in it, 0.47 in an edge and 0.31 in a corner, where no derivative is
// along the surface.
SWARF_FN Real lacking_neighbors(const Symmetric3& A) {
  const Real mean = trace(A) / Real(3);
  return Kokkos::clamp((Real(0.9) - mean) / Real(0.1), Real(0), Real(1)) *
         Kokkos::clamp((mean - Real(0.35)) / Real(0.1), Real(0), Real(1));
}

// b: the direction across n in which fewest neighbours are, of length 1 in an edge, where A is 0.6 times as
// much along b as along the edge, and 0 in a face. n: unit.
SWARF_FN Vector3 edge_normal_of(const Tensor3& A, const Vector3& n) {
  const Vector3 aside = Kokkos::abs(n.x) < Real(0.6) ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
  const Vector3 across = aside - dot(aside, n) * n;
  const Vector3 e = (Real(1) / norm(across)) * across, f = cross(n, e);
  const Vector3 Ae = multiply(A, e), Af = multiply(A, f);
  const Real mean = Real(0.5) * (dot(e, Ae) + dot(f, Af)), half = Real(0.5) * (dot(e, Ae) - dot(f, Af)),
             shear = dot(f, Ae), radius = Kokkos::sqrt(half * half + shear * shear);
  const Real lacks =
      Kokkos::clamp((Real(0.9) - (mean - radius) / (mean + radius)) / Real(0.2), Real(0), Real(1));
  const Real angle = Real(0.5) * Kokkos::atan2(shear, half); // of the direction with most
  return Kokkos::sqrt(lacks) * (Kokkos::cos(angle) * f - Kokkos::sin(angle) * e);
}

// s~ and b of a particle at the surface.
struct SurfaceFrame {
  Vector3 shift, edge;
};

SWARF_FN SurfaceFrame surface_frame(const View<Real* [4]>& shift, const VectorField& edge, int i) {
  return {{shift(i, 1), shift(i, 2), shift(i, 3)}, load_vector(edge, i)};
}

SWARF_FN Tensor3 less_outer(const Tensor3& A, const Vector3& a, const Vector3& b) { // A - a (x) b
  return {A.xx - a.x * b.x, A.xy - a.x * b.y, A.xz - a.x * b.z, A.yx - a.y * b.x, A.yy - a.y * b.y,
          A.yz - a.y * b.z, A.zx - a.z * b.x, A.zy - a.z * b.y, A.zz - a.z * b.z};
}

// A (1 - n n - b b), n the direction of the shift: derivatives along a face, or along an edge.
SWARF_FN Tensor3 along_surface(const Tensor3& A, const SurfaceFrame& at) {
  const Vector3 across = (Real(1) / dot(at.shift, at.shift)) * multiply(A, at.shift);
  return less_outer(less_outer(A, across, at.shift), multiply(A, at.edge), at.edge);
}

} // namespace swarf
