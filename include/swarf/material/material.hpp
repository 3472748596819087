// Materials, and the points (particles or hexes) that carry their state.
#pragma once
#include "swarf/core/fields.hpp"
#include "swarf/material/laws/johnson_cook_tanh.hpp"
#include "swarf/material/laws/linear_hardening.hpp"
#include "swarf/material/laws/zerilli_armstrong.hpp"
#include "swarf/material/temperature_table.hpp"

namespace swarf {

enum class FlowLaw { elastic, linear_hardening, johnson_cook, johnson_cook_tanh, zerilli_armstrong };

// Johnson & Cook (1985) fracture strain: (D1 + D2 exp(D3 s)) (1 + D4 ln rate*) (1 + D5 T*), s = mean stress
// (tension > 0) / von Mises stress.
struct DamageLaw {
  bool active = false;
  Real D1 = 0, D2 = 0, D3 = 0, D4 = 0, D5 = 0;
};

// SI throughout. Where there is a table, the number beside it is that of the stable step (thermal.hpp).
struct Material {
  FlowLaw law = FlowLaw::elastic;
  Real density = 0;        // kg/m3
  Real bulk_modulus = 0;   // Pa
  Real shear_modulus = 0;  // Pa
  Real specific_heat = 0;  // J/(kg K)
  Real conductivity = 0;   // W/(m K)
  Real taylor_quinney = 0; // share of plastic work that becomes heat
  LinearHardening linear_hardening;
  JohnsonCook johnson_cook;
  StrainSoftening strain_softening; // of johnson_cook_tanh
  ZerilliArmstrong zerilli_armstrong;
  DamageLaw damage;
  TemperatureTable conductivity_table, specific_heat_table;
  TemperatureTable stiffness_table; // share of both moduli
  Real thermal_expansion = 0;       // 1/K, of a length, per length as it is
  Real start_temperature = 0;       // K, at which the density is that of the unloaded material
};

SWARF_FN Real longitudinal_wave_speed(const Material& mat) {
  return Kokkos::sqrt((mat.bulk_modulus + Real(4) / Real(3) * mat.shear_modulus) / mat.density);
}

using MaterialTable = View<Material*>;

// State of `count` material points; each field may have more rows than count.
struct MaterialPoints {
  int count = 0;
  IndexField material;                   // row of the MaterialTable
  ScalarField mass;                      // kg, not mass-scaled
  ScalarField density;                   // kg/m3
  TensorField velocity_gradient;         // L_ij = dv_i/dx_j, 1/s; of particles D from prepare_pair_state on
  SymmetricField stress;                 // Cauchy, Pa
  ScalarField equivalent_plastic_strain; //
  ScalarField plastic_strain_rate;       // 1/s
  ScalarField temperature;               // K
  ScalarField stress_temperature;        // K, that the stress knows of; 0 rows where it depends on none
  ScalarField damage;                    // 0 intact .. 1 failed
  ScalarField internal_work;             // J, integral of V stress : D dt
  ScalarField plastic_work;              // J, the plastic part of it

  // The table of these fields (fields.hpp).
  template <class Self, class Visit>
  SWARF_FN static void list_fields(Self& p, const Visit& visit) {
    using enum Frame;
    using enum Life;
    using enum Ghosts;
    using enum Method;
    using enum Shifting;
    visit("material", p.material, Facts<history, in_find_shifts>());
    visit("mass", p.mass, Facts<history>());
    visit("density", p.density, Facts<history, transported>());
    visit("velocity_gradient", p.velocity_gradient,
          Facts<tensor, history, in_surface_gradient, before_forces>());
    visit("stress", p.stress, Facts<symmetric, history, transported, in_surface_stress>());
    visit("equivalent_plastic_strain", p.equivalent_plastic_strain, Facts<history, keeps_mass_sum>());
    visit("plastic_strain_rate", p.plastic_strain_rate, Facts<history>());
    visit("temperature", p.temperature, Facts<history, keeps_heat_sum>());
    visit("stress_temperature", p.stress_temperature, Facts<history, with_thermal_stress>());
    visit("damage", p.damage, Facts<history, transported>());
    visit("internal_work", p.internal_work, Facts<history>());
    visit("plastic_work", p.plastic_work, Facts<history>());
  }
};

} // namespace swarf
