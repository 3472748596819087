// The cube of particle_cube.hpp as correct_surface meets it: its outer rows lack neighbours.
#pragma once
#include "bench/support/particle_cube.hpp"

namespace swarf::bench {

struct SurfaceCube {
  const ParticleCube& cube;
  Particles particles;
  TensorField L; // as velocity_gradient leaves it
  View<Real* [4]> lacking;

  void start_anew() const {
    Kokkos::deep_copy(particles.points.velocity_gradient, L);
    Kokkos::deep_copy(particles.surface_shift, lacking);
  }
  // Of the clusters that hold a particle at the surface.
  double share() const {
    const auto lack = host_copy(lacking);
    const auto first = host_copy(cube.neighbors.first), size = host_copy(cube.neighbors.size);
    int at_surface = 0;
    for (int c = 0; c < cube.neighbors.clusters; ++c) {
      bool lacks = false;
      for (int i = first(c); i < first(c) + size(c); ++i) lacks = lacks || lack(i, 0) > 0;
      at_surface += lacks;
    }
    return double(at_surface) / cube.neighbors.clusters;
  }
};

inline SurfaceCube surface_cube(int64_t size) {
  const ParticleCube& cube = particle_cube(size);
  SurfaceCube s{cube, cube.particles, {}, {}};
  Particles& p = s.particles;
  p.surface_shift = View<Real* [4]>("surface_shift", p.count);
  p.edge_normal = VectorField("edge_normal", p.count);
  p.surface_term = TensorField("surface_term", p.count);
  velocity_gradient(p, cube.neighbors, cube.method);
  s.L = Kokkos::create_mirror(ExecSpace::memory_space{}, p.points.velocity_gradient);
  s.lacking = Kokkos::create_mirror(ExecSpace::memory_space{}, p.surface_shift);
  Kokkos::deep_copy(s.L, p.points.velocity_gradient), Kokkos::deep_copy(s.lacking, p.surface_shift);
  return s;
}

} // namespace swarf::bench
