// Energies, momentum and extremes of particles and of hexes, for the history: once per sample, not per step.
#include "block_sum.hpp"
#include "swarf/kernels.hpp"

namespace swarf {
namespace {

KOKKOS_INLINE_FUNCTION void add_motion(PointSums& s, Real mass, const Vector3& v) {
  const Real speed2 = dot(v, v);
  s.kinetic += Real(0.5) * mass * speed2;
  s.momentum = s.momentum + mass * v;
  s.max_speed = Kokkos::max(s.max_speed, Kokkos::sqrt(speed2));
}

KOKKOS_INLINE_FUNCTION void add_point(PointSums& s, const MaterialPoints& p, int i) {
  s.internal += p.internal_work(i);
  s.plastic += p.plastic_work(i);
  s.max_plastic_strain = Kokkos::max(s.max_plastic_strain, p.equivalent_plastic_strain(i));
  if (p.temperature(i) > s.max_temperature) s.max_temperature = p.temperature(i), s.hottest = i;
}

} // namespace

// What has retired counts in the sums, not in the extremes: those are of what is computed.
PointSums sum_particles(const Particles& p, Real mass_factor, int begin, int end) {
  const auto add = KOKKOS_LAMBDA(int row, PointSums& sums) {
    const int i = begin + row;
    const bool retired = p.constraints(i) & retired_bit;
    PointSums apart;
    PointSums& s = retired ? apart : sums;
    s.viscous += p.viscous_work(i);
    s.hourglass += p.hourglass_work(i);
    if (p.shifting_work.extent(0) > 0) s.shifting += p.shifting_work(i);
    add_point(s, p.points, i);
    if (i >= p.count && i < p.count + p.tied) return; // a tied particle's mass is its hex's
    add_motion(s, mass_factor * p.points.mass(i), load_vector(p.velocity, i));
    s.external += p.external_work(i);
    s.friction += p.friction_work(i);
    s.contact += p.contact_energy(i);
    if (p.body_contact_energy.extent(0) > 0) s.contact += p.body_contact_energy(i);
    if (!retired) return;
    apart.max_temperature = apart.max_plastic_strain = apart.max_speed = 0;
    sums.add(apart);
  };
  return block_sum<PointSums>("sum_particles", end - begin, add);
}

PointSums sum_hexes(const HexMesh& m, Real mass_factor) {
  const auto add_hex = KOKKOS_LAMBDA(int e, PointSums& s) {
    add_point(s, m.points, e);
    s.viscous += m.viscous_work(e);
    s.hourglass += m.hourglass_work(e);
  };
  const auto add_node = KOKKOS_LAMBDA(int a, PointSums& s) {
    add_motion(s, mass_factor * m.mass(a), load_vector(m.velocity, a));
    s.external += m.external_work(a);
    s.friction += m.friction_work(a);
    s.contact += m.contact_energy(a);
    if (m.body_contact_energy.extent(0) > 0) s.contact += m.body_contact_energy(a);
  };
  PointSums total = block_sum<PointSums>("sum_hexes", m.points.count, add_hex);
  total.add(block_sum<PointSums>("sum_nodes", m.nodes, add_node));
  return total;
}

} // namespace swarf
