// x_k = sum_a N_a x_a,  v_k = sum_a N_a v_a over the 8 nodes of the host hex: exact for linear fields.
// Reads node positions and velocities. Writes position and velocity of the tied rows.
#include "swarf/kernels.hpp"

namespace swarf {

void project_tie(const Tie& tie, const Particles& p, const HexMesh& hexes) {
  const int first = p.count, whole = p.whole;
  const IndexField identity = p.identity;
  const VectorField x = p.position, v = p.velocity, node_x = hexes.position, node_v = hexes.velocity;
  const View<int* [8]> connectivity = hexes.connectivity;
  Kokkos::parallel_for(
      "project_tie", Range(first, first + p.tied), KOKKOS_LAMBDA(int row) {
        const int k = identity(row) - whole;
        Vector3 x_k{0, 0, 0}, v_k{0, 0, 0};
        for (int a = 0; a < 8; ++a) {
          const int node = connectivity(tie.host(k), a);
          const Real N_a = tie.shape(k, a);
          x_k = x_k + N_a * load_vector(node_x, node);
          v_k = v_k + N_a * load_vector(node_v, node);
        }
        store_vector(x, row, x_k);
        store_vector(v, row, v_k);
      });
}

} // namespace swarf
