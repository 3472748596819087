// Material points at rest, for tests.
#pragma once
#include "swarf/material/material.hpp"

#include <vector>

namespace swarf::test {

inline MaterialTable make_material_table(const std::vector<Material>& materials) {
  MaterialTable table("materials", materials.size());
  auto host = Kokkos::create_mirror_view(table);
  for (std::size_t k = 0; k < materials.size(); ++k) host(k) = materials[k];
  Kokkos::deep_copy(table, host);
  return table;
}

// All of material 0, at its density and reference temperature; mass 1 kg each.
inline MaterialPoints make_points(int count, const Material& mat) {
  MaterialPoints p;
  p.count = count;
  p.material = IndexField("material", count);
  p.velocity_gradient = TensorField("velocity_gradient", count);
  p.stress = SymmetricField("stress", count);
  p.mass = ScalarField("mass", count), p.density = ScalarField("density", count);
  p.equivalent_plastic_strain = ScalarField("equivalent_plastic_strain", count);
  p.plastic_strain_rate = ScalarField("plastic_strain_rate", count);
  p.temperature = ScalarField("temperature", count), p.damage = ScalarField("damage", count);
  p.internal_work = ScalarField("internal_work", count), p.plastic_work = ScalarField("plastic_work", count);
  Kokkos::deep_copy(p.mass, Real(1));
  Kokkos::deep_copy(p.density, mat.density);
  Kokkos::deep_copy(p.temperature, mat.johnson_cook.reference_temperature);
  return p;
}

} // namespace swarf::test
