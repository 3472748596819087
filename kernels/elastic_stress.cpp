// sigma = lambda tr(L) 1 + 2 G sym(L): what a small motion L of the material does by Hooke's law, for the
// highest frequency (advance_mode.cpp). Reads velocity_gradient, temperature; writes stress, rows [0, count +
// tied).
#include "swarf/kernels.hpp"
#include "swarf/material/thermal.hpp"

namespace swarf {

void elastic_stress(const MaterialPoints& points, const MaterialTable& materials) {
  Kokkos::parallel_for(
      "elastic_stress", Range(0, points.count), KOKKOS_LAMBDA(int i) {
        const Material& mat = materials(points.material(i));
        const Real share = stiffness_share(mat, points.temperature(i)), G = share * mat.shear_modulus;
        const Symmetric3 D = symmetric_part(load_tensor(points.velocity_gradient, i));
        const Real mean = (share * mat.bulk_modulus - Real(2) / Real(3) * G) * trace(D);
        store_symmetric(points.stress, i, Real(2) * G * D + Symmetric3{mean, mean, mean, 0, 0, 0});
      });
}

} // namespace swarf
