// Where the action is: points that the tool comes near to, and points that move faster than sleep.speed, one
// for each cell of a grid that holds any. Periodic images of them count as well. Reads positions and
// velocities of all stored particles and of the nodes.
#include "cell_order.hpp"
#include "swarf/signed_distance.hpp"

namespace swarf {
namespace {

struct Watch {
  Tool tool;
  ToolFrame frame;
  Real speed2;
};

SWARF_FN bool acts(const Watch& w, const Vector3& x, const Vector3& v) {
  if (dot(v, v) > w.speed2) return true;
  if (w.tool.facets == 0) return false;
  return signed_distance(w.tool, to_tool(w.frame, x)).where != ToolDistance::Where::outside;
}

// Appends to found the points among rows [0, rows); returns how many there are then.
int append_action(const VectorField& position, const VectorField& velocity, int rows, const Watch& w,
                  VectorField& found, int first) {
  const IndexField place("find_action_place", rows);
  int more = 0;
  Kokkos::parallel_scan(
      "find_action", Range(0, rows),
      KOKKOS_LAMBDA(int i, int& sum, bool last) {
        if (!last) place(i) = acts(w, load_vector(position, i), load_vector(velocity, i)) ? 1 : 0;
        const int own = place(i);
        if (last) place(i) = own ? sum : -1;
        sum += own;
      },
      more);
  ensure_rows(found, first + more);
  const VectorField to = found;
  Kokkos::parallel_for(
      "find_action", Range(0, rows), KOKKOS_LAMBDA(int i) {
        if (place(i) >= 0) store_vector(to, first + place(i), load_vector(position, i));
      });
  return first + more;
}

struct CellOf {
  CellGrid grid;
  SWARF_FN CellKey operator()(const Vector3& x) const { return row_key(grid.index(x)); }
};

// The first point of each cell.
VectorField thin_out(const VectorField& points, int rows, Real cell) {
  const KeyedRows sorted = sort_rows(points, first_rows(rows), CellOf{cell_grid(points, rows, cell)});
  VectorField kept("action", rows);
  int count = 0;
  Kokkos::parallel_scan(
      "thin_out", Range(0, rows),
      KOKKOS_LAMBDA(int k, int& sum, bool last) {
        const bool first = k == 0 || sorted(k).key != sorted(k - 1).key;
        if (last && first) store_vector(kept, sum, load_vector(points, sorted(k).row));
        sum += first ? 1 : 0;
      },
      count);
  Kokkos::resize(kept, count);
  return kept;
}

VectorField with_images(const VectorField& points, const ImagePlanes& planes) {
  const int own = int(points.extent(0));
  VectorField all = points;
  for (const ImagePlane& plane : planes) {
    if (!plane.active) continue;
    const int first = int(all.extent(0));
    ensure_rows(all, std::size_t(first + own));
    const VectorField to = all;
    const Transform map = plane.to_image;
    Kokkos::parallel_for(
        "find_action", Range(0, own),
        KOKKOS_LAMBDA(int i) { store_vector(to, first + i, apply(map, load_vector(points, i))); });
  }
  return all;
}

} // namespace

VectorField find_action(const Particles& p, const HexMesh& m, const Tool& tool, const ToolPose& pose,
                        const ImagePlanes& planes, const Sleep& sleep) {
  const Watch watch{tool, make_frame(pose), sleep.speed * sleep.speed};
  VectorField found("action", 0);
  int rows = append_action(p.position, p.velocity, p.stored, watch, found, 0);
  rows = append_action(m.position, m.velocity, m.nodes, watch, found, rows);
  return with_images(thin_out(found, rows, sleep.cell), planes);
}

} // namespace swarf
