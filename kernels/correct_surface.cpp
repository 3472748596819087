// L_i += (s_i . grad L)_i (1 - n_i n_i) for particles that lack neighbours: what a one-sided kernel misses.
// Of a field of second order the corrected gradient is that of a point inside: for the derivatives along a
// flat face 0.26 spacings, h = 1.2 spacings, cubic lattice. The gradient of L, itself of first order,
//   (s_i . grad L)_i = sum_j V_j (s~_i . grad W_ij) (L_j - L_i),  s~ = K s,  n = s~ / |s~|,
// leads it outwards,
//   s_i = -reach sum_j w r^2 x / sum_j w r^2,  w = -V_j W' / r,  x = x_j - x_i: 0.46 reach spacings, 0
//   inside.
// Where to: a sum over the centres of cells becomes an integral of fourth order (Euler & Maclaurin) if those
// of the outer row count with the value 1/24 of a spacing further out. The gradients of the neighbours are
// too near as well, 0.754 for 1: (0.261 + 1/24) / 0.754 / 0.458 = 0.88. The derivative across the face is
// left as it is: its strain finds itself from the stress, and the highest frequency stays that of the inside.
// A linear field stays exact, so that rotation does. Reads position, velocity_gradient, volume,
// inverse_support, K in pair_stress, and in surface_shift how far neighbours lack; writes velocity_gradient
// and surface_shift, rows [0, count); surface_term is its own.
#include "copy_to_images.hpp"
#include "swarf/pair.hpp"
#include "swarf/surface.hpp"

namespace swarf {
namespace {

constexpr Real reach = Real(0.88);

struct Moments {
  Vector3Of<Pack> gradient, third; // sum V_j grad W, sum V_j r^2 grad W
  Pack second;                     // sum w r^2
};

KOKKOS_FORCEINLINE_FUNCTION Moments sum_moments(const Particles& p, const Neighbors& n, int cluster,
                                                const Lanes& lanes) {
  const Pack zero(Real(0));
  Moments m{{zero, zero, zero}, {zero, zero, zero}, zero};
  const auto x_i = lanes.load_vector(p.position);
  const Pack inverse_support_i = lanes.load(p.inverse_support);
  for_each_neighbor(n, cluster, [&](int j) {
    const auto x_ij = x_i - broadcast_vector(p.position, j);
    const Pack slope = pair_slope(p.volume(j), x_ij, mean_inverse_h(inverse_support_i, p.inverse_support(j)));
    const Pack r2 = dot(x_ij, x_ij);
    const auto grad = slope * x_ij;
    m.gradient = m.gradient + grad;
    m.third = m.third + r2 * grad;
    m.second -= slope * r2;
  });
  return m;
}

// From how far neighbours lack to the shift and its sum over all.
KOKKOS_FORCEINLINE_FUNCTION void store_shifts(const Particles& p, const Lanes& lanes, const Moments& m) {
  for (int lane = 0; lane < lanes.size; ++lane) {
    const int i = lanes.first + lane;
    const Real lacking = p.surface_shift(i, 0);
    if (!(lacking > 0)) continue;
    const Vector3 s = (-reach * lacking / lane_of(m.second, lane)) * lane_of(m.third, lane);
    const Vector3 shift = multiply(load_tensor(p.pair_stress, i), s);
    p.surface_shift(i, 0) = dot(shift, lane_of(m.gradient, lane));
    p.surface_shift(i, 1) = shift.x, p.surface_shift(i, 2) = shift.y, p.surface_shift(i, 3) = shift.z;
  }
}

// sum_j V_j (s~_i . grad W_ij) L_j
KOKKOS_FORCEINLINE_FUNCTION Tensor3Of<Pack> sum_gradients(const Particles& p, const Neighbors& n, int cluster,
                                                          const Lanes& lanes) {
  const Pack zero(Real(0));
  Tensor3Of<Pack> sum{zero, zero, zero, zero, zero, zero, zero, zero, zero};
  const auto x_i = lanes.load_vector(p.position);
  const Pack inverse_support_i = lanes.load(p.inverse_support);
  // Of lanes inside the sum is not zero, but goes nowhere.
  const Vector3Of<Pack> shift{lanes.load(p.surface_shift, 1), lanes.load(p.surface_shift, 2),
                              lanes.load(p.surface_shift, 3)};
  for_each_neighbor(n, cluster, [&](int j) {
    const auto x_ij = x_i - broadcast_vector(p.position, j);
    const Pack slope = pair_slope(p.volume(j), x_ij, mean_inverse_h(inverse_support_i, p.inverse_support(j)));
    const Pack share = slope * dot(x_ij, shift);
    const auto L = broadcast_tensor(p.points.velocity_gradient, j);
    sum.xx += share * L.xx, sum.xy += share * L.xy, sum.xz += share * L.xz;
    sum.yx += share * L.yx, sum.yy += share * L.yy, sum.yz += share * L.yz;
    sum.zx += share * L.zx, sum.zy += share * L.zy, sum.zz += share * L.zz;
  });
  return sum;
}

SWARF_FN bool is_at_surface(const Particles& p, const Neighbors& n, int cluster) {
  for (int i = n.first(cluster); i < n.first(cluster) + n.size(cluster); ++i)
    if (p.surface_shift(i, 0) != 0) return true;
  return false;
}

} // namespace

void correct_surface(const Particles& p, const Neighbors& n, const ImagePlanes& planes) {
  copy_to_images<Images::in_surface_gradient>("update_image_gradient", p, n, planes);
  Kokkos::parallel_for(
      "correct_surface", Range(0, n.clusters), KOKKOS_LAMBDA(int cluster) {
        if (!is_at_surface(p, n, cluster)) return;
        const Lanes lanes{n.first(cluster), n.size(cluster)};
        store_shifts(p, lanes, sum_moments(p, n, cluster, lanes));
        const auto sum = sum_gradients(p, n, cluster, lanes);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int i = lanes.first + lane;
          if (p.surface_shift(i, 0) == 0) continue;
          const Tensor3 change =
              lane_of(sum, lane) + (-p.surface_shift(i, 0)) * load_tensor(p.points.velocity_gradient, i);
          const Vector3 shift{p.surface_shift(i, 1), p.surface_shift(i, 2), p.surface_shift(i, 3)};
          store_tensor(p.surface_term, i, along_surface(change, shift));
        }
      });
  Kokkos::parallel_for(
      "correct_surface_gradient", Range(0, p.count), KOKKOS_LAMBDA(int i) {
        if (p.surface_shift(i, 0) != 0)
          store_tensor(p.points.velocity_gradient, i,
                       load_tensor(p.points.velocity_gradient, i) + load_tensor(p.surface_term, i));
      });
}

} // namespace swarf
