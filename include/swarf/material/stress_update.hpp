// One material update for particles and hexes: objective trial stress, radial return, heat and damage.
#pragma once
#include "swarf/material/flow_law.hpp"
#include "swarf/material/thermal.hpp"

namespace swarf {

struct MaterialState {
  Symmetric3 stress;              // Cauchy, Pa
  Real density;                   // kg/m3
  Real equivalent_plastic_strain; //
  Real plastic_strain_rate;       // 1/s
  Real temperature;               // K
  Real damage;                    // 0 intact .. 1 failed
};

struct StressUpdate {
  MaterialState state;
  Real internal_work; // J/kg of this step, mean stress : strain increment / density
  Real plastic_work;  // J/kg of this step, its plastic part
  int iterations;     // of the return mapping
  bool converged;
};

// What one step does to a point: x_n -> x_n+1 with increments at the midpoint.
struct StepMotion {
  Symmetric3 strain; // D dt
  Tensor3 rotation;  // Q
  Real dilution;     // rho_n+1 / rho_n - 1
};

// Q = (I - w/2)^-1 (I + w/2) in closed form for the antisymmetric w: a rotation up to round-off, whatever its
// angle (Hughes & Winget 1980).
SWARF_FN Tensor3 incremental_rotation(const Tensor3& gradient) {
  const Real quarter = Real(0.25); // half of the axial vector of w
  const Vector3 a{quarter * (gradient.zy - gradient.yz), quarter * (gradient.xz - gradient.zx),
                  quarter * (gradient.yx - gradient.xy)};
  const Real s = Real(2) / (Real(1) + dot(a, a));
  return {Real(1) - s * (a.y * a.y + a.z * a.z),
          s * (a.x * a.y - a.z),
          s * (a.x * a.z + a.y),
          s * (a.x * a.y + a.z),
          Real(1) - s * (a.x * a.x + a.z * a.z),
          s * (a.y * a.z - a.x),
          s * (a.x * a.z - a.y),
          s * (a.y * a.z + a.x),
          Real(1) - s * (a.x * a.x + a.y * a.y)};
}

// The step drifts with the velocities of its middle and takes L at its end, so x_n = (I - L dt) x_n+1. The
// gradient on the midpoint is then L (I - L dt/2)^-1, whose symmetric part is 0 in every rigid rotation,
// however large, and det(I - L dt) is the ratio of the volumes.
SWARF_FN StepMotion step_motion(const Tensor3& L, Real dt) {
  const Tensor3 G{dt * L.xx, dt * L.xy, dt * L.xz, dt * L.yx, dt * L.yy,
                  dt * L.yz, dt * L.zx, dt * L.zy, dt * L.zz};
  const Real h = Real(-0.5);
  const Tensor3 to_midpoint{1 + h * G.xx, h * G.xy, h * G.xz, h * G.yx,    1 + h * G.yy,
                            h * G.yz,     h * G.zx, h * G.zy, 1 + h * G.zz};
  const Tensor3 midpoint = multiply(G, inverse(to_midpoint, determinant(to_midpoint)));
  const Real minors = G.xx * G.yy - G.xy * G.yx + G.yy * G.zz - G.yz * G.zy + G.zz * G.xx - G.zx * G.xz;
  return {symmetric_part(midpoint), incremental_rotation(midpoint),
          minors - (G.xx + G.yy + G.zz) - determinant(G)};
}

// Jaumann rate of a hypoelastic solid. Half of the elastic increment turns with the step: second order in
// time.
// stiffness: share of the moduli at the point's temperature.
SWARF_FN Symmetric3 trial_stress(const Material& mat, const Symmetric3& stress, const StepMotion& motion,
                                 Real stiffness = 1) {
  const Real G = stiffness * mat.shear_modulus, K = stiffness * mat.bulk_modulus;
  const Real lambda_trace = (K - Real(2) / Real(3) * G) * trace(motion.strain) * Real(0.5);
  const Symmetric3 half = G * motion.strain + Symmetric3{lambda_trace, lambda_trace, lambda_trace, 0, 0, 0};
  return rotate(motion.rotation, stress + half) + half;
}

struct ReturnMapping {
  Real increment;   // of the equivalent plastic strain
  Real flow_stress; // at the end of the step, Pa
  Real residual;    // Pa
  int iterations;
  bool converged;
};

inline constexpr Real return_tolerance = sizeof(Real) == 8 ? Real(1e-10) : Real(1e-5); // of the flow stress
inline constexpr int return_max_iterations = 100;

// Solves  q_trial - 3 G d - sigma_y(eps + d, d / dt) = 0  for d (Simo & Hughes 1998, box 3.1) by Newton's
// method inside the bracket [0, q_trial / 3G]. Where n < 1 the residual is steep near d = 0 and convex, and
// Newton's method is safe from the left: a step that leaves the bracket below goes far to the left inside it
// instead. The temperature in sigma_y is that of the step's start: d is then unique, and one step of 1e-3
// plastic strain lags by less than 0.05 % of the flow stress of Ti-6Al-4V.
template <class Law, class Thermal>
SWARF_FN ReturnMapping return_radially(const Law& law, Real three_G, Real trial_von_mises,
                                       Real plastic_strain, Real dt, const Thermal& thermal,
                                       int max_iterations = return_max_iterations) {
  const Real start_stress = law.stress(plastic_strain, 0, dt, thermal).value;
  Real low = 0, high = trial_von_mises / three_G;
  if (start_stress <= Real(0)) return {high, 0, 0, 0, true};
  Real residual = trial_von_mises - start_stress;
  if (residual <= return_tolerance * start_stress) return {0, start_stress, residual, 0, true};
  Real d = law.first_increment(residual, plastic_strain, thermal, three_G);
  FlowStress flow{start_stress, 0};
  // Near melting the flow stress vanishes before the terms whose difference the residual is.
  const Real round_off = Real(4) * Kokkos::Experimental::epsilon_v<Real> * trial_von_mises;
  for (int k = 1; k <= max_iterations; ++k) {
    flow = law.stress(plastic_strain + d, d, dt, thermal);
    residual = trial_von_mises - three_G * d - flow.value;
    if (Kokkos::abs(residual) <= return_tolerance * flow.value + round_off)
      return {d, flow.value, residual, k, true};
    (residual > Real(0) ? low : high) = d;
    d += residual / (three_G + flow.slope);
    if (!(d < high)) d = Real(0.5) * (low + high);
    if (!(d > low)) d = low + (high - low) / Real(64);
  }
  return {d, flow.value, residual, max_iterations, false};
}

// Share of the trial deviator that the radial return left, sigma_y / (sigma_y + 3 G d eps).
SWARF_FN Real share_kept(const Material& mat, const Symmetric3& stress, Real plastic_increment) {
  if (!(plastic_increment > Real(0))) return 1;
  const Real flow = von_mises(stress);
  return flow / (flow + Real(3) * mat.shear_modulus * plastic_increment);
}

// The trial stress as it is where it does not flow.
SWARF_FN ReturnMapping yield(const Material& mat, Real trial_von_mises, const MaterialState& start, Real dt) {
  const ReturnMapping elastic{0, trial_von_mises, 0, 0, true};
  return visit_law(mat, [&](const auto& law) {
    if (trial_von_mises <= law.elastic_limit(start.temperature)) return elastic;
    const auto thermal = law.thermal(start.temperature);
    const Real plastic_strain = start.equivalent_plastic_strain;
    if (!(trial_von_mises > law.stress(plastic_strain, 0, dt, thermal).value)) return elastic;
    const Real three_G = Real(3) * (stiffness_share(mat, start.temperature) * mat.shear_modulus);
    return return_radially(law, three_G, trial_von_mises, plastic_strain, dt, thermal);
  });
}

// Johnson & Cook (1985) cumulative damage. A failed point keeps no deviator and no tension: its pressure
// follows from its density, so that it pushes back only where it is denser than the undeformed material, as
// far as that has expanded.
SWARF_FN void damage_point(const Material& mat, Real increment, Real von_mises_stress, MaterialState& s) {
  if (increment > Real(0) && s.damage < Real(1)) {
    const Real mean = trace(s.stress) / Real(3);
    const Real strain = von_mises_stress > Real(0) ? fracture_strain(mat, mean / von_mises_stress,
                                                                     s.plastic_strain_rate, s.temperature)
                                                   : Real(0);
    s.damage = increment < strain * (Real(1) - s.damage) ? s.damage + increment / strain : Real(1);
  }
  if (s.damage < Real(1)) return;
  const Real expansion = Real(3) * mat.thermal_expansion * (s.temperature - mat.start_temperature);
  const Real compression = Kokkos::log(s.density / mat.density) + expansion;
  const Real bulk_modulus = stiffness_share(mat, s.temperature) * mat.bulk_modulus;
  const Real mean = compression > Real(0) ? -bulk_modulus * compression : Real(0);
  s.stress = {mean, mean, mean, 0, 0, 0};
}

// What warming since the stress was made, from `before` to T, does to it: no strain but the expansion, which
// none of the moduli resists, and the elastic strain that is there meets the moduli of now. Whatever warmed
// the point, conduction, plastic work or the tool, is in the difference of the two temperatures.
SWARF_FN void apply_warming(const Material& mat, Real before, Real T, Symmetric3& stress,
                            StepMotion& motion) {
  const Real expansion = mat.thermal_expansion * (T - before);
  motion.strain = motion.strain + Symmetric3{-expansion, -expansion, -expansion, 0, 0, 0};
  if (mat.stiffness_table.points > 0)
    stress = stiffness_share(mat, T) / stiffness_share(mat, before) * stress;
}

// One step of one point. L: velocity gradient at the end of the step, 1/s. Plastic work heats the point by
// taylor_quinney sigma_y d / (rho c). A step that inverts the point leaves a density <= 0: the caller checks.
// stress_temperature: that at which start.stress was made; the new one is made at start.temperature.
SWARF_FN StressUpdate update_point(const Material& mat, const MaterialState& start, const Tensor3& L, Real dt,
                                   Real stress_temperature) {
  const StepMotion motion = step_motion(L, dt);
  StressUpdate u{start, 0, 0, 0, true};
  MaterialState& s = u.state;
  StepMotion elastic = motion;
  apply_warming(mat, stress_temperature, start.temperature, s.stress, elastic);
  s.stress = trial_stress(mat, s.stress, elastic, stiffness_share(mat, start.temperature));
  s.density = start.density + start.density * motion.dilution;
  s.plastic_strain_rate = 0;

  const Real q_trial = von_mises(s.stress);
  const bool failed = start.damage >= Real(1);
  const ReturnMapping r = failed ? ReturnMapping{0, q_trial, 0, 0, true} : yield(mat, q_trial, start, dt);
  if (r.increment > Real(0) || r.flow_stress < q_trial) {
    u.iterations = r.iterations, u.converged = r.converged;
    const Real mean = trace(s.stress) / Real(3);
    s.stress = r.flow_stress / q_trial * deviator(s.stress) + Symmetric3{mean, mean, mean, 0, 0, 0};
    s.equivalent_plastic_strain += r.increment;
    s.plastic_strain_rate = r.increment / dt;
    u.plastic_work = r.flow_stress * r.increment / s.density;
    if (mat.taylor_quinney > Real(0))
      s.temperature = warmed_by(mat, s.temperature, mat.taylor_quinney * u.plastic_work);
  }
  if (mat.damage.active) damage_point(mat, r.increment, r.flow_stress, s);
  u.internal_work = contract(start.stress + s.stress, motion.strain) / (start.density + s.density);
  return u;
}

// Where no stress depends on temperature, or none has changed.
SWARF_FN StressUpdate update_point(const Material& mat, const MaterialState& start, const Tensor3& L,
                                   Real dt) {
  return update_point(mat, start, L, dt, start.temperature);
}

} // namespace swarf
