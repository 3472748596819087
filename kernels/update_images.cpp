// Copies what neighbours read from the sources of images. update_images: what the drift moved, and what the
// sums before the forces read of a neighbour. update_image_state: what prepare_pair_state wrote and what the
// stress update changed.
#include "copy_to_images.hpp"

namespace swarf {

void update_images(const Particles& p, const Neighbors& n, const ImagePlanes& planes) {
  copy_to_images<Images::after_drift>("update_images", p, n, planes);
}

void update_image_state(const Particles& p, const Neighbors& n, const ImagePlanes& planes) {
  copy_to_images<Images::before_forces>("update_image_state", p, n, planes);
}

} // namespace swarf
