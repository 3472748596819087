// The adjoint of correct_surface in the forces: with T_i = sigma_i (1 - n_i n_i - b_i b_i) the work of the
// stresses is
//   sum_i V_i [sigma_i : L_i + T_i : sum_j V_j (s~_i . grad W_ij) (L_j - L_i)] =
//       sum_k V_k (sigma_k + t_k) : L_k,
//   t_k = sum_i V_i T_i (s~_i . grad_i W_ik) - T_k sum_j V_j (s~_k . grad W_kj),
// L without what the surface adds, so that particle_forces needs no more than sigma + t in the place of
// sigma. In the initial frame sigma is the first Piola-Kirchhoff stress J sigma F^-T, and L is dF/dt. Reads
// position or build_position, deformation_gradient, volume, inverse_support, stress, surface_shift; writes t
// to surface_term, rows [0, count + tied).
#include "copy_to_ghosts.hpp"
#include "swarf/particles/pair.hpp"
#include "swarf/particles/surface.hpp"

namespace swarf {
namespace {

SWARF_FN Tensor3 stress_along_surface(const Particles& p, int i) {
  Tensor3 stress = to_tensor(load_symmetric(p.points.stress, i));
  if (p.deformation_gradient.extent(0) > 0)
    stress = multiply(stress, cofactor(load_tensor(p.deformation_gradient, i)));
  return along_surface(stress, surface_frame(p.surface_shift, p.edge_normal, i));
}

KOKKOS_FORCEINLINE_FUNCTION Tensor3Of<Pack> sum_stresses(const Particles& p, const Neighbors& n, int cluster,
                                                         const Lanes& lanes) {
  const Pack zero(Real(0));
  Tensor3Of<Pack> t{zero, zero, zero, zero, zero, zero, zero, zero, zero};
  const VectorField& from = p.deformation_gradient.extent(0) > 0 ? n.build_position : p.position;
  const auto x_k = lanes.load_vector(from);
  const Pack inverse_support_k = lanes.load(p.inverse_support);
  for_each_neighbor(n, cluster, [&](int i) {
    if (p.surface_shift(i, 0) == 0) return;
    const auto x_ki = x_k - broadcast_vector(from, i);
    const Pack slope = pair_slope(p.volume(i), x_ki, mean_inverse_h(inverse_support_k, p.inverse_support(i)));
    const Vector3 s = surface_frame(p.surface_shift, p.edge_normal, i).shift;
    const Pack share = slope * (Pack(-s.x) * x_ki.x + Pack(-s.y) * x_ki.y + Pack(-s.z) * x_ki.z);
    const Tensor3 T = stress_along_surface(p, i);
    t.xx += share * Pack(T.xx), t.xy += share * Pack(T.xy), t.xz += share * Pack(T.xz);
    t.yx += share * Pack(T.yx), t.yy += share * Pack(T.yy), t.yz += share * Pack(T.yz);
    t.zx += share * Pack(T.zx), t.zy += share * Pack(T.zy), t.zz += share * Pack(T.zz);
  });
  return t;
}

// Most ghosts are not at a surface: of these no more than that.
void show_ghosts(const Particles& p, const Neighbors& n, const GhostPlanes& planes) {
  const int first = n.ghost_first;
  const auto source = n.ghost_source;
  for (int k = 0; k < n.planes; ++k) {
    const Transform map = planes[std::size_t(k)].to_ghost;
    Kokkos::parallel_for(
        "surface_ghosts", Range(n.ghost_start[k], n.ghost_start[k + 1]), KOKKOS_LAMBDA(int ghost) {
          const int from = source(ghost), to = first + ghost;
          if (p.surface_shift(from, 0) == 0)
            p.surface_shift(to, 0) = 0;
          else
            for_each_field(p, CopyToGhost<Ghosts::in_surface_stress>{from, to, map});
        });
  }
}

} // namespace

void surface_stress(const Particles& p, const Neighbors& n, const GhostPlanes& planes) {
  show_ghosts(p, n, planes);
  Kokkos::parallel_for(
      "surface_stress", Range(0, n.clusters + n.tied_clusters), KOKKOS_LAMBDA(int cluster) {
        const Lanes lanes{n.first(cluster), n.size(cluster)};
        const auto sum = sum_stresses(p, n, cluster, lanes);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int k = lanes.first + lane;
          Tensor3 t = lane_of(sum, lane);
          if (p.surface_shift(k, 0) != 0) t = t + (-p.surface_shift(k, 0)) * stress_along_surface(p, k);
          store_tensor(p.surface_term, k, t);
        }
      });
}

} // namespace swarf
