// Small vectors and tensors, on a scalar S that is Real or a pack of lanes.
#pragma once
#include "swarf/core/types.hpp"

namespace swarf {

template <class S>
struct Vector3Of {
  S x, y, z;
};

// Components xx yy zz xy yz zx, the order in which VTK stores symmetric tensors.
template <class S>
struct Symmetric3Of {
  S xx, yy, zz, xy, yz, zx;
};

template <class S>
struct Tensor3Of {
  S xx, xy, xz, yx, yy, yz, zx, zy, zz;
};

using Vector3 = Vector3Of<Real>;
using Symmetric3 = Symmetric3Of<Real>;
using Tensor3 = Tensor3Of<Real>;

#define SWARF_FN KOKKOS_FORCEINLINE_FUNCTION

// --- vectors
template <class S>
SWARF_FN Vector3Of<S> operator+(const Vector3Of<S>& a, const Vector3Of<S>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class S>
SWARF_FN Vector3Of<S> operator-(const Vector3Of<S>& a, const Vector3Of<S>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S>
SWARF_FN Vector3Of<S> operator*(const S& s, const Vector3Of<S>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class S>
SWARF_FN S dot(const Vector3Of<S>& a, const Vector3Of<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class S>
SWARF_FN Vector3Of<S> cross(const Vector3Of<S>& a, const Vector3Of<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
SWARF_FN Real norm(const Vector3& a) { return Kokkos::sqrt(dot(a, a)); }

// --- symmetric tensors
template <class S>
SWARF_FN Symmetric3Of<S> operator+(const Symmetric3Of<S>& a, const Symmetric3Of<S>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.zx + b.zx};
}
template <class S>
SWARF_FN Symmetric3Of<S> operator*(const S& s, const Symmetric3Of<S>& a) {
  return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.zx};
}
SWARF_FN Real trace(const Symmetric3& a) { return a.xx + a.yy + a.zz; }
SWARF_FN Symmetric3 deviator(const Symmetric3& a) {
  const Real mean = trace(a) / Real(3);
  return {a.xx - mean, a.yy - mean, a.zz - mean, a.xy, a.yz, a.zx};
}
// a : b
SWARF_FN Real contract(const Symmetric3& a, const Symmetric3& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + Real(2) * (a.xy * b.xy + a.yz * b.yz + a.zx * b.zx);
}
SWARF_FN Real von_mises(const Symmetric3& stress) {
  const Symmetric3 s = deviator(stress);
  return Kokkos::sqrt(Real(1.5) * contract(s, s));
}
template <class S>
SWARF_FN Vector3Of<S> multiply(const Symmetric3Of<S>& a, const Vector3Of<S>& v) {
  return {a.xx * v.x + a.xy * v.y + a.zx * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
          a.zx * v.x + a.yz * v.y + a.zz * v.z};
}

// --- general tensors
template <class S>
SWARF_FN Tensor3Of<S> operator+(const Tensor3Of<S>& a, const Tensor3Of<S>& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yx + b.yx, a.yy + b.yy,
          a.yz + b.yz, a.zx + b.zx, a.zy + b.zy, a.zz + b.zz};
}
SWARF_FN Tensor3 operator*(Real s, const Tensor3& a) {
  return {s * a.xx, s * a.xy, s * a.xz, s * a.yx, s * a.yy, s * a.yz, s * a.zx, s * a.zy, s * a.zz};
}
template <class S>
SWARF_FN Vector3Of<S> multiply(const Tensor3Of<S>& a, const Vector3Of<S>& v) {
  return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.yx * v.x + a.yy * v.y + a.yz * v.z,
          a.zx * v.x + a.zy * v.y + a.zz * v.z};
}
template <class S>
SWARF_FN Tensor3Of<S> multiply(const Tensor3Of<S>& a, const Tensor3Of<S>& b) {
  return {a.xx * b.xx + a.xy * b.yx + a.xz * b.zx, a.xx * b.xy + a.xy * b.yy + a.xz * b.zy,
          a.xx * b.xz + a.xy * b.yz + a.xz * b.zz, a.yx * b.xx + a.yy * b.yx + a.yz * b.zx,
          a.yx * b.xy + a.yy * b.yy + a.yz * b.zy, a.yx * b.xz + a.yy * b.yz + a.yz * b.zz,
          a.zx * b.xx + a.zy * b.yx + a.zz * b.zx, a.zx * b.xy + a.zy * b.yy + a.zz * b.zy,
          a.zx * b.xz + a.zy * b.yz + a.zz * b.zz};
}
SWARF_FN Tensor3 transpose(const Tensor3& a) {
  return {a.xx, a.yx, a.zx, a.xy, a.yy, a.zy, a.xz, a.yz, a.zz};
}
SWARF_FN Tensor3 to_tensor(const Symmetric3& a) {
  return {a.xx, a.xy, a.zx, a.xy, a.yy, a.yz, a.zx, a.yz, a.zz};
}
SWARF_FN Symmetric3 symmetric_part(const Tensor3& a) {
  const Real half = Real(0.5);
  return {a.xx, a.yy, a.zz, half * (a.xy + a.yx), half * (a.yz + a.zy), half * (a.zx + a.xz)};
}
SWARF_FN Tensor3 identity3() { return {1, 0, 0, 0, 1, 0, 0, 0, 1}; }
SWARF_FN Real determinant(const Tensor3& a) {
  return a.xx * (a.yy * a.zz - a.yz * a.zy) - a.xy * (a.yx * a.zz - a.yz * a.zx) +
         a.xz * (a.yx * a.zy - a.yy * a.zx);
}
// The caller makes sure that det is not 0.
SWARF_FN Tensor3 inverse(const Tensor3& a, Real det) {
  const Real s = Real(1) / det;
  return {s * (a.yy * a.zz - a.yz * a.zy), s * (a.xz * a.zy - a.xy * a.zz), s * (a.xy * a.yz - a.xz * a.yy),
          s * (a.yz * a.zx - a.yx * a.zz), s * (a.xx * a.zz - a.xz * a.zx), s * (a.xz * a.yx - a.xx * a.yz),
          s * (a.yx * a.zy - a.yy * a.zx), s * (a.xy * a.zx - a.xx * a.zy), s * (a.xx * a.yy - a.xy * a.yx)};
}
SWARF_FN Tensor3 cofactor(const Tensor3& F) { return transpose(inverse(F, Real(1))); } // J F^-T
// B where A is cofactor(F) B
SWARF_FN Tensor3 without_cofactor(const Tensor3& A, const Tensor3& F) {
  return (Real(1) / determinant(F)) * multiply(transpose(F), A);
}
// Q A Q^T
SWARF_FN Symmetric3 rotate(const Tensor3& Q, const Symmetric3& a) {
  return symmetric_part(multiply(multiply(Q, to_tensor(a)), transpose(Q)));
}

// --- rows of fields
template <class Field>
SWARF_FN Vector3 load_vector(const Field& f, int i) {
  return {f(i, 0), f(i, 1), f(i, 2)};
}
template <class Field>
SWARF_FN void store_vector(const Field& f, int i, const Vector3& v) {
  f(i, 0) = v.x, f(i, 1) = v.y, f(i, 2) = v.z;
}
template <class Field>
SWARF_FN Symmetric3 load_symmetric(const Field& f, int i) {
  return {f(i, 0), f(i, 1), f(i, 2), f(i, 3), f(i, 4), f(i, 5)};
}
template <class Field>
SWARF_FN void store_symmetric(const Field& f, int i, const Symmetric3& s) {
  f(i, 0) = s.xx, f(i, 1) = s.yy, f(i, 2) = s.zz, f(i, 3) = s.xy, f(i, 4) = s.yz, f(i, 5) = s.zx;
}
template <class Field>
SWARF_FN Tensor3 load_tensor(const Field& f, int i) {
  return {f(i, 0), f(i, 1), f(i, 2), f(i, 3), f(i, 4), f(i, 5), f(i, 6), f(i, 7), f(i, 8)};
}
template <class Field>
SWARF_FN void store_tensor(const Field& f, int i, const Tensor3& t) {
  f(i, 0) = t.xx, f(i, 1) = t.xy, f(i, 2) = t.xz, f(i, 3) = t.yx, f(i, 4) = t.yy, f(i, 5) = t.yz,
       f(i, 6) = t.zx, f(i, 7) = t.zy, f(i, 8) = t.zz;
}

} // namespace swarf
