// A particle that left through a periodic plane comes back through its partner, with all that has a
// direction. A particle outside by more than a whole period, or with a position that is no number, is lost.
#include "swarf/kernels.hpp"

namespace swarf {

void wrap_periodic(const Particles& p, const ImagePlanes& planes, const Status& status) {
  const bool hourglass = p.hourglass_displacement.extent(0) > 0;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (!planes[k].periodic) continue;
    const ImagePlane plane = planes[k];
    const auto stress = p.points.stress;
    const auto L = p.points.velocity_gradient;
    Kokkos::parallel_for(
        "wrap_periodic", Range(0, p.count), KOKKOS_LAMBDA(int i) {
          const Vector3 x = load_vector(p.position, i);
          if (dot(plane.normal, x) >= plane.offset) return;
          const Transform& map = plane.to_image;
          const Vector3 wrapped = apply(map, x);
          if (!(dot(plane.normal, wrapped) >= plane.offset)) // rows are sorted before anyone reads it
            report(status, Fault::particle_lost, p.identity(i));
          store_vector(p.position, i, wrapped);
          const auto turn = [&](const VectorField& field) {
            store_vector(field, i, multiply(map.R, load_vector(field, i)));
          };
          turn(p.velocity), turn(p.force), turn(p.friction_force), turn(p.contact_force);
          if (hourglass) turn(p.hourglass_displacement), turn(p.hourglass_rate);
          store_symmetric(stress, i, rotate(map.R, load_symmetric(stress, i)));
          store_tensor(L, i, multiply(multiply(map.R, load_tensor(L, i)), transpose(map.R)));
        });
  }
}

} // namespace swarf
