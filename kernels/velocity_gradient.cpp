// L_i = [sum_j V_j (v_j - v_i) (x) grad W_ij] K_i,  K_i = [sum_j V_j (x_j - x_i) (x) grad W_ij]^-1
// Randles & Libersky (1996): exact for a linear velocity field on any set of neighbours.
// Reads position, velocity, volume, inverse_support. Writes velocity_gradient, K to pair_stress and
// heat_shape, how far neighbours lack to surface_shift (tied particles have no surface), rows [0, count +
// tied), and the lists' marks.
#include "store_correction.hpp"
#include "swarf/particles/pair.hpp"
#include "swarf/particles/surface.hpp"

namespace swarf {
namespace {

struct GradientSums {
  Tensor3Of<Pack> L;    // uncorrected
  Symmetric3Of<Pack> A; // inverse of K
};

KOKKOS_FORCEINLINE_FUNCTION void add_pair(GradientSums& s, const Vector3Of<Pack>& x_ij,
                                          const Vector3Of<Pack>& v_ji, const Pack& slope) {
  const auto grad = slope * x_ij; // V_j grad W_ij
  s.L.xx += v_ji.x * grad.x, s.L.xy += v_ji.x * grad.y, s.L.xz += v_ji.x * grad.z;
  s.L.yx += v_ji.y * grad.x, s.L.yy += v_ji.y * grad.y, s.L.yz += v_ji.y * grad.z;
  s.L.zx += v_ji.z * grad.x, s.L.zy += v_ji.z * grad.y, s.L.zz += v_ji.z * grad.z;
  s.A.xx -= x_ij.x * grad.x, s.A.yy -= x_ij.y * grad.y, s.A.zz -= x_ij.z * grad.z;
  s.A.xy -= x_ij.x * grad.y, s.A.yz -= x_ij.y * grad.z, s.A.zx -= x_ij.z * grad.x;
}

struct Cluster {
  Vector3Of<Pack> x, v;
  Pack inverse_support;
};

// Neighbours are taken a few at a time: first their slopes, whose roots are long, then the sums of those that
// are near. In one go a pair is a chain of operations longer than a processor looks ahead: a tenth slower.
constexpr int pair_chunk = pack_width > 1 ? entries_of_word : 1;

KOKKOS_FORCEINLINE_FUNCTION Marks add_near(GradientSums& s, const Cluster& i, const Particles& p,
                                           const int* row, int count) {
  Pack slope[pair_chunk]; // V_j (dW/dr) / r
  int near_row[pair_chunk], found = 0;
  Marks near = 0;
  for (int k = 0; k < count; ++k) { // no branch
    const int j = row[k];
    const auto x_ij = i.x - broadcast_vector(p.position, j);
    const Pack inverse_h = mean_inverse_h(i.inverse_support, p.inverse_support(j));
    const bool is_near = any_near(x_ij, inverse_h);
    slope[found] = pair_slope(p.volume(j), x_ij, inverse_h);
    near_row[found] = j, found += is_near;
    near |= Marks(is_near) << k;
  }
  for (int k = 0; k < found; ++k) {
    const int j = near_row[k];
    add_pair(s, i.x - broadcast_vector(p.position, j), broadcast_vector(p.velocity, j) - i.v, slope[k]);
  }
  return near;
}

KOKKOS_FORCEINLINE_FUNCTION GradientSums sum_neighbors(const Particles& p, const Neighbors& n, int cluster,
                                                       const Lanes& lanes) {
  const Pack zero(Real(0));
  GradientSums s{{zero, zero, zero, zero, zero, zero, zero, zero, zero},
                 {zero, zero, zero, zero, zero, zero}};
  const Cluster i{lanes.load_vector(p.position), lanes.load_vector(p.velocity),
                  lanes.load(p.inverse_support)};
  mark_neighbors<pair_chunk>(n, cluster,
                             [&](const int* row, int count) { return add_near(s, i, p, row, count); });
  return s;
}

} // namespace

void velocity_gradient(const Particles& p, const Neighbors& n, const ParticleMethod& method) {
  const bool correct = method.correction, surfaces = p.surface_shift.extent(0) > 0;
  Kokkos::parallel_for(
      "velocity_gradient", Range(0, n.clusters + n.tied_clusters), KOKKOS_LAMBDA(int cluster) {
        const Lanes lanes{n.first(cluster), n.size(cluster)};
        const GradientSums s = sum_neighbors(p, n, cluster, lanes);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int i = lanes.first + lane;
          const Symmetric3 A = lane_of(s.A, lane);
          const Correction at = correct ? correction_from(A, i >= p.count) : Correction{identity3(), false};
          store_correction(p, i, at.K);
          if (surfaces) p.surface_shift(i, 0) = i < p.count && at.exact ? lacking_neighbors(A) : Real(0);
          store_tensor(p.points.velocity_gradient, i, multiply(lane_of(s.L, lane), at.K));
        }
      });
}

} // namespace swarf
