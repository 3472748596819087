// What every pair sum shares: the particles of a cluster in lanes, one neighbour broadcast to all of them.
#pragma once
#include "swarf/smoothing_kernel.hpp"
#include "swarf/tensor.hpp"

namespace swarf {

// Rows first .. first + size - 1 in the lanes of a pack; spare lanes repeat the last row.
struct Lanes {
  int first, size;

  KOKKOS_FORCEINLINE_FUNCTION int row(int lane) const { return first + (lane < size ? lane : size - 1); }
  KOKKOS_FORCEINLINE_FUNCTION Pack load(const ScalarField& f) const {
    return make_pack([&](int lane) { return f(row(lane)); });
  }
  template <class Field>
  KOKKOS_FORCEINLINE_FUNCTION Pack load(const Field& f, int component) const {
    return make_pack([&](int lane) { return f(row(lane), component); });
  }
  KOKKOS_FORCEINLINE_FUNCTION Vector3Of<Pack> load_vector(const VectorField& f) const {
    return {load(f, 0), load(f, 1), load(f, 2)};
  }
  KOKKOS_FORCEINLINE_FUNCTION Symmetric3Of<Pack> load_symmetric(const SymmetricField& f) const {
    return {load(f, 0), load(f, 1), load(f, 2), load(f, 3), load(f, 4), load(f, 5)};
  }
  KOKKOS_FORCEINLINE_FUNCTION Tensor3Of<Pack> load_tensor(const TensorField& f) const {
    return {load(f, 0), load(f, 1), load(f, 2), load(f, 3), load(f, 4),
            load(f, 5), load(f, 6), load(f, 7), load(f, 8)};
  }
};

KOKKOS_FORCEINLINE_FUNCTION Vector3Of<Pack> broadcast_vector(const VectorField& f, int j) {
  return {Pack(f(j, 0)), Pack(f(j, 1)), Pack(f(j, 2))};
}
KOKKOS_FORCEINLINE_FUNCTION Symmetric3Of<Pack> broadcast_symmetric(const SymmetricField& f, int j) {
  return {Pack(f(j, 0)), Pack(f(j, 1)), Pack(f(j, 2)), Pack(f(j, 3)), Pack(f(j, 4)), Pack(f(j, 5))};
}
KOKKOS_FORCEINLINE_FUNCTION Tensor3Of<Pack> broadcast_tensor(const TensorField& f, int j) {
  return {Pack(f(j, 0)), Pack(f(j, 1)), Pack(f(j, 2)), Pack(f(j, 3)), Pack(f(j, 4)),
          Pack(f(j, 5)), Pack(f(j, 6)), Pack(f(j, 7)), Pack(f(j, 8))};
}

KOKKOS_FORCEINLINE_FUNCTION Vector3 lane_of(const Vector3Of<Pack>& v, int lane) {
  return {lane_of(v.x, lane), lane_of(v.y, lane), lane_of(v.z, lane)};
}
KOKKOS_FORCEINLINE_FUNCTION Symmetric3 lane_of(const Symmetric3Of<Pack>& s, int lane) {
  return {lane_of(s.xx, lane), lane_of(s.yy, lane), lane_of(s.zz, lane),
          lane_of(s.xy, lane), lane_of(s.yz, lane), lane_of(s.zx, lane)};
}
KOKKOS_FORCEINLINE_FUNCTION Tensor3 lane_of(const Tensor3Of<Pack>& t, int lane) {
  return {lane_of(t.xx, lane), lane_of(t.xy, lane), lane_of(t.xz, lane),
          lane_of(t.yx, lane), lane_of(t.yy, lane), lane_of(t.yz, lane),
          lane_of(t.zx, lane), lane_of(t.zy, lane), lane_of(t.zz, lane)};
}

// x . a x
KOKKOS_FORCEINLINE_FUNCTION Pack quadratic_form(const Symmetric3Of<Pack>& a, const Vector3Of<Pack>& x) {
  const Pack two(Real(2));
  return x.x * (a.xx * x.x + two * a.xy * x.y) + x.y * (a.yy * x.y + two * a.yz * x.z) +
         x.z * (a.zz * x.z + two * a.zx * x.x);
}

// Of tensors that are symmetric.
KOKKOS_FORCEINLINE_FUNCTION Symmetric3Of<Pack> load_symmetric(const TensorField& f, const Lanes& i) {
  return {i.load(f, 0), i.load(f, 4), i.load(f, 8), i.load(f, 1), i.load(f, 5), i.load(f, 2)};
}
KOKKOS_FORCEINLINE_FUNCTION Symmetric3Of<Pack> broadcast_symmetric(const TensorField& f, int j) {
  return {Pack(f(j, 0)), Pack(f(j, 4)), Pack(f(j, 8)), Pack(f(j, 1)), Pack(f(j, 5)), Pack(f(j, 2))};
}

// Symmetric in i and j, so that pair forces cancel to the last bit: 1/h_ij = (1/h_i + 1/h_j) / 2.
KOKKOS_FORCEINLINE_FUNCTION Pack mean_inverse_h(const Pack& inverse_h_i, Real h_j) {
  return Pack(Real(0.5)) * (inverse_h_i + Pack(Real(1) / h_j));
}

// W_ij at h_ij.
KOKKOS_FORCEINLINE_FUNCTION Pack pair_weight(const Vector3Of<Pack>& x_ij, const Pack& inverse_h) {
  return inverse_h * inverse_h * inverse_h * kernel_shape(Kokkos::sqrt(dot(x_ij, x_ij)) * inverse_h);
}

// (dW/dr) / r at h_ij: grad_i W_ij is this times x_ij.
KOKKOS_FORCEINLINE_FUNCTION Pack pair_slope(const Vector3Of<Pack>& x_ij, const Pack& inverse_h) {
  const Pack inverse_h2 = inverse_h * inverse_h;
  return inverse_h2 * inverse_h2 * inverse_h * kernel_slope(dot(x_ij, x_ij) * inverse_h2);
}

} // namespace swarf
