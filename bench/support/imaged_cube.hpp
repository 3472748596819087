// The cube of particles with images across two periodic faces.
#pragma once
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {

struct ImagedCube {
  Particles particles; // their fields are longer than the cube's, by the images
  Neighbors lists;     // of images only
  ImagePlanes planes;
};

inline ImagedCube make_imaged_cube(int64_t size) {
  const ParticleCube& cube = particle_cube(size);
  const Real edge = Real(cube_edge(size)) * spacing;
  const Vector3 z{0, 0, 1};
  ImagedCube c{cube.particles,
               Neighbors{},
               {{z, 0, {identity3(), edge * z}, true, true},
                {Real(-1) * z, -edge, {identity3(), (-edge) * z}, true, true}}};
  c.lists.cutoff = cube.neighbors.cutoff;
  make_images(c.particles, c.lists, c.planes);
  return c;
}

} // namespace swarf::bench
