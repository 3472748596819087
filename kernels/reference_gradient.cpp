// Total Lagrangian SPH (Vignjevic, Reveles & Campbell 2006): sums over the initial lattice X, its volumes V0
// and its correction K0, so that neither stretch nor rotation changes what a kernel sees.
//   F_i = 1 + [sum_j V0_j (u_j - u_i) (x) grad W(X_ij)] K0_i,  u = x - X
//   L_i = [sum_j V0_j (v_j - v_i) (x) grad W(X_ij)] K0_i F_i^-1
// The correction J F^-T K0 makes sigma the first Piola-Kirchhoff stress times K0: the forces of
// particle_forces, with grad W(X_ij), then do the work of the stresses, V0 J sigma : L.
// Reads position, velocity, volume (V0), inverse_support, build_position (X). Writes velocity_gradient, the
// correction to pair_stress and heat_shape, deformation_gradient, how far neighbours lack to surface_shift,
// rows [0, count + tied), and marks. Where J <= 0 the density becomes negative: update_stress reports it.
#include "store_correction.hpp"
#include "swarf/particles/pair.hpp"
#include "swarf/particles/surface.hpp"

namespace swarf {
namespace {

using PackTensor = Tensor3Of<Pack>;

struct ReferenceSums {
  PackTensor displacement, velocity; // gradients, uncorrected
  Symmetric3Of<Pack> A;              // inverse of K0
};

KOKKOS_FORCEINLINE_FUNCTION void add_outer(PackTensor& sum, const Vector3Of<Pack>& a,
                                           const Vector3Of<Pack>& b) {
  sum.xx += a.x * b.x, sum.xy += a.x * b.y, sum.xz += a.x * b.z;
  sum.yx += a.y * b.x, sum.yy += a.y * b.y, sum.yz += a.y * b.z;
  sum.zx += a.z * b.x, sum.zy += a.z * b.y, sum.zz += a.z * b.z;
}

KOKKOS_INLINE_FUNCTION ReferenceSums sum_neighbors(const Particles& p, const Neighbors& n, int cluster,
                                                   const Lanes& lanes) {
  const Pack zero(Real(0));
  const PackTensor none{zero, zero, zero, zero, zero, zero, zero, zero, zero};
  ReferenceSums s{none, none, {zero, zero, zero, zero, zero, zero}};
  const auto X_i = lanes.load_vector(n.build_position), v_i = lanes.load_vector(p.velocity);
  const auto u_i = lanes.load_vector(p.position) - X_i;
  const Pack inverse_support_i = lanes.load(p.inverse_support);
  mark_neighbors<1>(n, cluster, [&](const int* row, int) {
    const int j = *row;
    const auto X_j = broadcast_vector(n.build_position, j), X_ij = X_i - X_j;
    const Pack inverse_h = mean_inverse_h(inverse_support_i, p.inverse_support(j));
    const auto grad = pair_slope(p.volume(j), X_ij, inverse_h) * X_ij;
    add_outer(s.displacement, broadcast_vector(p.position, j) - X_j - u_i, grad);
    add_outer(s.velocity, broadcast_vector(p.velocity, j) - v_i, grad);
    s.A.xx -= X_ij.x * grad.x, s.A.yy -= X_ij.y * grad.y, s.A.zz -= X_ij.z * grad.z;
    s.A.xy -= X_ij.x * grad.y, s.A.yz -= X_ij.y * grad.z, s.A.zx -= X_ij.z * grad.x;
    return Marks(any_near(X_ij, inverse_h));
  });
  return s;
}

} // namespace

void reference_gradient(const Particles& p, const Neighbors& n) {
  const bool surfaces = p.surface_shift.extent(0) > 0;
  Kokkos::parallel_for(
      "reference_gradient", Range(0, n.clusters + n.tied_clusters), KOKKOS_LAMBDA(int cluster) {
        const Lanes lanes{n.first(cluster), n.size(cluster)};
        const ReferenceSums s = sum_neighbors(p, n, cluster, lanes);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int i = lanes.first + lane;
          const Symmetric3 A = lane_of(s.A, lane);
          const auto [K0, exact] = correction_from(A, i >= p.count);
          if (surfaces) p.surface_shift(i, 0) = i < p.count && exact ? lacking_neighbors(A) : Real(0);
          const Tensor3 F = identity3() + multiply(lane_of(s.displacement, lane), K0);
          const Real J = determinant(F);
          const Tensor3 inverse_F = inverse(F, J);
          store_tensor(p.deformation_gradient, i, F);
          store_correction(p, i, multiply(cofactor(F), K0));
          store_tensor(p.points.velocity_gradient, i,
                       multiply(multiply(lane_of(s.velocity, lane), K0), inverse_F));
        }
      });
}

} // namespace swarf
