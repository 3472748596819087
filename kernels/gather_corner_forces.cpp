#include "swarf/kernels.hpp"

namespace swarf {

// Force of each node = sum of the forces at its corners, in the order of the CSR rows: no atomics, so the sum
// is the same on any number of threads. Reads corner_force, corner_start, corner_of_node; sets force.
void gather_corner_forces(const HexMesh& m) {
  Kokkos::parallel_for(
      "gather_corner_forces", Range(0, m.nodes), KOKKOS_LAMBDA(const int a) {
        if (m.constraints(a) & held_bit) return store_vector(m.force, a, {0, 0, 0});
        Vector3 sum{0, 0, 0};
        for (int k = m.corner_start(a); k < m.corner_start(a + 1); ++k) {
          const int e = m.corner_of_node(k) / 8, corner = m.corner_of_node(k) % 8;
          sum = sum + Vector3{m.corner_force(e, corner, 0), m.corner_force(e, corner, 1),
                              m.corner_force(e, corner, 2)};
        }
        store_vector(m.force, a, sum);
      });
}

} // namespace swarf
