// Holds the nodes that are farther from the active region than sleep.distance (freeze.hpp), and freezes
// the hexes whose nodes are all held. Nodes of a periodic pair are held together. What stops gives its
// kinetic energy to external_work. Reads positions, connectivity, coupled_nodes; writes constraints, damping,
// active.
#include "region_cells.hpp"

namespace swarf {
namespace {

void hold_nodes(const HexMesh& m, const VectorField& region, const Freeze& s) {
  const RegionCells cells = group_cells(region, s);
  Kokkos::parallel_for(
      "hold_nodes", Range(0, m.nodes), KOKKOS_LAMBDA(int a) {
        const Real d = distance_to(cells, load_vector(m.position, a));
        m.damping(a) = damping_at(s, d);
        m.constraints(a) = (m.constraints(a) & ~held_bit) | (d <= s.distance ? 0u : held_bit);
      });
}

// A pass per transform, as couple_nodes: within a pass a node is in one row at most.
void free_pairs(const HexMesh& m, int transforms) {
  const int rows = int(m.coupled_nodes.extent(0));
  for (int pass = 0; pass < transforms; ++pass)
    Kokkos::parallel_for(
        "free_pairs", Range(0, rows), KOKKOS_LAMBDA(int k) {
          if (m.coupled_nodes(k, 2) != pass) return;
          const int a = m.coupled_nodes(k, 0), b = m.coupled_nodes(k, 1);
          const unsigned both = m.constraints(a) & m.constraints(b) & held_bit;
          const Real damping = Kokkos::min(m.damping(a), m.damping(b));
          m.constraints(a) = (m.constraints(a) & ~held_bit) | both;
          m.constraints(b) = (m.constraints(b) & ~held_bit) | both;
          m.damping(a) = m.damping(b) = damping;
        });
}

void stop_held(const HexMesh& m, Real mass_factor) {
  Kokkos::parallel_for(
      "stop_held", Range(0, m.nodes), KOKKOS_LAMBDA(int a) {
        if (!(m.constraints(a) & held_bit)) return;
        const Vector3 v = load_vector(m.velocity, a);
        m.external_work(a) -= Real(0.5) * mass_factor * m.mass(a) * dot(v, v);
        store_vector(m.velocity, a, {0, 0, 0});
      });
}

void freeze(const HexMesh& m) {
  Kokkos::parallel_for(
      "freeze_hexes", Range(0, m.points.count), KOKKOS_LAMBDA(int e) {
        if (m.active(e) == hex_deleted) return;
        bool moves = false;
        for (int a = 0; a < 8; ++a) moves |= !(m.constraints(m.connectivity(e, a)) & held_bit);
        m.active(e) = moves ? hex_active : hex_frozen;
        if (moves) return;
        store_tensor(m.points.velocity_gradient, e, Tensor3{});
        m.points.plastic_strain_rate(e) = 0;
      });
}

} // namespace

void freeze_hexes(const HexMesh& m, const TransformTable& transforms, const VectorField& region,
                  const Freeze& s) {
  hold_nodes(m, region, s);
  free_pairs(m, int(transforms.extent(0)));
  stop_held(m, s.mass_factor);
  freeze(m);
}

} // namespace swarf
