// sigma = yield_stress + hardening_modulus eps; elastic with an infinite yield stress.
#pragma once
#include "swarf/material/laws/flow_stress.hpp"

namespace swarf {

struct LinearHardening {
  Real yield_stress = Kokkos::Experimental::infinity_v<Real>; // Pa
  Real hardening_modulus = 0;                                 // Pa

  SWARF_FN Real thermal(Real) const { return 1; }
  SWARF_FN FlowStress stress(Real plastic_strain, Real, Real, Real) const {
    return {yield_stress + hardening_modulus * plastic_strain, hardening_modulus};
  }
  SWARF_FN Real elastic_limit(Real) const { return yield_stress; }
  SWARF_FN Real first_increment(Real overstress, Real, Real, Real three_G) const {
    return overstress / three_G;
  }
};

} // namespace swarf
