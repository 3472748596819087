// Flow stress, and fracture strain, at a point. Pa, 1/s, K.
#pragma once
#include "swarf/material/material.hpp"

namespace swarf {

// T* = (T - Tr) / (Tm - Tr), 0 below Tr, 1 at and above the melting point.
SWARF_FN Real homologous_temperature(const Material& mat, Real temperature) {
  if (temperature <= mat.reference_temperature) return 0;
  if (temperature >= mat.melt_temperature) return 1;
  return (temperature - mat.reference_temperature) / (mat.melt_temperature - mat.reference_temperature);
}

// 1 - T*^m; 1 for laws that know no temperature.
SWARF_FN Real thermal_softening(const Material& mat, Real temperature) {
  if (mat.law != FlowLaw::johnson_cook) return 1;
  const Real T_star = homologous_temperature(mat, temperature);
  if (T_star == Real(0)) return 1;
  return T_star == Real(1) ? Real(0) : Real(1) - Kokkos::pow(T_star, mat.m);
}

struct FlowStress {
  Real value; // Pa
  Real slope; // d value / d plastic strain, at a rate of (plastic strain increment) / dt, Pa
};

// Johnson & Cook (1983): (A + B eps^n) (1 + C ln(rate / rate0)) (1 - T*^m). The rate factor is 1 below the
// reference rate, so the stress is continuous there; with rate = increment / dt its slope is C / increment.
// The slope is that at eps > 0 only: where n < 1 it has no limit at 0.
SWARF_FN FlowStress flow_stress(const Material& mat, Real plastic_strain, Real increment, Real dt,
                                Real softening) {
  if (mat.law == FlowLaw::linear_hardening)
    return {mat.yield_stress + mat.hardening_modulus * plastic_strain, mat.hardening_modulus};
  const Real power = plastic_strain > Real(0) ? Kokkos::pow(plastic_strain, mat.n) : Real(0);
  const Real hardening = mat.A + mat.B * power;
  const Real hardening_slope = plastic_strain > Real(0) ? mat.B * mat.n * power / plastic_strain : Real(0);
  const Real relative_rate = increment / (dt * mat.reference_rate);
  if (!(relative_rate > Real(1))) return {softening * hardening, softening * hardening_slope};
  const Real rate_factor = Real(1) + mat.C * Kokkos::log(relative_rate);
  return {softening * hardening * rate_factor,
          softening * (hardening_slope * rate_factor + hardening * mat.C / increment)};
}

// The same at a given plastic strain rate, for start-up values, reports and tests.
SWARF_FN Real flow_stress(const Material& mat, Real plastic_strain, Real rate, Real temperature) {
  return flow_stress(mat, plastic_strain, rate, Real(1), thermal_softening(mat, temperature)).value;
}

// Shear stress at which the material flows by von Mises' criterion: no friction is larger. Infinite where it
// never flows.
SWARF_FN Real shear_strength(const Material& mat, Real plastic_strain, Real rate, Real temperature) {
  if (mat.law == FlowLaw::elastic) return Kokkos::Experimental::infinity_v<Real>;
  return flow_stress(mat, plastic_strain, rate, temperature) * Real(0.57735026918962576451); // 1 / sqrt(3)
}

// Johnson & Cook (1985): (D1 + D2 exp(D3 s)) (1 + D4 ln rate*) (1 + D5 T*), s = mean stress (tension > 0) /
// von Mises stress. Not positive: the point breaks at once.
SWARF_FN Real fracture_strain(const Material& mat, Real triaxiality, Real rate, Real temperature) {
  const DamageLaw& d = mat.damage;
  const Real relative_rate = rate / mat.reference_rate;
  const Real rate_factor = relative_rate > Real(1) ? Real(1) + d.D4 * Kokkos::log(relative_rate) : Real(1);
  return (d.D1 + d.D2 * Kokkos::exp(d.D3 * triaxiality)) * rate_factor *
         (Real(1) + d.D5 * homologous_temperature(mat, temperature));
}

} // namespace swarf
