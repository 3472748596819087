// Johnson & Cook (1983): sigma = (A + B eps^n) (1 + C ln(rate / rate0)) (1 - T*^m). The rate factor is 1
// below the reference rate, so the stress is continuous there; with rate = d / dt its slope is C / d. The
// slope is that at eps > 0 only: where n < 1 it has no limit at 0.
#pragma once
#include "swarf/material/laws/flow_stress.hpp"

namespace swarf {

struct JohnsonCook {
  Real A = 0, B = 0, n = 0, C = 0, m = 0;
  Real reference_rate = 1;          // 1/s
  Real reference_temperature = 298; // K
  Real melt_temperature = 1e9;      // K

  // T* = (T - Tr) / (Tm - Tr), 0 below Tr, 1 at and above the melting point.
  SWARF_FN Real homologous_temperature(Real temperature) const {
    if (temperature <= reference_temperature) return 0;
    if (temperature >= melt_temperature) return 1;
    return (temperature - reference_temperature) / (melt_temperature - reference_temperature);
  }

  SWARF_FN Real thermal(Real temperature) const { // 1 - T*^m
    const Real T_star = homologous_temperature(temperature);
    if (T_star == Real(0)) return 1;
    return T_star == Real(1) ? Real(0) : Real(1) - Kokkos::pow(T_star, m);
  }

  SWARF_FN FlowStress stress(Real plastic_strain, Real increment, Real dt, Real softening) const {
    const Real power = plastic_strain > Real(0) ? Kokkos::pow(plastic_strain, n) : Real(0);
    const Real hardening = A + B * power;
    const Real hardening_slope = plastic_strain > Real(0) ? B * n * power / plastic_strain : Real(0);
    return with_rate(hardening, hardening_slope, increment, dt, softening);
  }

  // Of a hardening of one's own, Pa.
  SWARF_FN FlowStress with_rate(Real hardening, Real slope, Real increment, Real dt, Real softening) const {
    const Real relative_rate = increment / (dt * reference_rate);
    if (!(relative_rate > Real(1))) return {softening * hardening, softening * slope};
    const Real rate_factor = Real(1) + C * Kokkos::log(relative_rate);
    return {softening * hardening * rate_factor,
            softening * (slope * rate_factor + hardening * C / increment)};
  }

  SWARF_FN Real elastic_limit(Real temperature) const { // 1 - x^m >= min(m, 1) (1 - x)
    const Real T_star = homologous_temperature(temperature);
    return A * (T_star == Real(0) ? Real(1) : Kokkos::min(m, Real(1)) * (Real(1) - T_star));
  }

  // Neither perfect plasticity nor, at first yield, where the slope of eps^n is infinite, the power law alone
  // takes less overstress.
  SWARF_FN Real first_increment(Real overstress, Real plastic_strain, Real softening, Real three_G) const {
    const Real d = overstress / three_G;
    if (plastic_strain > Real(0) || !(B > Real(0))) return d;
    return Kokkos::min(d, Kokkos::pow(overstress / (softening * B), Real(1) / n));
  }
};

} // namespace swarf
