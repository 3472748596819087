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
  mat.johnson_cook = {Real(862e6), Real(331e6), Real(0.34), Real(0.012), Real(0.8), 1, Real(298.15), 1878};
  return mat;
}

// Strain softening (Calamaz, Coupard & Girot 2008) of the size that chips which segment ask for.
inline Material softening_ti64() {
  Material mat = ti64();
  mat.law = FlowLaw::johnson_cook_tanh;
  mat.johnson_cook = {Real(782.7e6), Real(498.4e6), Real(0.28), Real(0.028), 1, Real(1e-5), 298, 1878};
  mat.strain_softening = {Real(1.6), Real(0.4), 6, 1};
  return mat;
}

// Armco iron and copper of Zerilli & Armstrong (1987).
inline Material zerilli_armstrong_iron() {
  Material mat = ti64();
  mat.law = FlowLaw::zerilli_armstrong;
  mat.zerilli_armstrong = {0, Real(1033e6), 0, Real(6.98e-3), Real(4.15e-4), Real(266e6), Real(0.289), 1};
  return mat;
}
inline Material zerilli_armstrong_copper() {
  Material mat = zerilli_armstrong_iron();
  mat.zerilli_armstrong = {Real(65e6), 0, Real(890e6), Real(2.8e-3), Real(1.15e-4), 0, 1, 1};
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
