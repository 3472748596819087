// rho_i = rho_0 S_i / S_i(0),  S_i = sum_j m_j W_ij over the neighbours and i itself: density by summation,
// relative to the sum on the undeformed lattice, so that a free surface keeps its density.
// m_j is V_j rho_j, which the ghosts carry. Where reference_summation is 0 the sum becomes the reference.
#include "swarf/kernels.hpp"
#include "swarf/particles/pair.hpp"

namespace swarf {
namespace {

KOKKOS_INLINE_FUNCTION Pack sum_mass(const Particles& p, const Neighbors& n, int cluster,
                                     const Lanes& lanes) {
  const auto x_i = lanes.load_vector(p.position);
  const Pack inverse_support_i = lanes.load(p.inverse_support);
  Pack sum(Real(0));
  for_each_neighbor(n, cluster, [&](int j) {
    const auto x_ij = x_i - broadcast_vector(p.position, j);
    const Pack W = pair_weight(x_ij, mean_inverse_h(inverse_support_i, p.inverse_support(j)));
    sum += Pack(p.volume(j) * p.impedance(j, 1)) * W;
  });
  return sum;
}

} // namespace

void sum_density(const Particles& p, const Neighbors& n, const MaterialTable& materials) {
  Kokkos::parallel_for(
      "sum_density", Range(0, n.clusters + n.tied_clusters), KOKKOS_LAMBDA(int cluster) {
        const Lanes lanes{n.first(cluster), n.size(cluster)};
        const Pack sum = sum_mass(p, n, cluster, lanes);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int i = lanes.first + lane;
          if (p.reference_summation(i) == Real(0)) p.reference_summation(i) = lane_of(sum, lane);
          p.points.density(i) =
              materials(p.points.material(i)).density * (lane_of(sum, lane) / p.reference_summation(i));
        }
      });
}

} // namespace swarf
