// Two blocks of cubes above each other, and all that their contact needs: one block, of which the middle
// layer of hexes is deleted and as thick as the gap between the two.
#pragma once
#include "support/hex_block.hpp"
#include "swarf/kernels.hpp"

namespace swarf::test {

struct TwoBlocks {
  HexMesh mesh;
  Particles particles; // none
  ContactGroups groups;
  MaterialTable materials;
  BodyContact contact;
};

// Of n x n x layers cubes each. gap < 0: they overlap.
inline Material steel_of_blocks() {
  Material steel;
  steel.density = 7800, steel.bulk_modulus = 1e11, steel.shear_modulus = 8e10, steel.specific_heat = 500;
  return steel;
}
inline TwoBlocks two_blocks(int n, int layers, Real edge, double gap) {
  const Material steel = steel_of_blocks();
  TwoBlocks b;
  const Cells cells{n, n, 2 * layers + 1};
  b.mesh = make_hex_block(cells, steel, [=](int i, int j, int k) {
    return Point{edge * i, edge * j, k <= layers ? edge * k : edge * (k - 1) + gap};
  });
  HexMesh& m = b.mesh;
  const int hexes = m.points.count;
  b.materials = make_material_table({steel});
  Kokkos::deep_copy(m.volume, edge * edge * edge);
  m.body_contact_energy = ScalarField("body_contact_energy", m.nodes);
  m.friction_work = ScalarField("friction_work", m.nodes);
  m.contact_heat = ScalarField("contact_heat", m.nodes);
  b.groups.count = 2, b.groups.skin = Real(0.3) * edge;
  b.groups.of_hex = IndexField("of_hex", hexes), b.groups.of_body = IndexField("of_body", 2);
  b.groups.behind = View<int* [6]>("behind", hexes);
  const auto active = host_copy(m.active);
  const auto of_hex = host_copy(b.groups.of_hex);
  const auto behind = host_copy(b.groups.behind);
  for (int e = 0; e < hexes; ++e) {
    const int at[3] = {e % n, e / n % n, e / (n * n)}, step[3] = {1, n, n * n};
    of_hex(e) = at[2] > layers ? 1 : 0;
    active(e) = at[2] == layers ? 0 : 1;
    for (int s = 0; s < 6; ++s) {
      const int next = at[s / 2] + (s % 2 ? 1 : -1);
      behind(e, s) =
          next < 0 || next >= cells[std::size_t(s / 2)] ? no_hex : e + (s % 2 ? 1 : -1) * step[s / 2];
    }
  }
  const auto mass = host_copy(m.mass); // of what is left
  for (int a = 0; a < m.nodes; ++a) mass(a) = 0;
  const auto corner = host_copy(m.connectivity);
  for (int e = 0; e < hexes; ++e)
    for (int a = 0; active(e) && a < 8; ++a) mass(corner(e, a)) += steel.density * edge * edge * edge / 8;
  Kokkos::deep_copy(m.mass, mass);
  Kokkos::deep_copy(m.active, active), Kokkos::deep_copy(b.groups.of_hex, of_hex);
  Kokkos::deep_copy(b.groups.behind, behind);
  return b;
}

} // namespace swarf::test
