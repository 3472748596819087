// What a tied particle shows the particles near it: P = sigma K, with the K of an undeformed lattice, so that
// a constant stress crosses the interface; sigma and L linear between hexes (tie.hpp); T, the impedance of
// the mass-scaled material and V = m / rho of the host. No artificial stress: hexes have no tensile
// instability. Beside a deleted hex the host's own values count; a deleted host shows nothing: stress and
// volume 0. Reads points and active of the hexes. Writes the tied rows.
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

struct HexState {
  Symmetric3 stress;
  Tensor3 L;
};

SWARF_FN HexState interpolate_state(const Tie& tie, int k, const HexMesh& mesh) {
  HexState sum{{0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0, 0}};
  bool whole = true;
  for (int n = 0; n < 7; ++n) whole = whole && mesh.active(tie.state_hex(k, n)) != 0;
  for (int n = 0; n < 7; ++n) {
    const int hex = tie.state_hex(k, n);
    const Real weight = whole ? tie.state_weight(k, n) : Real(n == 0 ? 1 : 0);
    sum.stress = sum.stress + weight * load_symmetric(mesh.points.stress, hex);
    const Tensor3 L = load_tensor(mesh.points.velocity_gradient, hex);
    sum.L = sum.L + Tensor3{weight * L.xx, weight * L.xy, weight * L.xz, weight * L.yx, weight * L.yy,
                            weight * L.yz, weight * L.zx, weight * L.zy, weight * L.zz};
  }
  return sum;
}

} // namespace

void project_tie_state(const Tie& t, const Particles& particles, const HexMesh& m,
                       const MaterialTable& materials, Real mass_factor) {
  const Tie tie = t; // the kernel's own copies of the Views
  const Particles p = particles;
  const HexMesh mesh = m;
  Kokkos::parallel_for(
      "project_tie_state", Range(0, tie.count), KOKKOS_LAMBDA(int k) {
        const int i = p.count + k, host = tie.host(k);
        const bool alive = mesh.active(host) != 0;
        const Real density = mesh.points.density(host), K = tie.correction;
        const ImpedanceOf z = scale_impedance(materials(mesh.points.material(host)), density, mass_factor);
        HexState state = interpolate_state(tie, k, mesh);
        if (!alive) state.stress = {0, 0, 0, 0, 0, 0};
        store_symmetric(p.points.stress, i, state.stress);
        store_tensor(p.pair_stress, i, to_tensor(K * state.stress));
        store_tensor(p.correction, i, {K, 0, 0, 0, K, 0, 0, 0, K});
        store_tensor(p.points.velocity_gradient, i, state.L);
        store_symmetric(p.strain_rate, i, symmetric_part(state.L));
        store_symmetric(p.artificial_stress, i, {0, 0, 0, 0, 0, 0});
        p.impedance(i, 0) = z.impedance;
        p.impedance(i, 1) = z.density;
        p.points.density(i) = density;
        p.points.temperature(i) = mesh.points.temperature(host);
        p.volume(i) = alive ? p.points.mass(i) / density : Real(0);
      });
}

} // namespace swarf
