#include "src/output/frame.hpp"
#include "src/scene/scene.hpp"
#include "swarf/kernels.hpp"
#include "swarf/region/retire.hpp"

#include <cmath>
#include <numeric>

namespace swarf {
namespace {

using Rows = std::vector<int>;

Rows all_rows(int count) {
  Rows rows(std::size_t(count), 0);
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

template <class To, class Field>
std::vector<To> copy_rows(const Field& field, const Rows& rows) {
  constexpr int columns = Field::rank == 1 ? 1 : int(Field::static_extent(1));
  if (rows.empty() || field.extent(0) < rows.size()) return {};
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, field);
  std::vector<To> out;
  out.reserve(rows.size() * columns);
  for (int i : rows) {
    if constexpr (Field::rank == 1)
      out.push_back(To(host(i)));
    else
      for (int c = 0; c < columns; ++c) out.push_back(To(host(i, c)));
  }
  return out;
}

PointFields copy_state(const MaterialPoints& points, const ScalarField& volume, const Rows& rows) {
  PointFields out;
  out.temperature = copy_rows<float>(points.temperature, rows);
  out.equivalent_plastic_strain = copy_rows<float>(points.equivalent_plastic_strain, rows);
  out.plastic_strain_rate = copy_rows<float>(points.plastic_strain_rate, rows);
  out.damage = copy_rows<float>(points.damage, rows);
  out.volume = copy_rows<float>(volume, rows);
  out.material = copy_rows<int>(points.material, rows);
  const auto stress = copy_rows<Real>(points.stress, rows);
  out.stress.assign(stress.begin(), stress.end());
  for (std::size_t i = 0; i + 6 <= stress.size(); i += 6) {
    const Symmetric3 s{stress[i], stress[i + 1], stress[i + 2], stress[i + 3], stress[i + 4], stress[i + 5]};
    out.von_mises.push_back(float(von_mises(s)));
    out.pressure.push_back(float(-trace(s) / 3));
  }
  return out;
}

// Turned about its own z axis, then moved.
std::vector<float> place_tool(const Tool& tool, const ToolPose& pose) {
  std::vector<float> out;
  const double c = std::cos(double(pose.angle)), s = std::sin(double(pose.angle));
  const bool has_patches = tool.surface.patches > 0;
  const auto vertex = host_copy(has_patches ? tool.surface.corner : tool.vertex);
  for (int f = 0; f < (has_patches ? tool.surface.patches : tool.facets); ++f)
    for (int k = 0; k < 3; ++k) {
      const double x = vertex(f, k, 0), y = vertex(f, k, 1);
      out.push_back(float(c * x - s * y + pose.position.x));
      out.push_back(float(s * x + c * y + pose.position.y));
      out.push_back(float(vertex(f, k, 2) + pose.position.z));
    }
  return out;
}

} // namespace

ToolFields copy_tool_fields(const Tool& tool, double duration) {
  const auto shown = host_copy(show_tool_surface(tool, Real(duration)));
  const auto column = [&](ShownOnTool which, bool is_known) {
    std::vector<float> out;
    for (std::size_t p = 0; is_known && p < shown.extent(0); ++p) out.push_back(float(shown(p, which)));
    return out;
  };
  return {column(shown_temperature, tool.heat.cells > 0), column(shown_pressure, true),
          column(shown_speed, true), column(shown_friction, true),
          column(shown_wear, tool.surface.wear_A > 0)};
}

FrameData copy_frame(const Particles& particles, const HexMesh& hexes, const Tool& tool,
                     const ToolPose& pose) {
  FrameData frame;
  const Rows rows = particle_rows(particles), nodes = all_rows(hexes.nodes),
             cells = all_rows(hexes.points.count);
  frame.particles.position = copy_rows<float>(particles.position, rows);
  frame.particles.velocity = copy_rows<float>(particles.velocity, rows);
  frame.particles.contact_force = copy_rows<float>(particles.contact_force, rows);
  frame.particles.body = copy_rows<int>(particles.body, rows);
  frame.particles.identity = copy_rows<int>(particles.identity, rows);
  for (const int bits : copy_rows<int>(particles.constraints, rows))
    frame.particles.retired.push_back((bits & retired_bit ? 1 : 0) + (bits & met_bit ? 1 : 0));
  frame.particles.state = copy_state(particles.points, particles.volume, rows);
  frame.hexes.position = copy_rows<float>(hexes.position, nodes);
  frame.hexes.velocity = copy_rows<float>(hexes.velocity, nodes);
  frame.hexes.connectivity = copy_rows<int>(hexes.connectivity, cells);
  frame.hexes.active = copy_rows<int>(hexes.active, cells);
  frame.hexes.state = copy_state(hexes.points, hexes.volume, cells);
  frame.tool = place_tool(tool, pose);
  return frame;
}

} // namespace swarf
