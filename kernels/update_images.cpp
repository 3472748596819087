// Copies what neighbours read from the sources of images: x' = R x + t, v' = R v, tensors R A R^T.
// update_images: position and velocity, after the drift. update_image_state: what prepare_pair_state wrote.
#include "swarf/kernels.hpp"

namespace swarf {

void update_images(const Particles& p, const Neighbors& n, const ImagePlanes& planes) {
  const int first = n.image_first;
  const auto source = n.image_source;
  for (int k = 0; k < n.planes; ++k) {
    const Transform map = planes[k].to_image;
    Kokkos::parallel_for(
        "update_images", Range(n.image_start[k], n.image_start[k + 1]), KOKKOS_LAMBDA(int image) {
          const int i = source(image), to = first + image;
          store_vector(p.position, to, apply(map, load_vector(p.position, i)));
          store_vector(p.velocity, to, multiply(map.R, load_vector(p.velocity, i)));
          p.volume(to) = p.volume(i);
          p.inverse_support(to) = p.inverse_support(i);
          for (int c = 0; c < 3; ++c) p.impedance(to, c) = p.impedance(i, c);
        });
  }
}

void update_image_state(const Particles& p, const Neighbors& n, const ImagePlanes& planes) {
  const int first = n.image_first;
  const bool initial_frame = p.deformation_gradient.extent(0) > 0;
  const auto source = n.image_source;
  const bool hourglass = p.hourglass_displacement.extent(0) > 0, tensile = p.artificial_stress.extent(0) > 0;
  const TensorField D = p.points.velocity_gradient;
  for (int k = 0; k < n.planes; ++k) {
    const Tensor3 R = planes[k].to_image.R;
    Kokkos::parallel_for(
        "update_image_state", Range(n.image_start[k], n.image_start[k + 1]), KOKKOS_LAMBDA(int image) {
          const int i = source(image), to = first + image;
          const Tensor3 stress = load_tensor(p.pair_stress, i);
          store_tensor(p.pair_stress, to, multiply(multiply(R, stress), transpose(R)));
          store_tensor(D, to, to_tensor(rotate(R, symmetric_part(load_tensor(D, i)))));
          if (tensile)
            store_symmetric(p.artificial_stress, to, rotate(R, load_symmetric(p.artificial_stress, i)));
          for (int c = 0; c < 3; ++c) p.impedance(to, c) = p.impedance(i, c);
          if (hourglass)
            store_vector(p.hourglass_displacement, to, multiply(R, load_vector(p.hourglass_displacement, i)));
          if (initial_frame) {
            const Tensor3 F = load_tensor(p.deformation_gradient, i);
            store_tensor(p.deformation_gradient, to, multiply(multiply(R, F), transpose(R)));
          }
          p.volume(to) = p.volume(i); // the stress update changed the density
          p.inverse_support(to) = p.inverse_support(i);
        });
  }
}

} // namespace swarf
