// What a material makes of heat and of temperature. Pure functions; where a property is no table its constant
// is used, and mass scaling does not enter. Of a table the Material's own number is the one that decides the
// stable step: the largest conductivity and modulus, the least specific heat.
#pragma once
#include "swarf/material/material.hpp"

namespace swarf {

SWARF_FN Real conductivity_at(const Material& mat, Real T) { // W/(m K)
  return mat.conductivity_table.points > 0 ? value_at(mat.conductivity_table, T) : mat.conductivity;
}

SWARF_FN Real specific_heat_at(const Material& mat, Real T) { // J/(kg K)
  return mat.specific_heat_table.points > 0 ? value_at(mat.specific_heat_table, T) : mat.specific_heat;
}

// Moduli at T over those of the Material, at most 1. Poisson's ratio does not change.
SWARF_FN Real stiffness_share(const Material& mat, Real T) {
  return mat.stiffness_table.points > 0 ? value_at(mat.stiffness_table, T) : Real(1);
}

// Of a constant, and of a table where it is least. J/K
SWARF_FN Real heat_capacity(const Material& mat, Real mass) { return mass * mat.specific_heat; }

// Heat that takes `mass` from one temperature to another: the difference of the enthalpies. J
SWARF_FN Real heat_between(const Material& mat, Real mass, Real from, Real to) {
  const TemperatureTable& c = mat.specific_heat_table;
  return c.points > 0 ? mass * (integral_at(c, to) - integral_at(c, from))
                      : heat_capacity(mat, mass) * (to - from);
}

// The temperature after that heat: the inverse, so that heat is kept to round-off whatever the table.
SWARF_FN Real warmed_by(const Material& mat, Real mass, Real T, Real heat) {
  const TemperatureTable& c = mat.specific_heat_table;
  return c.points > 0 ? temperature_of_integral(c, integral_at(c, T) + heat / mass)
                      : T + heat / heat_capacity(mat, mass);
}

// The same of heat per mass, J/kg.
SWARF_FN Real warmed_by(const Material& mat, Real T, Real heat) {
  const TemperatureTable& c = mat.specific_heat_table;
  return c.points > 0 ? temperature_of_integral(c, integral_at(c, T) + heat) : T + heat / mat.specific_heat;
}

} // namespace swarf
