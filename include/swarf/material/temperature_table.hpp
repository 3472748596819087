// A property over temperature: straight lines between a few points, constant outside of them.
#pragma once
#include "swarf/core/types.hpp"

namespace swarf {

struct TemperatureTable {
  static constexpr int most = 16;
  int points = 0;              // 0: the property is a constant, which its owner holds
  Real temperature[most] = {}; // K, rising
  Real value[most] = {};       // positive
  Real integral_to[most] = {}; // of the value over temperature, from the first point
};

// Row of the line that T lies on; the first or the last one where it lies outside.
SWARF_FN int line_at(const TemperatureTable& t, Real T) {
  int k = 0;
  while (k + 2 < t.points && T >= t.temperature[k + 1]) ++k;
  return k;
}

SWARF_FN Real slope_of(const TemperatureTable& t, int k) {
  return (t.value[k + 1] - t.value[k]) / (t.temperature[k + 1] - t.temperature[k]);
}

SWARF_FN Real value_at(const TemperatureTable& t, Real T) {
  const int k = line_at(t, T), last = t.points - 1;
  if (T <= t.temperature[0]) return t.value[0];
  if (T >= t.temperature[last]) return t.value[last];
  return t.value[k] + slope_of(t, k) * (T - t.temperature[k]);
}

// From the first point to T; negative below it.
SWARF_FN Real integral_at(const TemperatureTable& t, Real T) {
  const int k = line_at(t, T), last = t.points - 1;
  if (T <= t.temperature[0]) return t.value[0] * (T - t.temperature[0]);
  if (T >= t.temperature[last]) return t.integral_to[last] + t.value[last] * (T - t.temperature[last]);
  const Real d = T - t.temperature[k];
  return t.integral_to[k] + (t.value[k] + Real(0.5) * slope_of(t, k) * d) * d;
}

// Where the integral is I: the root v d + slope d^2 / 2 = I - I_k in the form that loses no digits where the
// slope is small.
SWARF_FN Real temperature_of_integral(const TemperatureTable& t, Real I) {
  const int last = t.points - 1;
  if (I <= Real(0)) return t.temperature[0] + I / t.value[0];
  if (I >= t.integral_to[last]) return t.temperature[last] + (I - t.integral_to[last]) / t.value[last];
  int k = 0;
  while (k + 2 < t.points && I >= t.integral_to[k + 1]) ++k;
  const Real v = t.value[k], more = I - t.integral_to[k];
  return t.temperature[k] + Real(2) * more / (v + Kokkos::sqrt(v * v + Real(2) * slope_of(t, k) * more));
}

} // namespace swarf
