// Courant's condition at Courant number 1: h / c' for a particle, the hex's characteristic length / c' for a
// hex, c' = c / sqrt(mass factor) the wave speed of the scaled mass. Minima are exact in any order of
// threads.
#include "swarf/heat.hpp"
#include "swarf/kernels.hpp"

namespace swarf {

// Wave speed seen from the initial positions over c: of P = J sigma F^-T, squared, J |F^-1 F^-T| (its largest
// row sum: no less than its largest eigenvalue).
KOKKOS_INLINE_FUNCTION Real reference_speed_ratio(const Tensor3& F) {
  const Real J = determinant(F);
  const Tensor3 G = inverse(F, J), B = multiply(G, transpose(G));
  const Real row_sum = Kokkos::max(Kokkos::abs(B.xx) + Kokkos::abs(B.xy) + Kokkos::abs(B.xz),
                                   Kokkos::max(Kokkos::abs(B.yx) + Kokkos::abs(B.yy) + Kokkos::abs(B.yz),
                                               Kokkos::abs(B.zx) + Kokkos::abs(B.zy) + Kokkos::abs(B.zz)));
  return Kokkos::sqrt(Kokkos::abs(J) * row_sum);
}

using MinStep = Kokkos::MinLoc<Real, int>;

StableStep stable_step(const Particles& p, const Neighbors& n, const MaterialTable& materials,
                       Real mass_factor) {
  StableStep result;
  if (p.count == 0) return result;
  MinStep::value_type least;
  const auto build = n.build_position;
  const auto material = p.points.material;
  const bool initial_frame = p.deformation_gradient.extent(0) > 0;
  Kokkos::parallel_reduce(
      "stable_step", Range(0, p.count),
      KOKKOS_LAMBDA(int i, MinStep::value_type& dt) {
        Real own = p.smoothing_length(i) * Kokkos::sqrt(mass_factor) /
                   longitudinal_wave_speed(materials(material(i)));
        if (initial_frame) own /= reference_speed_ratio(load_tensor(p.deformation_gradient, i));
        if (own < dt.val || (own == dt.val && i < dt.loc)) dt.val = own, dt.loc = i;
      },
      MinStep(least));
  Real moved2 = 0;
  Kokkos::parallel_reduce(
      "max_displacement", Range(0, p.count + p.tied),
      KOKKOS_LAMBDA(int i, Real& far) {
        const Vector3 d = load_vector(p.position, i) - load_vector(build, i);
        far = Kokkos::max(far, dot(d, d));
      },
      Kokkos::Max<Real>(moved2));
  return {least.val, least.loc, Kokkos::sqrt(moved2)};
}

StableStep stable_step(const HexMesh& m, const MaterialTable& materials, Real mass_factor) {
  StableStep result;
  if (m.points.count == 0) return result;
  MinStep::value_type least;
  const auto material = m.points.material;
  Kokkos::parallel_reduce(
      "stable_step_hexes", Range(0, m.points.count),
      KOKKOS_LAMBDA(int e, MinStep::value_type& dt) {
        if (m.active(e) != hex_active) return;
        const Real own = characteristic_length(m, e) * Kokkos::sqrt(mass_factor) /
                         longitudinal_wave_speed(materials(material(e)));
        if (own < dt.val || (own == dt.val && e < dt.loc)) dt.val = own, dt.loc = e;
      },
      MinStep(least));
  return {least.val, least.loc, Real(0)};
}

Real stable_heat_step(const Particles& p, const MaterialTable& materials) {
  Real least = Kokkos::Experimental::infinity_v<Real>;
  const auto material = p.points.material;
  Kokkos::parallel_reduce(
      "stable_heat_step", Range(0, p.count + p.tied),
      KOKKOS_LAMBDA(int i, Real& dt) {
        dt = Kokkos::min(dt, conduction_step(materials(material(i)), p.smoothing_length(i)));
      },
      Kokkos::Min<Real>(least));
  return least;
}

Real stable_heat_step(const HexMesh& m, const MaterialTable& materials) {
  Real least = Kokkos::Experimental::infinity_v<Real>;
  const auto material = m.points.material;
  Kokkos::parallel_reduce(
      "stable_heat_step_hexes", Range(0, m.points.count),
      KOKKOS_LAMBDA(int e, Real& dt) {
        if (m.active(e) == hex_active)
          dt = Kokkos::min(dt, conduction_step(materials(material(e)), characteristic_length(m, e)));
      },
      Kokkos::Min<Real>(least));
  return least;
}

} // namespace swarf
