// Takes spent chip out of the computation, moves what has left, and marks what the tool or the work meets on
// its way: such a particle has left too early (retire.hpp). Reads position, velocity, identity, contact_gap;
// writes constraints, and the position of the retired.
#include "append_points.hpp"
#include "point_grid.hpp"
#include "swarf/tool/signed_distance.hpp"

namespace swarf {
namespace {

SWARF_FN bool has_moved(const Particles& p, int i, const Retire& r) {
  const Vector3 d = load_vector(p.position, i) - load_vector(r.first_position, p.identity(i));
  return dot(d, d) > r.distance * r.distance;
}

struct IsWork {
  Tool tool;
  ToolFrame frame;
  Particles particles;
  Retire retire;
  SWARF_FN bool operator()(int i) const {
    if (particles.constraints(i) & retired_bit) return false;
    return !has_moved(particles, i, retire) ||
           is_within(tool, to_tool(frame, load_vector(particles.position, i)), tool.reach);
  }
};

struct IsAny {
  SWARF_FN bool operator()(int) const { return true; }
};

} // namespace

VectorField find_work(const Particles& p, const HexMesh& m, const ToolAt& at, const Retire& r) {
  VectorField found("work", 0);
  int rows = append_points(p.position, p.stored, IsWork{at.tool, make_frame(at.pose), p, r}, found, 0);
  rows = append_points(m.position, m.nodes, IsAny{}, found, rows);
  Kokkos::resize(found, rows);
  return found;
}

void retire_particles(const Particles& p, const VectorField& work, const ToolAt& at, const Retire& r) {
  const bool any_work = work.extent(0) > 0; // else there is nothing to be far from
  const PointGrid grid = make_point_grid(work, r.distance / 4);
  const Tool tool = at.tool;
  const ToolFrame frame = make_frame(at.pose);
  Kokkos::parallel_for(
      "retire_particles", Range(0, p.stored), KOKKOS_LAMBDA(int i) {
        if (p.constraints(i) & retired_bit) {
          const Vector3 x = load_vector(p.position, i) + r.elapsed * load_vector(p.velocity, i);
          store_vector(p.position, i, x);
          if (is_within(tool, to_tool(frame, x), p.contact_gap(i)) || grid.any_within(x, r.reach))
            p.constraints(i) |= met_bit;
        } else if (any_work && p.identity(i) < p.whole && has_moved(p, i, r)) {
          if (!grid.any_within(load_vector(p.position, i), r.distance)) p.constraints(i) |= retired_bit;
        }
      });
}

} // namespace swarf
