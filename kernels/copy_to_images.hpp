// Shared by the kernels after which images are behind their sources: one launch for the images of a plane.
#pragma once
#include "swarf/kernels.hpp"

namespace swarf {

// Visits the table of fields for one image.
template <Images when>
struct CopyToImage {
  int source, image;
  const Transform& map;

  template <class Field, auto... named>
  SWARF_FN void operator()(const char*, const Field& field, Facts<named...> facts) const {
    if constexpr (Facts<named...>::on_images_at(when))
      if (has_rows(field, facts)) copy_turned(field, source, image, map, facts);
  }
};

// Fields of the images of plane k, of which a plane of a later pair may make images.
template <Images when>
void copy_to_images(const char* label, const Particles& p, const Neighbors& n, const ImagePlanes& planes,
                    int k) {
  const int first = n.image_first;
  const auto source = n.image_source;
  const Transform map = planes[std::size_t(k)].to_image;
  Kokkos::parallel_for(
      label, Range(n.image_start[k], n.image_start[k + 1]), KOKKOS_LAMBDA(int image) {
        for_each_field(p, CopyToImage<when>{source(image), first + image, map});
      });
}

template <Images when>
void copy_to_images(const char* label, const Particles& p, const Neighbors& n, const ImagePlanes& planes) {
  for (int k = 0; k < n.planes; ++k) copy_to_images<when>(label, p, n, planes, k);
}

} // namespace swarf
