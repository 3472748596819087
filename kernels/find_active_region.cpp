// Where the active region is: the middle of each cell that holds a point that is nearer than freeze.near to
// the tool, or at least as fast as freeze.speed. Reads position, velocity and constraints of all stored
// particles and nodes; what has retired does not act. with_images: these points and their images across
// periodic and mirror planes.
#include "append_points.hpp"
#include "swarf/tool/signed_distance.hpp"

namespace swarf {
namespace {

struct Acts {
  Tool tool;
  ToolFrame frame;
  Real near, speed2;
  VectorField position, velocity;
  View<unsigned*> constraints;

  SWARF_FN bool operator()(int i) const {
    if (constraints(i) & retired_bit) return false;
    const Vector3 v = load_vector(velocity, i);
    if (dot(v, v) >= speed2) return true;
    return is_within(tool, to_tool(frame, load_vector(position, i)), near);
  }
};

// A grid that does not move with what it holds.
CellGrid fixed_grid(const VectorField& points, int rows, Real cell) {
  CellGrid grid = cell_grid(points, rows, cell);
  for (Real* x : {&grid.origin.x, &grid.origin.y, &grid.origin.z}) *x = cell * Kokkos::floor(*x / cell);
  return grid;
}

// The middles of the cells that hold a point, along a Hilbert curve.
VectorField thin_out(const VectorField& points, int rows, Real cell) {
  if (rows == 0) return VectorField("active_region", 0);
  const CellGrid grid = fixed_grid(points, rows, cell);
  const KeyedRows sorted = sort_rows(points, first_rows(rows), hilbert_key_of(points, rows, grid));
  VectorField kept("active_region", rows);
  int count = 0;
  Kokkos::parallel_scan(
      "thin_out", Range(0, rows),
      KOKKOS_LAMBDA(int k, int& sum, bool last) {
        const bool first = k == 0 || sorted(k).key != sorted(k - 1).key;
        if (last && first) {
          const CellIndex c = grid.index(load_vector(points, sorted(k).row));
          const Vector3 middle{Real(c.i) + Real(0.5), Real(c.j) + Real(0.5), Real(c.k) + Real(0.5)};
          store_vector(kept, sum, grid.origin + cell * middle);
        }
        sum += first ? 1 : 0;
      },
      count);
  Kokkos::resize(kept, count);
  return kept;
}

} // namespace

VectorField find_active_region(const Particles& p, const HexMesh& m, const ToolAt& at, const Freeze& freeze) {
  const ToolFrame frame = make_frame(at.pose);
  const Real speed2 = freeze.speed * freeze.speed;
  VectorField found("active_region", 0);
  int rows = append_points(p.position, p.stored,
                           Acts{at.tool, frame, freeze.near, speed2, p.position, p.velocity, p.constraints},
                           found, 0);
  rows = append_points(m.position, m.nodes,
                       Acts{at.tool, frame, freeze.near, speed2, m.position, m.velocity, m.constraints},
                       found, rows);
  return thin_out(found, rows, freeze.cell);
}

VectorField with_images(const VectorField& points, const std::vector<Transform>& maps) {
  const int own = int(points.extent(0));
  const VectorField all("active_region", own * (1 + int(maps.size())));
  Kokkos::deep_copy(Kokkos::subview(all, std::make_pair(0, own), Kokkos::ALL), points);
  for (int k = 0; k < int(maps.size()); ++k) {
    const int first = own * (k + 1);
    const Transform map = maps[std::size_t(k)];
    Kokkos::parallel_for(
        "with_images", Range(0, own),
        KOKKOS_LAMBDA(int i) { store_vector(all, first + i, apply(map, load_vector(points, i))); });
  }
  return all;
}

} // namespace swarf
