// d_i of shifting.hpp for the particles of each cluster that has flowed since it was shifted last, and n of
// those at a surface: outward, against the normal force of the tool or down the gradient of the
// concentration. Where neighbours are at a surface is known from the last shift. Those of another material
// are not counted: where two meet each has a surface. Reads position, volume, inverse_support,
// equivalent_plastic_strain, shifted_strain, contact_force, friction_force, constraints, surface_normal.
#include "cell_order.hpp"
#include "copy_to_ghosts.hpp"
#include "swarf/particles/correction.hpp"
#include "swarf/particles/pair.hpp"
#include "swarf/particles/shifting.hpp"

namespace swarf {
namespace {

// m; what a face holds or is frozen does not move.
SWARF_FN Real allowed_shift(const Particles& p, int i) {
  if (p.constraints(i) != 0) return 0;
  const Real strain = p.points.equivalent_plastic_strain(i) - p.shifted_strain(i);
  return shift_per_strain * Kokkos::max(strain, Real(0)) * Kokkos::cbrt(p.volume(i));
}

IndexField clusters_that_flowed(const Particles& p, const Neighbors& n) {
  const IndexField place("clusters_that_flowed", n.clusters);
  Kokkos::parallel_for(
      "clusters_that_flowed", Range(0, n.clusters), KOKKOS_LAMBDA(int c) {
        bool flowed = false;
        for (int i = n.first(c); i < n.first(c) + n.size(c); ++i) flowed = flowed || allowed_shift(p, i) > 0;
        place(c) = flowed ? 1 : 0;
      });
  const IndexField list("clusters_that_flowed", number_taken(place));
  Kokkos::parallel_for(
      "clusters_that_flowed", Range(0, n.clusters), KOKKOS_LAMBDA(int c) {
        if (place(c) >= 0) list(place(c)) = c;
      });
  return list;
}

struct Sums {
  Vector3Of<Pack> gradient, pairing, surface; // surface without V_i
  Symmetric3Of<Pack> A;
};

KOKKOS_FORCEINLINE_FUNCTION Sums sum_neighbors(const Particles& p, const Neighbors& n, int cluster,
                                               const Lanes& lanes, const Pack& at_spacing) {
  const Pack zero(Real(0));
  const Vector3Of<Pack> none{zero, zero, zero};
  Sums s{none, none, none, {zero, zero, zero, zero, zero, zero}};
  const auto x_i = lanes.load_vector(p.position);
  const Pack inverse_support_i = lanes.load(p.inverse_support);
  const Pack material_i = make_pack([&](int lane) { return Real(p.points.material(lanes.row(lane))); });
  for_each_neighbor(n, cluster, [&](int j) {
    const auto x_ij = x_i - broadcast_vector(p.position, j);
    const Pack inverse_h = mean_inverse_h(inverse_support_i, p.inverse_support(j));
    const Pack same = select(material_i == Pack(Real(p.points.material(j))), Pack(Real(1)), zero);
    const Pack shape = kernel_shape(Kokkos::sqrt(dot(x_ij, x_ij)) * inverse_h), f = shape * at_spacing;
    const auto grad = (same * pair_slope(p.volume(j), x_ij, inverse_h)) * x_ij;
    s.gradient = s.gradient + grad;
    s.pairing = s.pairing + ((f * f) * (f * f)) * grad;
    s.surface = s.surface +
                (same * inverse_h * inverse_h * inverse_h * shape) * broadcast_vector(p.surface_normal, j);
    s.A.xx -= x_ij.x * grad.x, s.A.yy -= x_ij.y * grad.y, s.A.zz -= x_ij.z * grad.z;
    s.A.xy -= x_ij.x * grad.y, s.A.yz -= x_ij.y * grad.z, s.A.zx -= x_ij.z * grad.x;
  });
  return s;
}

} // namespace

Shifts find_shifts(const Particles& p, const Neighbors& n, const GhostPlanes& planes,
                   const ParticleMethod& method) {
  Shifts found;
  found.cluster = clusters_that_flowed(p, n);
  const int clusters = found.clusters(), slots = clusters * pack_width;
  if (clusters == 0) return found;
  copy_to_ghosts<Ghosts::in_find_shifts>("update_ghost_normal", p, n, planes);
  found.displacement = VectorField("shift_displacement", slots);
  found.corrected = VectorField("shift_corrected", slots);
  found.normal = VectorField("shift_normal", slots);
  const Pack at_spacing(Real(1) / kernel_shape(method.spacing_ratio));
  Kokkos::parallel_for(
      "find_shifts", Range(0, clusters), KOKKOS_LAMBDA(int k) {
        const int cluster = found.cluster(k);
        const Lanes lanes{n.first(cluster), n.size(cluster)};
        const Sums s = sum_neighbors(p, n, cluster, lanes, at_spacing);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int i = lanes.first + lane, slot = k * pack_width + lane;
          const Symmetric3 A = lane_of(s.A, lane);
          const ShiftSums sums{lane_of(s.gradient, lane), lane_of(s.pairing, lane), A,
                               p.volume(i) * lane_of(s.surface, lane)};
          const Vector3 contact = load_vector(p.contact_force, i); // none: friction may still be remembered
          const Vector3 pressed =
              dot(contact, contact) > 0 ? contact - load_vector(p.friction_force, i) : contact;
          const Shift shift = shift_of(
              sums, {p.smoothing_length(i), Kokkos::cbrt(p.volume(i)), allowed_shift(p, i), pressed});
          store_vector(found.displacement, slot, shift.displacement);
          store_vector(found.corrected, slot, multiply(correction_from(A).K, shift.displacement));
          store_vector(found.normal, slot, shift.normal);
        }
      });
  return found;
}

} // namespace swarf
