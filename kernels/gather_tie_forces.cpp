// f_a += sum_k N_a f_k over the tied particles k whose force goes to the face that node a belongs to. The
// weights of a face sum to 1, so the total force passes to round-off. One thread sums one node, in a fixed
// order. Reads force of the tied rows. Adds to the nodes' force.
#include "swarf/kernels.hpp"

namespace swarf {

void gather_tie_forces(const Tie& tie, const Particles& p, const HexMesh& hexes) {
  const int first = p.count;
  const VectorField from = p.force, to = hexes.force;
  Kokkos::parallel_for(
      "gather_tie_forces", Range(0, int(tie.row_node.extent(0))), KOKKOS_LAMBDA(int row) {
        const int node = tie.row_node(row);
        Vector3 f = load_vector(to, node);
        for (int e = tie.start(row); e < tie.start(row + 1); ++e) {
          const int k = tie.entry(e) / 4, corner = tie.entry(e) % 4;
          f = f + tie.face_shape(k, corner) * load_vector(from, first + k);
        }
        store_vector(to, node, f);
      });
}

} // namespace swarf
