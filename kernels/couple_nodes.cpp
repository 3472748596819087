#include "swarf/kernels.hpp"

namespace swarf {

// Periodic pairs of nodes move as one node seen twice, slave = R master. Each carries half of its mass (the
// scene makes the masses of a pair equal), so that sums over nodes count it once. Forces in: both get the
// mean, f_master = (f_master + R^T f_slave) / 2, f_slave = R f_master. Velocities out: v_slave = R v_master.
// One pass per transform: within a pass a node is in one row at most, and a node on the edge of two periodic
// directions gets the mean of all its copies, pass after pass, without atomics.
// Reads coupled_nodes and the table; reads and writes force, or velocity.
void couple_nodes(const HexMesh& m, const TransformTable& transforms, bool forces) {
  const int rows = int(m.coupled_nodes.extent(0));
  if (rows == 0) return;
  for (int pass = 0; pass < int(transforms.extent(0)); ++pass)
    Kokkos::parallel_for(
        "couple_nodes", Range(0, rows), KOKKOS_LAMBDA(const int k) {
          const int master = m.coupled_nodes(k, 0), slave = m.coupled_nodes(k, 1);
          if (m.coupled_nodes(k, 2) != pass) return;
          const Tensor3 R = transforms(pass).R;
          const VectorField& field = forces ? m.force : m.velocity;
          Vector3 u = load_vector(field, master);
          if (forces) {
            u = Real(0.5) * (u + multiply(transpose(R), load_vector(field, slave)));
            store_vector(field, master, u);
          }
          store_vector(field, slave, multiply(R, u));
        });
}

// The same for the scalar: both nodes of a pair get the mean of their heats.
void couple_heat(const HexMesh& m, const TransformTable& transforms) {
  const int rows = int(m.coupled_nodes.extent(0));
  for (int pass = 0; pass < int(transforms.extent(0)) && rows > 0; ++pass)
    Kokkos::parallel_for(
        "couple_heat", Range(0, rows), KOKKOS_LAMBDA(const int k) {
          const int master = m.coupled_nodes(k, 0), slave = m.coupled_nodes(k, 1);
          if (m.coupled_nodes(k, 2) != pass) return;
          const Real mean = Real(0.5) * (m.nodal_heat(master) + m.nodal_heat(slave));
          m.nodal_heat(master) = m.nodal_heat(slave) = mean;
        });
}

} // namespace swarf
