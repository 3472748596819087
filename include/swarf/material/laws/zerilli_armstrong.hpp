// Zerilli & Armstrong (J. Appl. Phys. 61 (1987) 1816), both of their forms in one:
//   sigma = C0 + (C1 + C2 eps^1/2) exp(-C3 T + C4 T ln rate) + C5 eps^n,
// body-centred metals with C2 = 0, face-centred ones with C1 = C5 = 0. Rate in 1/s, T in K; rates below the
// reference rate count as that.
#pragma once
#include "swarf/material/laws/flow_stress.hpp"

namespace swarf {

struct ZerilliArmstrong {
  Real C0 = 0, C1 = 0, C2 = 0; // Pa
  Real C3 = 0, C4 = 0;         // 1/K
  Real C5 = 0, n = 1;          // Pa, -
  Real reference_rate = 1;     // 1/s

  SWARF_FN Real thermal(Real temperature) const { return temperature; }

  SWARF_FN FlowStress stress(Real plastic_strain, Real increment, Real dt, Real temperature) const {
    const Real rate = Kokkos::max(increment / dt, reference_rate);
    const Real activation = Kokkos::exp(temperature * (C4 * Kokkos::log(rate) - C3));
    Real obstacles = C1, obstacles_slope = 0, slope = 0, value = C0;
    if (plastic_strain > Real(0)) {
      const Real root = Kokkos::sqrt(plastic_strain), power = C5 * Kokkos::pow(plastic_strain, n);
      obstacles += C2 * root, obstacles_slope = Real(0.5) * C2 / root;
      value += power, slope = n * power / plastic_strain;
    }
    value += obstacles * activation, slope += obstacles_slope * activation;
    if (increment > reference_rate * dt) slope += obstacles * activation * C4 * temperature / increment;
    return {value, slope};
  }

  SWARF_FN Real elastic_limit(Real) const { return C0; }
  SWARF_FN Real first_increment(Real overstress, Real, Real, Real three_G) const {
    return overstress / three_G;
  }
};

} // namespace swarf
