// What a tied particle shows the particles near it is its host hex's: P = sigma K, with the K of an
// undeformed lattice, so that a constant stress crosses the interface; L, D, T and the impedance of the
// mass-scaled material; V = m / rho of the host. No artificial stress: hexes have no tensile instability. A
// deleted host shows nothing: stress and volume 0. Reads points and active of the hexes. Writes the tied
// rows.
#include "swarf/kernels.hpp"

namespace swarf {
namespace {

struct ImpedanceOf {
  Real impedance, density;
};

SWARF_FN ImpedanceOf scale_impedance(const Material& material, Real density, Real mass_factor) {
  const Real speed = longitudinal_wave_speed(material) / Kokkos::sqrt(mass_factor);
  return {density * mass_factor * speed, density * mass_factor};
}

} // namespace

void project_tie_state(const Tie& tie, const Particles& particles, const HexMesh& mesh,
                       const MaterialTable& materials, Real mass_factor) {
  const Particles p = particles;
  const IndexField hosts = tie.host;
  const MaterialPoints hexes = mesh.points;
  const View<int*> active = mesh.active;
  const Real correction = tie.correction;
  Kokkos::parallel_for(
      "project_tie_state", Range(0, tie.count), KOKKOS_LAMBDA(int k) {
        const int i = p.count + k, host = hosts(k);
        const bool alive = active(host) != 0;
        const Tensor3 L = load_tensor(hexes.velocity_gradient, host);
        const Real density = hexes.density(host);
        const ImpedanceOf z = scale_impedance(materials(hexes.material(host)), density, mass_factor);
        const Symmetric3 none{0, 0, 0, 0, 0, 0};
        const Symmetric3 stress = alive ? load_symmetric(hexes.stress, host) : none;
        store_symmetric(p.points.stress, i, stress);
        store_tensor(p.pair_stress, i, to_tensor(correction * stress));
        store_tensor(p.correction, i, {correction, 0, 0, 0, correction, 0, 0, 0, correction});
        store_tensor(p.points.velocity_gradient, i, L);
        store_symmetric(p.strain_rate, i, symmetric_part(L));
        store_symmetric(p.artificial_stress, i, none);
        p.impedance(i, 0) = z.impedance;
        p.impedance(i, 1) = z.density;
        p.points.density(i) = density;
        p.points.temperature(i) = hexes.temperature(host);
        p.volume(i) = alive ? p.points.mass(i) / density : Real(0);
      });
}

} // namespace swarf
