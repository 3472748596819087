// f_a += sum_k N_a f_k over the tied particles k whose host has node a. The weights of a particle sum to 1
// and place it, so the total force, moment and power pass to round-off. One thread sums one node, in a fixed
// order. Reads force of the tied rows. Adds to the force of nodes that are not held.
#include "swarf/kernels.hpp"

namespace swarf {

void gather_tie_forces(const Tie& t, const Particles& p, const HexMesh& hexes) {
  const Tie tie = t; // the kernel's own copies of the Views
  const VectorField from = p.force, to = hexes.force;
  const View<unsigned*> constraints = hexes.constraints;
  Kokkos::parallel_for(
      "gather_tie_forces", Range(0, int(tie.row_node.extent(0))), KOKKOS_LAMBDA(int row) {
        const int node = tie.row_node(row);
        if (constraints(node) & held_bit) return;
        Vector3 f = load_vector(to, node);
        for (int e = tie.start(row); e < tie.start(row + 1); ++e) {
          const int k = tie.entry(e) / 8, corner = tie.entry(e) % 8;
          f = f + tie.shape(k, corner) * load_vector(from, tie.row(k));
        }
        store_vector(to, node, f);
      });
}

} // namespace swarf
