#include "swarf/kernels.hpp"
#include "swarf/material/heat.hpp"

namespace swarf {

// Heat that each hex brings to its corners in dt: conduction (conducted_heat in heat.hpp) of the share of its
// volume that tied particles leave, and an eighth of what has heated the hex since the last call, m c (T_e -
// mean of T_a). The conductivity is that of the mean, the mean over a straight line of temperature. Reads
// nodal_temperature, gradient, volume, share, position, mass and temperature of the hex; writes corner_heat
// (0 for deleted hexes; frozen ones conduct nothing).
void hex_heat(const HexMesh& m, const MaterialTable& materials, Real dt) {
  Kokkos::parallel_for(
      "hex_heat", Range(0, m.points.count), KOKKOS_LAMBDA(const int e) {
        HexScalars T{}, heat{};
        if (m.active(e) != hex_deleted) {
          const Material& mat = materials(m.points.material(e));
          Real mean = 0;
          for (int a = 0; a < 8; ++a) {
            T.at[a] = m.nodal_temperature(m.connectivity(e, a));
            mean += Real(0.125) * T.at[a];
          }
          if (m.active(e) == hex_active) {
            const HexModes x = project_modes(load_corners(m.position, m.connectivity, e));
            heat = conducted_heat(T, load_gradient(m.gradient, e), x, m.volume(e));
          }
          const Real own = heat_between(mat, m.points.mass(e), mean, m.points.temperature(e));
          const Real scale = dt * m.share(e) * conductivity_at(mat, mean);
          for (int a = 0; a < 8; ++a) heat.at[a] = scale * heat.at[a] + Real(0.125) * own;
        }
        for (int a = 0; a < 8; ++a) m.corner_heat(e, a) = heat.at[a];
      });
}

} // namespace swarf
