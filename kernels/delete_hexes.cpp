#include "swarf/kernels.hpp"

namespace swarf {

// Deletes hexes that failed (damage 1) or reached a plastic strain, each criterion if the method asks for it.
// A deleted hex keeps its mass at its nodes and its works; it has no stress, no rate and no force any more.
// Reads damage, equivalent_plastic_strain; writes active, stress, velocity_gradient, plastic_strain_rate,
// hourglass.
void delete_hexes(const HexMesh& m, const HexMethod& method) {
  const bool failed = method.delete_failed;
  const Real limit = method.delete_at_strain;
  if (!failed && limit == Real(0)) return;
  Kokkos::parallel_for(
      "delete_hexes", Range(0, m.points.count), KOKKOS_LAMBDA(const int e) {
        const bool broken = failed && m.points.damage(e) >= Real(1);
        const bool strained = limit > Real(0) && m.points.equivalent_plastic_strain(e) >= limit;
        if (m.active(e) == hex_frozen || (m.active(e) && !(broken || strained))) return;
        m.active(e) = 0;
        store_symmetric(m.points.stress, e, Symmetric3{});
        store_tensor(m.points.velocity_gradient, e, Tensor3{});
        m.points.plastic_strain_rate(e) = 0;
        for (int k = 0; k < 4; ++k)
          for (int i = 0; i < 3; ++i) m.hourglass(e, k, i) = 0;
      });
}

} // namespace swarf
