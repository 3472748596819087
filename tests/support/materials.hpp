// Materials that the tests of the material update share.
#pragma once
#include "swarf/material/material.hpp"

namespace swarf::test {

// Ti-6Al-4V of Demiral & Mamedov (2022); melting point and reference rate are assumed.
inline Material ti64() {
  Material mat;
  mat.law = FlowLaw::johnson_cook;
  mat.density = 4430, mat.specific_heat = Real(526.3), mat.taylor_quinney = Real(0.9);
  const double E = 110e9, nu = 0.33;
  mat.bulk_modulus = Real(E / (3 * (1 - 2 * nu))), mat.shear_modulus = Real(E / (2 * (1 + nu)));
  mat.A = Real(862e6), mat.B = Real(331e6), mat.n = Real(0.34), mat.C = Real(0.012), mat.m = Real(0.8);
  mat.reference_rate = 1, mat.reference_temperature = Real(298.15), mat.melt_temperature = 1878;
  return mat;
}

inline Material elastic_solid(Real bulk_modulus, Real shear_modulus, Real density) {
  Material mat;
  mat.bulk_modulus = bulk_modulus, mat.shear_modulus = shear_modulus, mat.density = density;
  return mat;
}

// Round-off of sums of a few hundred terms.
inline constexpr double round_off = sizeof(Real) == 8 ? 1e-12 : 1e-4;

} // namespace swarf::test
