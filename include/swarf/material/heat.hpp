// Fourier conduction, q = -k grad T, for particles and hexes. Pure functions; mass scaling does not enter.
#pragma once
#include "swarf/hexes/hex8.hpp"
#include "swarf/hexes/hex_mesh.hpp"
#include "swarf/material/thermal.hpp"

namespace swarf {

// The same as warmed_by and heat_between (thermal.hpp) of node a of hexes.
SWARF_FN Real node_warmed_by(const HexMesh& m, const MaterialTable& materials, int a, Real T, Real heat) {
  if (m.node_material.extent(0) == 0) return T + heat / m.heat_capacity(a);
  const Material& mat = materials(m.node_material(a));
  return warmed_by(mat, m.heat_capacity(a) / mat.specific_heat, T, heat);
}
SWARF_FN Real node_heat_between(const HexMesh& m, const MaterialTable& materials, int a, Real from, Real to) {
  if (m.node_material.extent(0) == 0) return m.heat_capacity(a) * (to - from);
  const Material& mat = materials(m.node_material(a));
  return heat_between(mat, m.heat_capacity(a) / mat.specific_heat, from, to);
}

// Explicit conduction is stable below 2 / (largest rate). On a cubic lattice that rate is at most 12 alpha /
// h^2 for the pair sum (h = 1.2 spacings: sum_j of the weights is 6 alpha / h^2, twice that by Gershgorin)
// and 12 alpha / l^2 for lumped hexes of edge l; half of the limit is left for disorder. s.
SWARF_FN Real conduction_step(const Material& mat, Real length) {
  return mat.density * mat.specific_heat * length * length / (Real(12) * mat.conductivity);
}

struct HexScalars { // one number per corner
  Real at[8];
};

// Sign of hourglass base vector m (order of HexModes) at corner a.
SWARF_FN Real hourglass_sign(int m, int a) {
  const Real xi = ((a + 1) / 2) % 2 ? Real(1) : Real(-1), eta = (a / 2) % 2 ? Real(1) : Real(-1);
  const Real zeta = a / 4 ? Real(1) : Real(-1);
  return m == 0 ? eta * zeta : m == 1 ? zeta * xi : m == 2 ? xi * eta : xi * eta * zeta;
}

// Heat that conduction brings to each corner per unit of conductivity and time, m K:
//   Q_a = -(V B_a . g + c sum_m gamma_a^m (gamma^m . T)),  g = sum_a B_a T_a,
// one-point integration with the hourglass stabilisation of Flanagan & Belytschko (1981) for a scalar.
// c = V B:B / 36 gives the modes xi eta, eta zeta, zeta xi of a cube the heat flow of exact integration.
SWARF_FN HexScalars conducted_heat(const HexScalars& T, const HexVectors& B, const HexModes& x, Real volume) {
  Vector3 g{0, 0, 0};
  Real b2 = 0;
  for (int a = 0; a < 8; ++a) g = g + T.at[a] * B.at[a], b2 += dot(B.at[a], B.at[a]);
  const Real c = volume * b2 / Real(36);
  Vector3 flow = volume * g;
  Real mode[4];
  for (int m = 0; m < 4; ++m) {
    Real sum = -dot(g, x.mode[m]);
    for (int a = 0; a < 8; ++a) sum += hourglass_sign(m, a) * T.at[a];
    mode[m] = c * sum;
    flow = flow - mode[m] * x.mode[m];
  }
  HexScalars heat;
  for (int a = 0; a < 8; ++a) {
    heat.at[a] = -dot(flow, B.at[a]);
    for (int m = 0; m < 4; ++m) heat.at[a] -= hourglass_sign(m, a) * mode[m];
  }
  return heat;
}

} // namespace swarf
