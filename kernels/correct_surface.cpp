// L_i += (s_i . grad L)_i (1 - n_i n_i - b_i b_i) for particles that lack neighbours: what a one-sided kernel
// misses. b: 0 in a face; in an edge, where n is the diagonal, the other direction across.
// Of a field of second order the corrected gradient is that of a point inside: for the derivatives along a
// flat face 0.26 spacings, h = 1.2 spacings, cubic lattice. The gradient of L, itself of first order,
//   (s_i . grad L)_i = sum_j V_j (s~_i . grad W_ij) (L_j - L_i),  s~ = K s,  n = s~ / |s~|,
// leads it outwards,
//   s_i = -reach sum_j w r^2 x / sum_j w r^2,  w = -V_j W' / r,  x = x_j - x_i: 0.46 reach spacings, 0
//   inside.
// Where to: a sum over the centres of cells becomes an integral of fourth order (Euler & Maclaurin) if those
// of the outer row count with the value 1/24 of a spacing further out. The gradients of the neighbours are
// too near as well, 0.754 for 1: (0.261 + 1/24) / 0.754 / 0.458 = 0.88. The derivative across the face is
// left as it is: its strain finds itself from the stress, and the highest frequency of a flat face stays that
// of the inside. A linear field stays exact, so that rotation does. In the initial frame all this is done to
// F and dF/dt, over the initial positions. Reads position or build_position, velocity_gradient,
// deformation_gradient, volume, inverse_support, K in pair_stress, and in surface_shift how far neighbours
// lack; writes velocity_gradient, deformation_gradient, K, surface_shift and edge_normal, rows [0, count);
// surface_term is its own.
#include "copy_to_ghosts.hpp"
#include "store_correction.hpp"
#include "swarf/particles/pair.hpp"
#include "swarf/particles/surface.hpp"

namespace swarf {
namespace {

constexpr Real reach = Real(0.88);

// What the kernels see, and a cluster of it.
struct Sight {
  Particles p;
  Neighbors n;
  VectorField from; // positions
  bool initial;

  SWARF_FN bool is_at_surface(int cluster) const {
    for (int i = n.first(cluster); i < n.first(cluster) + n.size(cluster); ++i)
      if (p.surface_shift(i, 0) != 0) return true;
    return false;
  }
  SWARF_FN SurfaceFrame frame(int i) const { return surface_frame(p.surface_shift, p.edge_normal, i); }
  SWARF_FN Tensor3 K(int i) const { // in the initial frame K0
    const Tensor3 shown = load_tensor(p.pair_stress, i);
    return initial ? without_cofactor(shown, load_tensor(p.deformation_gradient, i)) : shown;
  }
  // visit(j, x_ij, slope)
  template <class Visit>
  KOKKOS_FORCEINLINE_FUNCTION void for_each_pair(int cluster, const Lanes& lanes, const Visit& visit) const {
    const auto x_i = lanes.load_vector(from);
    const Pack inverse_support_i = lanes.load(p.inverse_support);
    for_each_neighbor(n, cluster, [&](int j) {
      const auto x_ij = x_i - broadcast_vector(from, j);
      visit(j, x_ij, pair_slope(p.volume(j), x_ij, mean_inverse_h(inverse_support_i, p.inverse_support(j))));
    });
  }
};

struct Moments {
  Vector3Of<Pack> gradient, third; // sum V_j grad W, sum V_j r^2 grad W
  Pack second;                     // sum w r^2
};

KOKKOS_FORCEINLINE_FUNCTION Moments sum_moments(const Sight& see, int cluster, const Lanes& lanes) {
  const Pack zero(Real(0));
  Moments m{{zero, zero, zero}, {zero, zero, zero}, zero};
  see.for_each_pair(cluster, lanes, [&](int, const Vector3Of<Pack>& x_ij, const Pack& slope) {
    const Pack r2 = dot(x_ij, x_ij);
    const auto grad = slope * x_ij;
    m.gradient = m.gradient + grad;
    m.third = m.third + r2 * grad;
    m.second -= slope * r2;
  });
  return m;
}

// From how far neighbours lack to the shift and its sum over all.
void find_surface_shifts(const Sight& see) {
  const Particles p = see.p;
  Kokkos::parallel_for(
      "surface_shifts", Range(0, see.n.clusters), KOKKOS_LAMBDA(int cluster) {
        if (!see.is_at_surface(cluster)) return;
        const Lanes lanes{see.n.first(cluster), see.n.size(cluster)};
        const Moments m = sum_moments(see, cluster, lanes);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int i = lanes.first + lane;
          const Real lacking = p.surface_shift(i, 0);
          if (!(lacking > 0)) continue;
          const Vector3 s = (-reach * lacking / lane_of(m.second, lane)) * lane_of(m.third, lane);
          const Tensor3 K = see.K(i);
          const Vector3 shift = multiply(K, s);
          p.surface_shift(i, 0) = dot(shift, lane_of(m.gradient, lane));
          p.surface_shift(i, 1) = shift.x, p.surface_shift(i, 2) = shift.y, p.surface_shift(i, 3) = shift.z;
          const Real length = norm(shift);
          if (length > 0)
            store_vector(p.edge_normal, i,
                         edge_normal_of(inverse(K, determinant(K)), (Real(1) / length) * shift));
          else
            p.surface_shift(i, 0) = 0;
        }
      });
}

// The tensors that are led outwards.
struct VelocityGradients {
  TensorField L;
  SWARF_FN Tensor3 operator()(int i) const { return load_tensor(L, i); }
};
struct DeformationRates {
  TensorField L, F;
  SWARF_FN Tensor3 operator()(int i) const { return multiply(load_tensor(L, i), load_tensor(F, i)); }
};

// (s . grad A) (1 - n n - b b) to surface_term.
template <class Tensors>
void find_changes(const Sight& see, const Tensors& A) {
  Kokkos::parallel_for(
      "correct_surface", Range(0, see.n.clusters), KOKKOS_LAMBDA(int cluster) {
        if (!see.is_at_surface(cluster)) return;
        const Lanes lanes{see.n.first(cluster), see.n.size(cluster)};
        const Vector3Of<Pack> shift{lanes.load(see.p.surface_shift, 1), lanes.load(see.p.surface_shift, 2),
                                    lanes.load(see.p.surface_shift, 3)};
        const Pack zero(Real(0));
        Tensor3Of<Pack> sum{zero, zero, zero, zero, zero, zero, zero, zero, zero};
        see.for_each_pair(cluster, lanes, [&](int j, const Vector3Of<Pack>& x_ij, const Pack& slope) {
          const Pack share = slope * dot(x_ij, shift);
          const Tensor3 T = A(j);
          sum.xx += share * Pack(T.xx), sum.xy += share * Pack(T.xy), sum.xz += share * Pack(T.xz);
          sum.yx += share * Pack(T.yx), sum.yy += share * Pack(T.yy), sum.yz += share * Pack(T.yz);
          sum.zx += share * Pack(T.zx), sum.zy += share * Pack(T.zy), sum.zz += share * Pack(T.zz);
        });
        for (int lane = 0; lane < lanes.size; ++lane) { // of those inside the sum goes nowhere
          const int i = lanes.first + lane;
          if (see.p.surface_shift(i, 0) == 0) continue;
          const Tensor3 change = lane_of(sum, lane) + (-see.p.surface_shift(i, 0)) * A(i);
          store_tensor(see.p.surface_term, i, along_surface(change, see.frame(i)));
        }
      });
}

// L, or in the initial frame dF/dt in its place.
template <class Tensors>
void add_changes(const Sight& see, const Tensors& A) {
  const Particles p = see.p;
  find_changes(see, A);
  Kokkos::parallel_for(
      "correct_surface_gradient", Range(0, p.count), KOKKOS_LAMBDA(int i) {
        if (p.surface_shift(i, 0) != 0)
          store_tensor(p.points.velocity_gradient, i, A(i) + load_tensor(p.surface_term, i));
      });
}

// F, and what follows from it: L and the correction.
void add_deformation(const Sight& see) {
  const Particles p = see.p;
  find_changes(see, VelocityGradients{p.deformation_gradient});
  Kokkos::parallel_for(
      "correct_surface_deformation", Range(0, p.count), KOKKOS_LAMBDA(int i) {
        if (p.surface_shift(i, 0) == 0) return;
        const Tensor3 K0 = see.K(i),
                      F = load_tensor(p.deformation_gradient, i) + load_tensor(p.surface_term, i);
        const Tensor3 rate = load_tensor(p.points.velocity_gradient, i);
        store_tensor(p.deformation_gradient, i, F);
        store_correction(p, i, multiply(cofactor(F), K0));
        store_tensor(p.points.velocity_gradient, i, multiply(rate, inverse(F, determinant(F))));
      });
}

} // namespace

void correct_surface(const Particles& p, const Neighbors& n, const GhostPlanes& planes) {
  const bool initial = p.deformation_gradient.extent(0) > 0;
  const Sight see{p, n, initial ? n.build_position : p.position, initial};
  copy_to_ghosts<Ghosts::in_surface_gradient>("update_ghost_gradient", p, n, planes);
  find_surface_shifts(see);
  if (!initial) return add_changes(see, VelocityGradients{p.points.velocity_gradient});
  add_changes(see, DeformationRates{p.points.velocity_gradient, p.deformation_gradient});
  add_deformation(see);
}

} // namespace swarf
