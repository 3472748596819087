// What every pair sum shares: the particles of a cluster in lanes, one neighbour broadcast to all of them.
#pragma once
#include "swarf/core/tensor.hpp"
#include "swarf/particles/neighbors.hpp"
#include "swarf/particles/smoothing_kernel.hpp"

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

// Component c of row i. On a CPU rows are contiguous, so that fields of the same width share one index: a
// View's own, whose strides are known when it runs, costs a quarter of the instructions of a pair.
template <class Field>
KOKKOS_FORCEINLINE_FUNCTION auto row_of(const Field& f, int i) {
#ifdef SWARF_ONE_LANE
  return [&f, i](int c) { return f(i, c); };
#else
  static_assert(std::is_same_v<typename Field::array_layout, Kokkos::LayoutRight>);
  return [row = f.data() + std::size_t(i) * Field::static_extent(1)](int c) { return row[c]; };
#endif
}
template <class Field>
KOKKOS_FORCEINLINE_FUNCTION Pack broadcast(const Field& f, int i, int component) {
  return Pack(row_of(f, i)(component));
}
KOKKOS_FORCEINLINE_FUNCTION Vector3Of<Pack> broadcast_vector(const VectorField& f, int j) {
  const auto row = row_of(f, j);
  return {Pack(row(0)), Pack(row(1)), Pack(row(2))};
}
KOKKOS_FORCEINLINE_FUNCTION Symmetric3Of<Pack> broadcast_symmetric(const SymmetricField& f, int j) {
  const auto row = row_of(f, j);
  return {Pack(row(0)), Pack(row(1)), Pack(row(2)), Pack(row(3)), Pack(row(4)), Pack(row(5))};
}
KOKKOS_FORCEINLINE_FUNCTION Tensor3Of<Pack> broadcast_tensor(const TensorField& f, int j) {
  const auto row = row_of(f, j);
  return {Pack(row(0)), Pack(row(1)), Pack(row(2)), Pack(row(3)), Pack(row(4)),
          Pack(row(5)), Pack(row(6)), Pack(row(7)), Pack(row(8))};
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

// sum += a v, in multiplications that add
KOKKOS_FORCEINLINE_FUNCTION void add_product(Vector3Of<Pack>& sum, const Tensor3Of<Pack>& a,
                                             const Vector3Of<Pack>& v) {
  sum.x = sum.x + a.xx * v.x + a.xy * v.y + a.xz * v.z;
  sum.y = sum.y + a.yx * v.x + a.yy * v.y + a.yz * v.z;
  sum.z = sum.z + a.zx * v.x + a.zy * v.y + a.zz * v.z;
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
  const auto row = row_of(f, j);
  return {Pack(row(0)), Pack(row(4)), Pack(row(8)), Pack(row(1)), Pack(row(5)), Pack(row(2))};
}

// Symmetric in i and j, so that pair forces cancel to round-off: 1/h_ij = (1/h_i + 1/h_j) / 2.
KOKKOS_FORCEINLINE_FUNCTION Pack mean_inverse_h(const Pack& inverse_support_i, Real inverse_support_j) {
  return inverse_support_i + Pack(inverse_support_j);
}

// Whether the pair is, for any lane, within the support, or so little beyond that the forces of the same
// step, before which h follows the volume, may find it within: 1/256 of it, 1.2 % of the volume. Where a
// fragment grows by more in a step, one side may miss a pair at the rim, where W' is 1e-4 of its most and
// less. Not finite: near, so that a fault spreads.
KOKKOS_FORCEINLINE_FUNCTION bool any_near(const Vector3Of<Pack>& x_ij, const Pack& inverse_h) {
  constexpr Real reach = support_ratio * (Real(1) + Real(1) / Real(256));
  return any_of(!(dot(x_ij, x_ij) * (inverse_h * inverse_h) >= Pack(reach * reach)));
}

// W_ij at h_ij.
KOKKOS_FORCEINLINE_FUNCTION Pack pair_weight(const Vector3Of<Pack>& x_ij, const Pack& inverse_h) {
  return inverse_h * inverse_h * inverse_h * kernel_shape(Kokkos::sqrt(dot(x_ij, x_ij)) * inverse_h);
}

// V_j (dW/dr) / r at h_ij: V_j grad_i W_ij is this times x_ij. What is known first is multiplied first: the
// kernel's root is what a pair waits for.
KOKKOS_FORCEINLINE_FUNCTION Pack pair_slope(Real volume_j, const Vector3Of<Pack>& x_ij,
                                            const Pack& inverse_h) {
  const Pack inverse_h2 = inverse_h * inverse_h,
             scale = Pack(volume_j) * (inverse_h2 * inverse_h2 * inverse_h);
  return scale * kernel_slope(dot(x_ij, x_ij) * inverse_h2);
}

} // namespace swarf
