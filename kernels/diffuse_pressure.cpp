// dp_i/dt = delta c' h sum_j V_j (p_i - p_j - (g_i + g_j).x_ij / 2) 2 (dW/dr)/r,  g = grad p, corrected
// Pressures that alternate from particle to particle do no work on any velocity gradient that the particles
// see: nothing else takes them away. The diffusion acts on what two neighbours' gradients do not explain, so
// that a smooth field keeps its gradient: Antuono et al. (2010) for the density of a fluid. c' and h:
// mass-scaled wave speed and smoothing length, means of the pair; the sum of V_i p_i is kept. The density
// goes with the pressure, d(ln rho) = dp / K: the volume of a particle whose pressure is taken away again and
// again would drift. So the sum of V_i is kept too, to first order, between particles of one K that are
// active and have not failed: the pressure of failed ones follows from their density. Reads stress, damage, K
// in pair_stress, volume, inverse_support, impedance; writes stress and density; moves the elastic energy
// that is lost from internal_work to hourglass_work.
#include "copy_to_ghosts.hpp"
#include "swarf/material/thermal.hpp"
#include "swarf/particles/pair.hpp"

namespace swarf {
namespace {

void prepare_pressure(const Particles& p) {
  Kokkos::parallel_for(
      "prepare_pressure", Range(0, p.count + p.tied), KOKKOS_LAMBDA(int i) {
        p.pressure_state(i, 0) = trace(load_symmetric(p.points.stress, i)) / Real(-3);
        for (int d = 0; d < 3; ++d) p.pressure_state(i, 1 + d) = 0;
      });
}

KOKKOS_INLINE_FUNCTION Vector3Of<Pack> sum_gradient(const Particles& p, const Neighbors& n, int cluster,
                                                    const Lanes& lanes) {
  const Pack zero(Real(0));
  Vector3Of<Pack> sum{zero, zero, zero};
  const auto x_i = lanes.load_vector(p.position);
  const Pack inverse_support_i = lanes.load(p.inverse_support);
  const Pack p_i = lanes.load(p.pressure_state, 0);
  for_each_neighbor(n, cluster, [&](int j) {
    const auto x_ij = x_i - broadcast_vector(p.position, j);
    const Pack slope = pair_slope(p.volume(j), x_ij, mean_inverse_h(inverse_support_i, p.inverse_support(j)));
    sum = sum + ((Pack(p.pressure_state(j, 0)) - p_i) * slope) * x_ij;
  });
  return sum;
}

void find_gradient(const Particles& p, const Neighbors& n) {
  Kokkos::parallel_for(
      "pressure_gradient", Range(0, n.clusters + n.tied_clusters), KOKKOS_LAMBDA(int cluster) {
        const Lanes lanes{n.first(cluster), n.size(cluster)};
        const auto sum = sum_gradient(p, n, cluster, lanes);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int i = lanes.first + lane;
          const Vector3 g = multiply(load_tensor(p.pair_stress, i), lane_of(sum, lane));
          p.pressure_state(i, 1) = g.x, p.pressure_state(i, 2) = g.y, p.pressure_state(i, 3) = g.z;
        }
      });
}

// Pa/s over delta
KOKKOS_INLINE_FUNCTION Pack sum_diffusion(const Particles& p, const Neighbors& n, int cluster,
                                          const Lanes& lanes) {
  Pack sum(Real(0));
  const auto x_i = lanes.load_vector(p.position);
  const Pack inverse_support_i = lanes.load(p.inverse_support), half(Real(0.5));
  const Pack p_i = lanes.load(p.pressure_state, 0);
  const Pack c_i = lanes.load(p.impedance, 0) / lanes.load(p.impedance, 1);
  const Vector3Of<Pack> g_i{lanes.load(p.pressure_state, 1), lanes.load(p.pressure_state, 2),
                            lanes.load(p.pressure_state, 3)};
  for_each_neighbor(n, cluster, [&](int j) {
    const auto x_ij = x_i - broadcast_vector(p.position, j);
    const Pack inverse_h = mean_inverse_h(inverse_support_i, p.inverse_support(j));
    const Vector3Of<Pack> g_j{Pack(p.pressure_state(j, 1)), Pack(p.pressure_state(j, 2)),
                              Pack(p.pressure_state(j, 3))};
    const Pack beyond_linear = p_i - Pack(p.pressure_state(j, 0)) - half * dot(g_i + g_j, x_ij);
    const Pack c = c_i + Pack(p.impedance(j, 0) / p.impedance(j, 1)); // twice the mean
    sum += c * reciprocal(inverse_h) * beyond_linear * pair_slope(p.volume(j), x_ij, inverse_h);
  });
  return sum;
}

} // namespace

void diffuse_pressure(const Particles& p, const Neighbors& n, const GhostPlanes& planes,
                      const MaterialTable& materials, const PressureDiffusion& set) {
  prepare_pressure(p);
  copy_to_ghosts<Ghosts::in_diffuse_pressure>("update_ghost_pressure", p, n, planes);
  find_gradient(p, n);
  copy_to_ghosts<Ghosts::in_diffuse_pressure>("update_ghost_pressure", p, n, planes);
  const MaterialPoints points = p.points;
  Kokkos::parallel_for(
      "diffuse_pressure", Range(0, n.clusters + n.tied_clusters), KOKKOS_LAMBDA(int cluster) {
        const Lanes lanes{n.first(cluster), n.size(cluster)};
        const Pack sum = sum_diffusion(p, n, cluster, lanes);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int i = lanes.first + lane;
          const Real change = set.coefficient * set.time * lane_of(sum, lane),
                     before = p.pressure_state(i, 0);
          const Material& mat = materials(points.material(i));
          const Real bulk_modulus = stiffness_share(mat, points.temperature(i)) * mat.bulk_modulus;
          for (int d = 0; d < 3; ++d) points.stress(i, d) -= change;
          if (set.density && points.damage(i) < Real(1))
            points.density(i) *= Kokkos::exp(change / bulk_modulus);
          // The forces at the end of the step are those of the changed stress: update_stress did not know.
          const Real rate = trace(symmetric_part(load_tensor(points.velocity_gradient, i)));
          points.internal_work(i) -= Real(0.5) * p.volume(i) * change * rate * set.step;
          const Real gained = p.volume(i) * change * (before + Real(0.5) * change) / bulk_modulus;
          points.internal_work(i) += gained;
          p.hourglass_work(i) -= gained;
        }
      });
}

} // namespace swarf
