// Blocks of particles that flow, and shifts of them, for tests.
#pragma once
#include "support/particle_block.hpp"
#include <vector>

namespace swarf::test {

inline constexpr Real unit = Real(1e-3); // spacing, m

inline void set_identity(const Particles& p) {
  const auto identity = host_copy(p.identity);
  for (int i = 0; i < p.stored; ++i) identity(i) = i;
  Kokkos::deep_copy(p.identity, identity);
}

// With the fields of shifting, and the plastic strain given, none of it shifted yet.
inline ParticleBlock flowing_block(int nx, int ny, int nz, Real disorder, Real strain, Real spacing = unit) {
  ParticleBlock b = particle_block(nx, ny, nz, spacing, disorder);
  for_each_field(b.particles, [&](const char* name, auto& field, auto facts) {
    const Method method = facts.method;
    if (method == Method::with_shifting) field = std::decay_t<decltype(field)>(name, b.particles.stored);
  });
  Kokkos::deep_copy(b.particles.points.equivalent_plastic_strain, strain);
  set_identity(b.particles);
  return b;
}

inline GhostPlanes periodic_along(int axis, Real length) {
  const Vector3 n{Real(axis == 0), Real(axis == 1), Real(axis == 2)};
  return {{n, 0, {identity3(), length * n}, true, true},
          {Real(-1) * n, -length, {identity3(), (-length) * n}, true, true}};
}

// About (1, 2, 2) / 3, by 0.7 (Rodrigues).
inline Tensor3 oblique_rotation() {
  const Real x = Real(1) / 3, y = Real(2) / 3, z = y, c = std::cos(Real(0.7)), s = std::sin(Real(0.7));
  const Real m = 1 - c;
  return {c + x * x * m,     x * y * m - z * s, x * z * m + y * s, y * x * m + z * s, c + y * y * m,
          y * z * m - x * s, z * x * m - y * s, z * y * m + x * s, c + z * z * m};
}

// A field of slots or of rows, by the identity of the particle; 0 where no slot is.
inline std::vector<Vector3> by_identity(const ParticleBlock& b, const Shifts& shifts, const VectorField& of) {
  std::vector<Vector3> found(std::size_t(b.particles.stored), Vector3{0, 0, 0});
  const auto identity = host_copy(b.particles.identity), cluster = host_copy(shifts.cluster),
             first = host_copy(b.neighbors.first), size = host_copy(b.neighbors.size);
  const auto value = host_copy(of);
  for (int k = 0; k < shifts.clusters(); ++k)
    for (int lane = 0; lane < size(cluster(k)); ++lane)
      found[std::size_t(identity(first(cluster(k)) + lane))] = load_vector(value, k * pack_width + lane);
  return found;
}
inline std::vector<Vector3> by_identity(const ParticleBlock& b, const VectorField& of) {
  std::vector<Vector3> found(std::size_t(b.particles.stored));
  const auto identity = host_copy(b.particles.identity);
  const auto value = host_copy(of);
  for (int i = 0; i < b.particles.stored; ++i) found[std::size_t(identity(i))] = load_vector(value, i);
  return found;
}

// Finds, shifts and transports, on the lists as they are.
inline Shifts shift_once(const ParticleBlock& b, const GhostPlanes& planes = {}, Real mass_factor = 1) {
  update_ghosts(b.particles, b.neighbors, planes);
  const Shifts shifts = find_shifts(b.particles, b.neighbors, planes, b.method);
  transport_fields(b.particles, b.neighbors, planes, b.materials, shifts, mass_factor);
  return shifts;
}

// Of every particle by displacement(row), with K as velocity_gradient has it.
template <class Function>
Shifts make_shifts(const ParticleBlock& b, Function&& displacement) {
  const Neighbors& n = b.neighbors;
  velocity_gradient(b.particles, n, b.method);
  Shifts shifts{IndexField("cluster", n.clusters), VectorField("displacement", n.clusters * pack_width),
                VectorField("corrected", n.clusters * pack_width),
                VectorField("normal", n.clusters * pack_width)};
  const auto cluster = host_copy(shifts.cluster), first = host_copy(n.first), size = host_copy(n.size);
  const auto d = host_copy(shifts.displacement), corrected = host_copy(shifts.corrected);
  const auto K = host_copy(b.particles.pair_stress);
  for (int k = 0; k < n.clusters; ++k) {
    cluster(k) = k;
    for (int lane = 0; lane < size(k); ++lane) {
      const int i = first(k) + lane;
      const Vector3 by = displacement(i);
      store_vector(d, k * pack_width + lane, by);
      store_vector(corrected, k * pack_width + lane, multiply(load_tensor(K, i), by));
    }
  }
  Kokkos::deep_copy(shifts.cluster, cluster), Kokkos::deep_copy(shifts.displacement, d);
  Kokkos::deep_copy(shifts.corrected, corrected);
  return shifts;
}

} // namespace swarf::test
