// A cube of hexes as the kernels meet it: distorted cells, sheared and stressed.
#pragma once
#include "bench/support/bench.hpp"
#include "bench/support/noise.hpp"
#include "swarf/kernels.hpp"
#include "tests/support/hex_block.hpp"
#include "tests/support/materials.hpp"
#include "tests/support/status.hpp"

namespace swarf::bench {

struct HexCube {
  HexMesh mesh;
  MaterialTable materials;
  HexMethod method;
  Status status;

  double count() const { return mesh.points.count; }
  double nodes_per_hex() const { return double(mesh.nodes) / mesh.points.count; }
};

inline constexpr Real hex_edge = Real(5e-6);       // m
inline constexpr Real hex_time_step = Real(4e-10); // s

inline void set_state(const HexCube& c) {
  const HexMesh m = c.mesh;
  const Real rate = Real(1e4), swing = Real(0.01) * rate * hex_edge, level = Real(3e8);
  Kokkos::parallel_for(
      "bench_nodes", Range(0, m.nodes), KOKKOS_LAMBDA(int a) {
        const Noise noise{unsigned(a)};
        const Vector3 x = load_vector(m.position, a);
        store_vector(m.velocity, a,
                     Vector3{rate * x.y + swing * noise(0), swing * noise(1), swing * noise(2)});
      });
  Kokkos::parallel_for(
      "bench_hexes", Range(0, m.points.count), KOKKOS_LAMBDA(int e) {
        const Noise noise{unsigned(e)};
        store_symmetric(m.points.stress, e,
                        level * Symmetric3{noise(3), noise(4), noise(5), Real(0.5) * noise(6),
                                           Real(0.5) * noise(7), Real(0.5) * noise(8)});
      });
}

// The fields of conduction.
inline void add_heat(HexMesh& m) {
  m.corner_heat = View<Real* [8]>("corner_heat", m.points.count);
  m.nodal_heat = ScalarField("nodal_heat", m.nodes);
  m.nodal_temperature = ScalarField("nodal_temperature", m.nodes);
  m.heat_capacity = ScalarField("heat_capacity", m.nodes);
  Kokkos::deep_copy(m.nodal_temperature, Real(298.15)), Kokkos::deep_copy(m.heat_capacity, Real(1));
}

inline HexCube make_hex_cube(int64_t size) {
  const int n = cube_edge(size);
  const Material mat = test::ti64();
  HexCube c{test::make_distorted_block({n, n, n}, mat, hex_edge, 0.05), test::make_material_table({mat}),
            HexMethod{}, test::make_status()};
  c.method.hourglass_coefficient = Real(0.1);
  c.method.viscosity_linear = Real(0.06), c.method.viscosity_quadratic = Real(1.2);
  set_state(c);
  hex_velocity_gradient(c.mesh, c.status);
  return c;
}

inline const HexCube& hex_cube(int64_t size) { return cached(size, make_hex_cube); }

} // namespace swarf::bench
