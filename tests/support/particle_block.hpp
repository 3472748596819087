// A block of particles for tests: cubic lattice, optionally disordered, ready for the kernels.
#pragma once
#include "swarf/kernels.hpp"
#include <random>

namespace swarf::test {

struct ParticleBlock {
  Particles particles;
  Neighbors neighbors;
  MaterialTable materials;
  ParticleMethod method;
  CellGrid lattice; // one particle in each cell
};

inline void allocate(Particles& p, int rows) {
  for_each_field(p, [&](const char* name, auto& field, auto facts) {
    const Method method = facts.method;
    if (method == Method::always || method == Method::with_hourglass_stiffness ||
        method == Method::with_freeze)
      field = std::decay_t<decltype(field)>(name, rows);
  });
}

// What a field holds now.
template <class Field>
Field copy_of(const Field& field) {
  const Field copy(field.label(), field.extent(0));
  Kokkos::deep_copy(copy, field);
  return copy;
}

// Each of the first rows becomes value(what it is).
template <class Function>
void set_rows(const VectorField& field, int count, Function&& value) {
  const auto f = host_copy(field);
  for (int i = 0; i < count; ++i) store_vector(f, i, value(load_vector(f, i)));
  Kokkos::deep_copy(field, f);
}

inline Material elastic_steel() {
  Material m;
  m.density = 7800, m.bulk_modulus = 1e11, m.shear_modulus = 8e10, m.specific_heat = 500;
  return m;
}

// counts particles along each axis from (spacing/2, ...); disorder: largest shift of a particle over the
// spacing.
inline ParticleBlock particle_block(int nx, int ny, int nz, Real spacing, Real disorder = 0,
                                    Real ratio = Real(1.2)) {
  ParticleBlock b;
  Particles& p = b.particles;
  const int n = nx * ny * nz;
  p.count = p.points.count = p.listed = p.stored = p.total = p.whole = n;
  allocate(p, n);
  b.materials = MaterialTable("materials", 1);
  const auto materials = Kokkos::create_mirror_view(b.materials);
  materials(0) = elastic_steel();
  Kokkos::deep_copy(b.materials, materials);
  const auto x = host_copy(p.position);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<Real> shift(-disorder * spacing, disorder * spacing);
  for (int k = 0, i = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int l = 0; l < nx; ++l, ++i)
        x(i, 0) = (l + Real(0.5)) * spacing + shift(random),
             x(i, 1) = (j + Real(0.5)) * spacing + shift(random),
             x(i, 2) = (k + Real(0.5)) * spacing + shift(random);
  Kokkos::deep_copy(p.position, x);
  const Real volume = spacing * spacing * spacing;
  Kokkos::deep_copy(p.volume, volume), Kokkos::deep_copy(p.points.mass, volume * materials(0).density);
  Kokkos::deep_copy(p.points.density, materials(0).density);
  Kokkos::deep_copy(p.inverse_support, Real(0.5) / (ratio * spacing));
  b.neighbors.skin = Real(0.1) * 2 * ratio * spacing;
  b.neighbors.cutoff = 2 * ratio * spacing + b.neighbors.skin;
  b.method.spacing_ratio = 1 / ratio;
  b.lattice.cell_size = spacing;
  return b;
}

inline void build_lists(ParticleBlock& b, const GhostPlanes& planes = {}) {
  sort_particles(b.particles, b.lattice);
  make_ghosts(b.particles, b.neighbors, planes);
  find_neighbors(b.neighbors, b.particles);
  update_ghosts(b.particles, b.neighbors, planes);
}

} // namespace swarf::test
