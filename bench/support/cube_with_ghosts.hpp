// The cube of particles with ghosts across two periodic faces.
#pragma once
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {

struct CubeWithGhosts {
  Particles particles; // their fields are longer than the cube's, by the ghosts
  Neighbors lists;     // of ghosts only
  GhostPlanes planes;
};

inline CubeWithGhosts make_cube_with_ghosts(int64_t size) {
  const ParticleCube& cube = particle_cube(size);
  const Real edge = Real(cube_edge(size)) * spacing;
  const Vector3 z{0, 0, 1};
  CubeWithGhosts c{cube.particles,
                   Neighbors{},
                   {{z, 0, {identity3(), edge * z}, true, true},
                    {Real(-1) * z, -edge, {identity3(), (-edge) * z}, true, true}}};
  c.lists.cutoff = cube.neighbors.cutoff;
  make_ghosts(c.particles, c.lists, c.planes);
  return c;
}

} // namespace swarf::bench
