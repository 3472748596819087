// m_i c_i dT_i/dt = V_i sum_j V_j k_ij e.(S_i + S_j) e (T_i - T_j) (dW/dr)/r,  k_ij = 2 k_i k_j / (k_i + k_j)
// Cleary & Monaghan (1999), e the direction of the pair: conservative pair by pair, monotone, and the flux is
// continuous where k jumps. S = K, but at a free surface s 1, s the least eigenvalue of K, one over the
// largest of A = K^-1 = sum_j V_j x_j (-W'/r) x_j: along a face, an edge or a sheet A lacks what neighbours
// there are not, and sum_i s_i t.A_i t, all that a plate or a rod conducts along itself, is what the material
// does. (The plain sum is 15 % short of it in a plate of 3 rows; K in the place of S 5 % above: large across
// the surface, it counts in pairs that are oblique.) Reads temperature, K in heat_shape
// (velocity_gradient.cpp), volume, inverse_support, mass. Writes S to heat_shape, heat (J, rows [0, count +
// tied)) and the temperature of rows [0, count); heat_state is its own.
#include "copy_to_ghosts.hpp"
#include "swarf/core/eigen.hpp"
#include "swarf/material/heat.hpp"
#include "swarf/particles/pair.hpp"

namespace swarf {
namespace {

// Least over largest eigenvalue of K: 0.63 in a face, 0.47 in an edge; 0.91 beside the ramp of a tie, where
// the material goes on in hexes; 0.96 in the second row.
constexpr Real surface_ratio = Real(0.8);

void prepare_heat_state(const Particles& p, const MaterialTable& materials) {
  const MaterialPoints points = p.points;
  Kokkos::parallel_for(
      "prepare_heat_state", Range(0, p.count + p.tied), KOKKOS_LAMBDA(int i) {
        p.heat_state(i, 0) = points.temperature(i);
        p.heat_state(i, 1) = conductivity_at(materials(points.material(i)), points.temperature(i));
        const Symmetric3 K = load_symmetric(p.heat_shape, i);
        const Real least = -largest_eigenvalue(Real(-1) * K);
        if (least < surface_ratio * largest_eigenvalue(K)) // not a second time: S has one eigenvalue
          store_symmetric(p.heat_shape, i, {least, least, least, 0, 0, 0});
      });
}

// W / m3
KOKKOS_INLINE_FUNCTION Pack sum_heat(const Particles& p, const Neighbors& n, int cluster,
                                     const Lanes& lanes) {
  const auto x_i = lanes.load_vector(p.position);
  const Pack inverse_support_i = lanes.load(p.inverse_support);
  const Pack T_i = lanes.load(p.heat_state, 0), k_i = lanes.load(p.heat_state, 1);
  const auto S_i = lanes.load_symmetric(p.heat_shape);
  const Pack none(Kokkos::Experimental::norm_min_v<Real>); // r = 0: the particle itself; k = 0: insulators
  Pack sum(Real(0));
  for_each_neighbor(n, cluster, [&](int j) {
    const auto x_ij = x_i - broadcast_vector(p.position, j);
    const Pack slope = pair_slope(p.volume(j), x_ij, mean_inverse_h(inverse_support_i, p.inverse_support(j)));
    const Pack shape =
        quadratic_form(S_i + broadcast_symmetric(p.heat_shape, j), x_ij) * reciprocal(dot(x_ij, x_ij) + none);
    const Pack k_j(p.heat_state(j, 1)), k_ij = Pack(Real(2)) * k_i * k_j * reciprocal(k_i + k_j + none);
    sum += shape * k_ij * (T_i - Pack(p.heat_state(j, 0))) * slope;
  });
  return sum;
}

} // namespace

void conduct_heat(const Particles& p, const Neighbors& n, const GhostPlanes& planes,
                  const MaterialTable& materials, Real dt) {
  if (p.count + p.tied == 0) return;
  prepare_heat_state(p, materials);
  copy_to_ghosts<Ghosts::in_conduct_heat>("update_ghost_heat", p, n, planes);
  const MaterialPoints points = p.points;
  const int count = p.count;
  Kokkos::parallel_for(
      "conduct_heat", Range(0, n.clusters + n.tied_clusters), KOKKOS_LAMBDA(int cluster) {
        const Lanes lanes{n.first(cluster), n.size(cluster)};
        const Pack sum = sum_heat(p, n, cluster, lanes);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int i = lanes.first + lane;
          p.heat(i) = dt * p.volume(i) * lane_of(sum, lane);
          if (i < count)
            points.temperature(i) =
                warmed_by(materials(points.material(i)), points.mass(i), points.temperature(i), p.heat(i));
        }
      });
}

} // namespace swarf
