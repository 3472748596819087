// Johnson & Cook with strain softening, as Calamaz, Coupard & Girot (Int. J. Mach. Tools Manuf. 48 (2008)
// 275) write it for chips that segment:
//   sigma = (A + B eps^n exp(-eps^a)) (1 + C ln(rate / rate0)) (1 - T*^m) [D + (1 - D) tanh((eps + S)^-c)],
//   D = 1 - (T / Tm)^d,  S = (T / Tm)^b,  T in K.
#pragma once
#include "swarf/material/laws/johnson_cook.hpp"

namespace swarf {

struct StrainSoftening {
  Real a = 1, b = 1, c = 1, d = 1;
};

struct JohnsonCookTanh {
  JohnsonCook law;
  StrainSoftening strain;

  struct Thermal {
    Real softening, D, S;
  };

  SWARF_FN Real relative_temperature(Real temperature) const {
    return Kokkos::min(temperature / law.melt_temperature, Real(1));
  }

  SWARF_FN Thermal thermal(Real temperature) const {
    const Real T = relative_temperature(temperature);
    return {law.thermal(temperature), Real(1) - Kokkos::pow(T, strain.d), Kokkos::pow(T, strain.b)};
  }

  SWARF_FN FlowStress stress(Real plastic_strain, Real increment, Real dt, const Thermal& t) const {
    Real hardening = law.A, slope = 0;
    if (plastic_strain > Real(0)) {
      const Real fading = Kokkos::pow(plastic_strain, strain.a);
      const Real part = law.B * Kokkos::pow(plastic_strain, law.n) * Kokkos::exp(-fading);
      hardening += part, slope = part * (law.n - strain.a * fading) / plastic_strain;
    }
    const Real inverse = Kokkos::pow(plastic_strain + t.S, -strain.c), tanh = Kokkos::tanh(inverse);
    const Real share = t.D + (Real(1) - t.D) * tanh;
    const Real share_slope =
        -(Real(1) - t.D) * (Real(1) - tanh * tanh) * strain.c * inverse / (plastic_strain + t.S);
    return law.with_rate(hardening * share, slope * share + hardening * share_slope, increment, dt,
                         t.softening);
  }

  SWARF_FN Real elastic_limit(Real temperature) const { // D >= min(d, 1) (1 - T / Tm)
    return law.elastic_limit(temperature) * Kokkos::min(strain.d, Real(1)) *
           (Real(1) - relative_temperature(temperature));
  }

  SWARF_FN Real first_increment(Real overstress, Real, const Thermal&, Real three_G) const {
    return overstress / three_G;
  }
};

} // namespace swarf
