// The list of flow laws (laws/), and what is asked of any of them. Pa, 1/s, K.
#pragma once
#include "swarf/material/material.hpp"

namespace swarf {

// visit(law) with the material's law as a type of its own.
template <class Visit>
SWARF_FN auto visit_law(const Material& mat, const Visit& visit) {
  switch (mat.law) {
  case FlowLaw::johnson_cook:
    return visit(mat.johnson_cook);
  case FlowLaw::johnson_cook_tanh:
    return visit(JohnsonCookTanh{mat.johnson_cook, mat.strain_softening});
  case FlowLaw::zerilli_armstrong:
    return visit(mat.zerilli_armstrong);
  case FlowLaw::linear_hardening:
    return visit(mat.linear_hardening);
  default:
    return visit(LinearHardening{}); // elastic
  }
}

// At a given plastic strain rate, for start-up values, reports and tests.
SWARF_FN Real flow_stress(const Material& mat, Real plastic_strain, Real rate, Real temperature) {
  return visit_law(mat, [&](const auto& law) {
    return law.stress(plastic_strain, rate, Real(1), law.thermal(temperature)).value;
  });
}

// Shear stress at which the material flows by von Mises' criterion: no friction is larger. Infinite where it
// never flows.
SWARF_FN Real shear_strength(const Material& mat, Real plastic_strain, Real rate, Real temperature) {
  return flow_stress(mat, plastic_strain, rate, temperature) * Real(0.57735026918962576451); // 1 / sqrt(3)
}

// Johnson & Cook (1985): (D1 + D2 exp(D3 s)) (1 + D4 ln rate*) (1 + D5 T*), s = mean stress (tension > 0) /
// von Mises stress. Not positive: the point breaks at once.
SWARF_FN Real fracture_strain(const Material& mat, Real triaxiality, Real rate, Real temperature) {
  const DamageLaw& d = mat.damage;
  const Real relative_rate = rate / mat.johnson_cook.reference_rate;
  const Real rate_factor = relative_rate > Real(1) ? Real(1) + d.D4 * Kokkos::log(relative_rate) : Real(1);
  return (d.D1 + d.D2 * Kokkos::exp(d.D3 * triaxiality)) * rate_factor *
         (Real(1) + d.D5 * mat.johnson_cook.homologous_temperature(temperature));
}

} // namespace swarf
