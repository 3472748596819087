// The stable step, Courant number 1. Particles: 2 over the highest frequency of their waves
// (advance_mode.cpp; 1.8 h / c' inside a lattice, 1.07 of one with faces and edges, 0.75 of one two rows
// thick), less where viscosity or stiffness against hourglass modes ask it. Hexes: 2 over the highest
// frequency of a free hex. c' = c / sqrt(mass factor), the wave speed of the scaled mass. Minima are exact in
// any order of threads.
#include "cell_order.hpp"
#include "swarf/hexes/hex8.hpp"
#include "swarf/kernels.hpp"
#include "swarf/material/heat.hpp"

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

KOKKOS_INLINE_FUNCTION Real expansion_rate(const MaterialPoints& points, int i) { // 1/s
  const Tensor3 L = load_tensor(points.velocity_gradient, i);
  return L.xx + L.yy + L.zz;
}

// Where the planes of a lattice move against each other no velocity gradient sees it, and the pair terms of
// particle_forces.cpp alone make the mode: damping alpha dashpots c / h, frequency^2 kappa G springs / rho
// h^2. Cubic lattices of h = 0.9 to 1.8 spacings have at most, over all wave vectors,
//   dashpots = sum_j 2 V |dW/dr| / r x^2 h^2 / (r^2 + 0.01 h^2) over such planes,
//   springs: 4 dashpots less what evolve_hourglass gives, where the pair's own motion counts twice in a step.
constexpr Real dashpots = Real(1.61), springs = Real(4.05);

// Largest step of that mode over h / c'. The shock's viscosity acts on the half of the pairs that approach.
// slowness: h / c', s.
KOKKOS_INLINE_FUNCTION Real step_of_pair_terms(const ParticleMethod& m, const Material& mat, Real slowness,
                                               Real rate) {
  const Real c = longitudinal_wave_speed(mat);
  const Real alpha = m.viscosity_linear + m.viscosity_quadratic * slowness * Kokkos::max(-rate, Real(0));
  const Real stiffness = m.hourglass_stiffness * mat.shear_modulus / (mat.density * c * c);
  const Real w2 = stiffness * (m.initial_frame ? dashpots : springs);
  return damped_step(w2, alpha * dashpots);
}

using MinStep = Kokkos::MinLoc<Real, int>;

// The two largest displacements since the lists were built: a pair comes nearer by no more than both, and a
// fragment that flies alone by little more than its own. Ghosts count, for a mirror's comes to meet its
// particle. (Ties: whichever row is taken, the other has as much.)
Real largest_approach(const Particles& p, const Neighbors& n) {
  const VectorField position = p.position, build = n.build_position;
  const SeenRows moving{p.count + p.tied, p.stored, p.total};
  using Farthest = Kokkos::MaxLoc<Real, int>;
  Farthest::value_type farthest;
  Kokkos::parallel_reduce(
      "farthest", Range(0, moving.count()),
      KOKKOS_LAMBDA(int k, Farthest::value_type& far) {
        const Vector3 d = load_vector(position, moving(k)) - load_vector(build, moving(k));
        if (dot(d, d) > far.val) far.val = dot(d, d), far.loc = k;
      },
      Farthest(farthest));
  const int but = farthest.loc;
  Real next2 = 0;
  Kokkos::parallel_reduce(
      "farthest_but_one", Range(0, moving.count()),
      KOKKOS_LAMBDA(int k, Real& far) {
        const Vector3 d = load_vector(position, moving(k)) - load_vector(build, moving(k));
        if (k != but) far = Kokkos::max(far, dot(d, d));
      },
      Kokkos::Max<Real>(next2));
  return Kokkos::sqrt(Kokkos::max(farthest.val, Real(0))) + Kokkos::sqrt(Kokkos::max(next2, Real(0)));
}

StableStep stable_step(const Particles& p, const Neighbors& n, const MaterialTable& materials,
                       const ParticleStep& step) {
  StableStep result;
  if (p.count == 0) return result;
  MinStep::value_type least;
  const MaterialPoints points = p.points;
  const bool initial_frame = p.deformation_gradient.extent(0) > 0;
  const ParticleMethod method = step.method;
  const Real of_waves = step.of_waves;
  Kokkos::parallel_reduce(
      "stable_step", Range(0, p.count),
      KOKKOS_LAMBDA(int i, MinStep::value_type& dt) {
        const Material& mat = materials(points.material(i));
        Real own = p.smoothing_length(i) * Kokkos::sqrt(method.mass_factor) / longitudinal_wave_speed(mat);
        own = Kokkos::min(of_waves, own * step_of_pair_terms(method, mat, own, expansion_rate(points, i)));
        if (initial_frame) own /= reference_speed_ratio(load_tensor(p.deformation_gradient, i));
        if (own < dt.val || (own == dt.val && i < dt.loc)) dt.val = own, dt.loc = i;
      },
      MinStep(least));
  return {least.val, least.loc, largest_approach(p, n)};
}

StableStep stable_step(const HexMesh& m, const MaterialTable& materials, const HexMethod& set) {
  StableStep result;
  if (m.points.count == 0) return result;
  MinStep::value_type least;
  const MaterialPoints points = m.points;
  Kokkos::parallel_reduce(
      "stable_step_hexes", Range(0, m.points.count),
      KOKKOS_LAMBDA(int e, MinStep::value_type& dt) {
        if (m.active(e) != hex_active) return;
        const Material& mat = materials(points.material(e));
        const HexVectors B = load_gradient(m.gradient, e);
        const Real volume = m.volume(e);
        const HexInertia scaled{set.mass_factor * points.density(e),
                                longitudinal_wave_speed(mat) / Kokkos::sqrt(set.mass_factor)};
        const bool stiffness = set.hourglass == HourglassControl::stiffness;
        const Real coefficient = stiffness ? hourglass_stiffness(mat, set.hourglass_coefficient, volume, B)
                                           : hourglass_damping(scaled, set.hourglass_coefficient, volume);
        const Real rate = expansion_rate(points, e);
        const Real own = Kokkos::min(wave_step(mat, scaled, {set.viscosity_linear, set.viscosity_quadratic},
                                               gradient_moments(B), rate),
                                     hourglass_step(stiffness, coefficient, scaled.density * volume));
        if (own < dt.val || (own == dt.val && e < dt.loc)) dt.val = own, dt.loc = e;
      },
      MinStep(least));
  if (least.val == Kokkos::Experimental::infinity_v<Real>) return result; // none is active
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
