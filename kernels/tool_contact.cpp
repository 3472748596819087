// f = k (gap - d) n + f_t for every point nearer to the tool's surface than its gap; respond_to_contact gives
// f_t and the energies. k: of the material between a particle and its surface, M area / gap, M = rho c^2, as
// far as the step allows it (contact_stiffness); without it the layer under a sphere is 9 % too stiff at four
// particles to the radius of contact, for that material is in no pair of particles. The slip is measured
// against the moving surface at the point itself, so that a point that moves with the tool does not slip. No
// friction is more than the shear that the material at the point carries. Friction heat: a share of it heats
// the point, dT = share W / (m c), m without mass scaling; where the tool conducts it divides by itself
// (heat_into_tool). What it does to the tool's surface is summed over the time (tool_surface.hpp). Reads
// position, velocity (half a step back), mass, gap, area, material; writes contact_force, friction_force,
// contact_energy, tool_cell, tool_patch; adds to force, friction_work, temperature or heat, heat_to_tool,
// on_tool.
#include "swarf/kernels.hpp"
#include "swarf/material/flow_law.hpp"
#include "swarf/material/heat.hpp"
#include "swarf/tool/signed_distance.hpp"

namespace swarf {
namespace {

SWARF_FN bool rests(const Vector3& f) { return f.x == 0 && f.y == 0 && f.z == 0; }

SWARF_FN void store_contact(const ContactPoints& points, int i, const ContactResponse& response) {
  store_vector(points.contact_force, i, response.force);
  store_vector(points.friction_force, i, response.friction_force);
  points.contact_energy(i) = response.energy;
}

// N/m, M area / gap of a cube, whose area is V / (2 gap); of a node, which lies on the surface itself,
// without bound.
SWARF_FN Real stiffness_of_half_particle(const ContactPoints& points, int i, const Material& mat) {
  const Real c = longitudinal_wave_speed(mat), gap = points.gap(i);
  return points.mass(i) * c * c / (Real(2) * gap * gap);
}

// A thousandth of a cell below the surface: on the surface itself round-off would choose between cells.
SWARF_FN int cell_below(const ToolHeat& heat, const ToolDistance& at) {
  return find_tool_cell(heat, at.point - (Real(1e-3) * heat.finest) * at.normal);
}

// Half a particle of the work, the interface, and the tool down to the middle of its cell; a node lies on the
// surface itself.
SWARF_FN HeatContact heat_contact(const ContactPoints& points, int i, const ToolHeat& heat,
                                  const ContactLaw& law, const Material& mat) {
  const bool is_node = points.heat.extent(0) > 0;
  const Real area = points.area(i), half_interface = Real(0.5) * law.heat_resistance;
  const int cell = points.tool_cell(i);
  HeatContact at;
  const Real T = points.temperature(i);
  at.work_capacity = (is_node ? points.heat_capacity(i) : heat_capacity(mat, points.mass(i))) *
                     (specific_heat_at(mat, T) / mat.specific_heat);
  at.work_temperature = T + (is_node ? points.heat(i) / at.work_capacity : Real(0));
  at.tool_temperature = heat.temperature(cell);
  at.work_resistance =
      (half_interface + (is_node ? Real(0) : points.gap(i) / conductivity_at(mat, T))) / area;
  at.tool_resistance = (half_interface + heat.depth(cell) / heat.conductivity) / area;
  return at;
}

struct HeatPath {
  const ToolHeat& heat;
  const ContactLaw& law;
  const Material& mat;
};
struct MadeHeat {
  Real made, dt; // J, by friction in this step; s, of contact
};

// To the point and to the tool. A point that has just parted leaves the work of its spring where it touched
// last, in no time. Returns the temperature of the tool's side of the interface; 0 where it does not conduct.
SWARF_FN Real give_heat(const ContactPoints& points, int i, const HeatPath& path, const MadeHeat& friction) {
  const ToolHeat& heat = path.heat;
  const bool is_node = points.heat.extent(0) > 0;
  Real to_work = path.law.heat_to_workpiece * friction.made, temperature = 0;
  if (heat.cells > 0) {
    const Real to_tool =
        heat_into_tool(heat_contact(points, i, heat, path.law, path.mat), friction.made, friction.dt);
    const int cell = points.tool_cell(i);
    if (friction.dt > Real(0))
      temperature = heat.temperature(cell) +
                    to_tool / friction.dt * heat.depth(cell) / (heat.conductivity * points.area(i));
    points.heat_to_tool(i) += to_tool;
    to_work = friction.made - to_tool;
  }
  if (is_node)
    points.heat(i) += to_work;
  else
    points.temperature(i) = warmed_by(path.mat, points.mass(i), points.temperature(i), to_work);
  return temperature;
}

SWARF_FN int patch_at(const Tool& tool, const ToolDistance& at) {
  const Triangle t = load_facet(tool, at.facet);
  return find_patch(tool.surface, at.facet, barycentric(t.a, t.b, t.c, at.point));
}

struct Rubbing {                              // of one point in one step
  Real force, speed, dissipated, temperature; // N, normal; m/s; J; K of the tool's side, 0: it has none
};

SWARF_FN void add_to_surface(const ContactPoints& points, int i, const ToolSurface& s, const Rubbing& r,
                             Real dt) {
  const Real impulse = dt * r.force;
  points.on_tool(i, sum_impulse) += impulse;
  points.on_tool(i, sum_slide) += impulse * r.speed;
  points.on_tool(i, sum_friction) += r.dissipated;
  points.on_tool(i, sum_temperature) += impulse * r.temperature;
  points.on_tool(i, sum_wear) += impulse * r.speed * wear_factor(s, r.temperature);
}

} // namespace

void tool_contact(const ContactPoints& points, const Tool& tool, const ToolPose& pose, const ContactLaw& law,
                  const MaterialTable& materials, Real mass_factor, Real dt) {
  const ToolFrame frame = make_frame(pose);
  const bool flows = points.plastic_strain.extent(0) > 0, conducts = tool.heat.cells > 0;
  const bool knows_material = points.material.extent(0) > 0; // nodes do where there are tables
  const bool is_node = points.heat.extent(0) > 0, heats = is_node || points.temperature.extent(0) > 0;
  const bool shows = tool.surface.patches > 0 && points.on_tool.extent(0) > 0;
  Kokkos::parallel_for(
      "tool_contact", UnevenRange(0, points.count), KOKKOS_LAMBDA(const int i) {
        if (points.area(i) == 0) return;
        const Vector3 x = load_vector(points.position, i);
        const Vector3 on_tool = to_tool(frame, x);
        const ToolDistance at =
            is_beyond(tool, on_tool, points.gap(i)) ? ToolDistance{} : signed_distance(tool, on_tool);
        const bool touches = at.where == ToolDistance::Where::near && at.distance < points.gap(i);
        const Vector3 friction_force = load_vector(points.friction_force, i);
        if (!touches && rests(friction_force)) return store_contact(points, i, ContactResponse{});

        ContactStep step;
        step.penetration = touches ? points.gap(i) - at.distance : Real(0);
        step.normal = direction_to_world(frame, at.normal);
        step.slip = dt * (load_vector(points.velocity, i) - surface_velocity(pose, x));
        step.friction_force = friction_force;
        if (flows)
          step.shear_strength = shear_strength(materials(points.material(i)), points.plastic_strain(i),
                                               points.plastic_strain_rate(i), points.temperature(i));
        Real stiffness = contact_stiffness(law, mass_factor * points.mass(i), dt);
        if (knows_material)
          stiffness =
              Kokkos::min(stiffness, stiffness_of_half_particle(points, i, materials(points.material(i))));
        const ContactResponse response = respond_to_contact(step, law, stiffness, points.area(i));

        store_contact(points, i, response);
        store_vector(points.force, i, load_vector(points.force, i) + response.force);
        points.friction_work(i) += response.dissipated;
        Rubbing rubbing{0, 0, response.dissipated, 0};
        if (shows && touches) {
          points.tool_patch(i) = patch_at(tool, at);
          rubbing.force = dot(response.force, step.normal);
          rubbing.speed = norm(step.slip - dot(step.slip, step.normal) * step.normal) / dt;
        }
        if (heats) {
          if (touches && conducts) points.tool_cell(i) = cell_below(tool.heat, at);
          const Material& mat = materials(knows_material ? points.material(i) : 0); // a node's: for tables
          rubbing.temperature =
              give_heat(points, i, {tool.heat, law, mat}, {response.dissipated, touches ? dt : Real(0)});
        }
        if (shows) add_to_surface(points, i, tool.surface, rubbing, dt);
      });
}

} // namespace swarf
