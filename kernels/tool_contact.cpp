// f = k (gap - d) n + f_t for every point nearer to the tool's surface than its gap; respond_to_contact gives
// f_t and the energies. The slip is measured against the moving surface at the point itself, so that a point
// that moves with the tool does not slip. No friction is more than the shear that the material at the point
// carries. Friction heat: dT = share W / (m c), m without mass scaling. Reads position, velocity (half a step
// back), mass, gap, area, material; writes contact_force, friction_force, contact_energy; adds to force,
// friction_work, temperature.
#include "swarf/johnson_cook.hpp"
#include "swarf/kernels.hpp"
#include "swarf/signed_distance.hpp"

namespace swarf {
namespace {

SWARF_FN bool rests(const Vector3& f) { return f.x == 0 && f.y == 0 && f.z == 0; }

SWARF_FN void store_contact(const ContactPoints& points, int i, const ContactResponse& response) {
  store_vector(points.contact_force, i, response.force);
  store_vector(points.friction_force, i, response.friction_force);
  points.contact_energy(i) = response.energy;
}

} // namespace

void tool_contact(const ContactPoints& points, const Tool& tool, const ToolPose& pose, const ContactLaw& law,
                  const MaterialTable& materials, Real mass_factor, Real dt) {
  const ToolFrame frame = make_frame(pose);
  const bool heats = points.temperature.extent(0) > 0, flows = points.plastic_strain.extent(0) > 0;
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
        const Real stiffness = contact_stiffness(law, mass_factor * points.mass(i), dt);
        const ContactResponse response = respond_to_contact(step, law, stiffness, points.area(i));

        store_contact(points, i, response);
        store_vector(points.force, i, load_vector(points.force, i) + response.force);
        points.friction_work(i) += response.dissipated;
        if (heats)
          points.temperature(i) += law.heat_to_workpiece * response.dissipated /
                                   (points.mass(i) * materials(points.material(i)).specific_heat);
      });
}

} // namespace swarf
