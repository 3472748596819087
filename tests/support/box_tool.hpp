// A box as a tool, without a generator: 12 facets, all in one cell of the grid. And points for it to touch.
#pragma once
#include "swarf/tool/contact_points.hpp"
#include "swarf/tool/tool.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace swarf::test {

// Centred on the tool's origin; the grid reaches `margin` beyond the faces.
inline Tool make_box_tool(const std::array<double, 3>& half, double margin) {
  Tool tool;
  tool.facets = 12;
  tool.vertex = View<Real* [3][3]>("vertex", 12);
  tool.pseudonormal = View<Real* [7][3]>("pseudonormal", 12);
  const auto vertex = Kokkos::create_mirror_view(tool.vertex);
  const auto normal = Kokkos::create_mirror_view(tool.pseudonormal);
  for (int f = 0; f < 12; ++f) {
    const int axis = f / 4, sign = (f / 2) % 2 ? 1 : -1, b = (axis + 1) % 3, c = (axis + 2) % 3;
    // Two facets of a face, counter-clockwise about +axis; the other way round about -axis.
    const int corners[2][3][2] = {{{-1, -1}, {1, -1}, {1, 1}}, {{-1, -1}, {1, 1}, {-1, 1}}};
    double at[3][3];
    for (int k = 0; k < 3; ++k) {
      const int* corner = corners[f % 2][sign > 0 ? k : 2 - k];
      at[k][axis] = sign, at[k][b] = corner[0], at[k][c] = corner[1];
    }
    // Pseudonormals by symmetry: the sum of the normals of the faces that meet.
    for (int d = 0; d < 3; ++d) {
      normal(f, 0, d) = Real(d == axis ? sign : 0);
      for (int k = 0; k < 3; ++k) {
        vertex(f, k, d) = Real(half[d] * at[k][d]);
        normal(f, 4 + k, d) = Real(at[k][d] / std::sqrt(3.0));
      }
    }
    for (int k = 0; k < 3; ++k) { // the middle of an edge tells which faces meet there
      double sum[3], length = 0;
      for (int d = 0; d < 3; ++d) {
        const double middle = (at[k][d] + at[(k + 1) % 3][d]) / 2;
        sum[d] = middle, length += middle * middle;
      }
      for (int d = 0; d < 3; ++d) normal(f, 1 + k, d) = Real(sum[d] / std::sqrt(length));
    }
  }
  Kokkos::deep_copy(tool.vertex, vertex);
  Kokkos::deep_copy(tool.pseudonormal, normal);

  tool.cell_size = Real(2 * (std::max({half[0], half[1], half[2]}) + margin));
  tool.grid_origin = Real(-0.5) * Vector3{tool.cell_size, tool.cell_size, tool.cell_size};
  tool.cells[0] = tool.cells[1] = tool.cells[2] = 1;
  tool.reach = Real(margin);
  tool.cell_start = IndexField("cell_start", 2), tool.cell_facet = IndexField("cell_facet", 12);
  tool.facet_distance = ScalarField("facet_distance", 12); // 0: every facet is looked at
  tool.cell_distance = ScalarField("cell_distance", 1);    // 0: the cell says nothing
  const auto start = Kokkos::create_mirror_view(tool.cell_start);
  const auto facet = Kokkos::create_mirror_view(tool.cell_facet);
  start(0) = 0, start(1) = 12;
  for (int f = 0; f < 12; ++f) facet(f) = f;
  Kokkos::deep_copy(tool.cell_start, start);
  Kokkos::deep_copy(tool.cell_facet, facet);
  return tool;
}

// All of one mass, at rest in the origin; gap 0, area 1, no temperature.
inline ContactPoints make_contact_points(int count, double mass) {
  ContactPoints p;
  p.count = count;
  p.position = VectorField("position", count), p.velocity = VectorField("velocity", count);
  p.mass = ScalarField("mass", count), p.gap = ScalarField("gap", count), p.area = ScalarField("area", count);
  p.force = VectorField("force", count), p.friction_force = VectorField("friction_force", count);
  p.contact_force = VectorField("contact_force", count);
  p.friction_work = ScalarField("friction_work", count);
  p.contact_energy = ScalarField("contact_energy", count);
  p.material = IndexField("material", count);
  Kokkos::deep_copy(p.mass, Real(mass));
  Kokkos::deep_copy(p.area, Real(1));
  return p;
}

inline void set_row(const VectorField& field, int i, const Vector3& v) {
  const auto host = host_copy(field);
  store_vector(host, i, v);
  Kokkos::deep_copy(field, host);
}
inline Vector3 get_row(const VectorField& field, int i) { return load_vector(host_copy(field), i); }
inline Real get_row(const ScalarField& field, int i) { return host_copy(field)(i); }

} // namespace swarf::test
