// XSPH (Monaghan 1989, J. Comput. Phys. 82): particles move with
//   v_i + epsilon sum_j m_j / rho_ij (v_j - v_i) W_ij,  rho_ij = (rho_i + rho_j) / 2,
// which is symmetric in i and j, so that the mass centre moves as before. What a face holds stays held.
// Reads position, velocity, volume, impedance, inverse_support, constraints; writes drift_velocity, rows
// [0, count).
#include "swarf/kernels.hpp"
#include "swarf/pair.hpp"

namespace swarf {
namespace {

KOKKOS_INLINE_FUNCTION Vector3Of<Pack> sum_differences(const Particles& p, const Neighbors& n, int cluster,
                                                       const Lanes& lanes) {
  const Pack zero(Real(0));
  Vector3Of<Pack> sum{zero, zero, zero};
  const auto x_i = lanes.load_vector(p.position), v_i = lanes.load_vector(p.velocity);
  const Pack inverse_support_i = lanes.load(p.inverse_support);
  const Pack rho_i = lanes.load(p.impedance, 1);
  for_each_neighbor(n, cluster, [&](int j) {
    const auto x_ij = x_i - broadcast_vector(p.position, j);
    const Pack W = pair_weight(x_ij, mean_inverse_h(inverse_support_i, p.inverse_support(j)));
    const Pack rho_j(p.impedance(j, 1)); // mass-scaled, as rho_i: the factor cancels
    const Pack share = Pack(Real(2) * p.volume(j)) * rho_j * reciprocal(rho_i + rho_j);
    sum = sum + (share * W) * (broadcast_vector(p.velocity, j) - v_i);
  });
  return sum;
}

} // namespace

void smooth_velocity(const Particles& p, const Neighbors& n, const ConstraintTable& constraints,
                     Real epsilon) {
  Kokkos::parallel_for(
      "smooth_velocity", Range(0, n.clusters), KOKKOS_LAMBDA(int cluster) {
        const Lanes lanes{n.first(cluster), n.size(cluster)};
        const auto sum = sum_differences(p, n, cluster, lanes);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int i = lanes.first + lane;
          const Real share =
              p.constraints(i) & follows_bit ? Real(0) : epsilon; // a held row stays with its face
          const Vector3 v = load_vector(p.velocity, i) + share * lane_of(sum, lane);
          store_vector(p.drift_velocity, i, constrain(v, p.constraints(i), constraints));
        }
      });
}

} // namespace swarf
