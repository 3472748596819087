// Contact of bodies: the law of the tool (respond_to_contact) between points and what they touch.
//   points:  four of each face of a hex, sum_a N_a x_a of its nodes; particles, whose surface lies a gap out
//   others:  faces, x = sum_b w_b x_b of four nodes
//   f on the point, -w_b f on the face's nodes, sum w_b = 1: momentum to round-off; the slip and the rate of
//   the gap are those of the same weights, so that the springs keep the work that is done on them.
// Both bodies are points and faces at once, as of two nets neither need be the finer (balanced contact).
// k dt^2 is a share of the least mass behind the area of the contact: 1/4 between faces, where each pair of
// nodes is met twice with 2 k each in Gershgorin's sum, 1/2 of a particle on a face, so that no mode is
// stiffer than 1 / dt^2, as at the tool; a particle's spring is no more than that of the material out to its
// surface. No friction is more than the shear that the material on either side carries. Its heat goes to both
// sides by halves. The first launch writes touch and friction, the others gather what each node and each
// particle feels. Reads positions, velocities (half a step back), lists; adds to force, friction_work,
// contact_heat or temperature; writes body_contact_energy.
#include "swarf/hexes/face_point.hpp"
#include "swarf/kernels.hpp"
#include "swarf/material/flow_law.hpp"
#include "swarf/material/heat.hpp"
#include "swarf/tool/contact_law.hpp"

namespace swarf {
namespace {

constexpr Real facing = Real(-0.2);       // cosine between the normals of faces that can press each other
constexpr Real beyond_edge = Real(0.025); // of a face's width, that it is taken to be wider

struct Point {
  Vector3 x, v, normal; // normal 0 of a particle: it has no side
  Real gap, area, mass; // m; m2; kg behind the area
  Real shear_strength;  // Pa
  Real stiffest;        // N/m, of the material out to its surface
};

struct FaceNow {
  Vector3 corner[4];
  Real area, mass_per_area, shear_strength;
};

struct Found {
  int other = -1; // face
  FacePoint at{};
  Real penetration = 0;
  Vector3 normal{0, 0, 0};
};

struct Press {
  BodyContact c;
  HexMesh h;
  Particles p;
  ContactLaw law;
  MaterialTable materials;
  Real mass_factor, dt;

  SWARF_FN Real shear_at(const MaterialPoints& points, int i) const {
    return shear_strength(materials(points.material(i)), points.equivalent_plastic_strain(i),
                          points.plastic_strain_rate(i), points.temperature(i));
  }

  // A face has the mass of half of its hex behind it.
  SWARF_FN FaceNow face(int f) const {
    FaceNow now;
    const int e = c.key(f) / 6;
    for (int a = 0; a < 4; ++a) now.corner[a] = load_vector(h.position, c.node(f, a));
    now.area = area_of_face(now.corner);
    now.mass_per_area = Real(0.5) * h.points.density(e) * h.volume(e) / now.area;
    now.shear_strength = shear_at(h.points, e);
    return now;
  }

  SWARF_FN Point point_of_face(int f, int q) const {
    const FaceNow now = face(f);
    Point at{{0, 0, 0},
             {0, 0, 0},
             {0, 0, 0},
             0,
             Real(0.25) * now.area,
             0,
             now.shear_strength,
             Kokkos::Experimental::infinity_v<Real>};
    at.mass = at.area * now.mass_per_area;
    for (int a = 0; a < 4; ++a) {
      const Real N_a = weight_of_corner(q, a);
      at.x = at.x + N_a * now.corner[a], at.v = at.v + N_a * load_vector(h.velocity, c.node(f, a));
    }
    const Vector3 n = cross(now.corner[2] - now.corner[0], now.corner[3] - now.corner[1]);
    at.normal = (Real(1) / norm(n)) * n;
    return at;
  }

  SWARF_FN Point point_of_particle(int i) const {
    const Real wave = longitudinal_wave_speed(materials(p.points.material(i))), gap = p.contact_gap(i);
    const Real mass = p.points.mass(i);
    return {load_vector(p.position, i),
            load_vector(p.velocity, i),
            {0, 0, 0},
            gap,
            p.contact_area(i),
            mass,
            shear_at(p.points, i),
            mass * wave * wave / (Real(2) * gap * gap)};
  }

  // The nearest face that the point is before, or in by no more than half a cell.
  SWARF_FN Found nearest_face(int item, const Point& point) const {
    Found best;
    Real least = Kokkos::Experimental::infinity_v<Real>;
    for (int k = c.start(item); k < c.start(item + 1); ++k) {
      const int f = c.other(k);
      if (f >= c.faces || h.active(c.key(f) / 6) == hex_deleted) continue;
      const FaceNow now = face(f);
      const FacePoint at = nearest_on_face(now.corner, point.x);
      const bool sided = dot(point.normal, point.normal) > Real(0);
      if (at.squared >= least || (sided && dot(at.normal, point.normal) > facing)) continue;
      const Vector3 d = point.x - at.point;
      const Real height = dot(d, at.normal), width = Kokkos::sqrt(now.area);
      const bool over = norm(d - height * at.normal) <= beyond_edge * width;
      if (!over && height < Real(0)) continue;
      const Real distance = over ? height : Kokkos::sqrt(at.squared);
      if (distance >= point.gap || distance < Real(-0.5) * width) continue;
      least = at.squared;
      best = {f, at, point.gap - distance, over ? at.normal : (Real(1) / distance) * d};
    }
    return best;
  }

  SWARF_FN void respond(int item, int q, const Point& point, const Found& found, Touch& touch) const;
  SWARF_FN void press_point(int item, int q) const;
  SWARF_FN void gather_node(int a) const;
  SWARF_FN void gather_particle(int item) const;
};

SWARF_FN void Press::respond(int item, int q, const Point& point, const Found& found, Touch& touch) const {
  const bool is_face = item < c.faces, touches = found.other >= 0;
  const Vector3 memory = is_face
                             ? Vector3{c.friction(item, q, 0), c.friction(item, q, 1), c.friction(item, q, 2)}
                             : load_vector(p.body_friction, c.row(item - c.faces));
  if (!touches && memory.x == 0 && memory.y == 0 && memory.z == 0) return;
  ContactStep step{
      touches ? found.penetration : Real(0), found.normal, {0, 0, 0}, memory, point.shear_strength};
  Real area = point.area, per_area = point.mass / point.area;
  if (touches) {
    const FaceNow now = face(found.other);
    Vector3 v{0, 0, 0};
    for (int b = 0; b < 4; ++b) {
      touch.weight[b] = found.at.weight[b];
      v = v + touch.weight[b] * load_vector(h.velocity, c.node(found.other, b));
    }
    area = Kokkos::min(area, now.area), per_area = Kokkos::min(per_area, now.mass_per_area);
    step.shear_strength = Kokkos::min(step.shear_strength, now.shear_strength);
    step.slip = dt * (point.v - v);
  }
  const Real share = is_face ? Real(0.25) : Real(0.5); // a particle has no face that finds the other, too
  const Real stiffness =
      Kokkos::min(contact_stiffness(law, share * mass_factor * area * per_area, dt), point.stiffest);
  const ContactResponse response = respond_to_contact(step, law, stiffness, point.area);
  touch.other = found.other, touch.normal = found.normal, touch.force = response.force;
  touch.energy = response.energy, touch.dissipated = response.dissipated;
  const Vector3 f = response.friction_force;
  if (is_face)
    c.friction(item, q, 0) = f.x, c.friction(item, q, 1) = f.y, c.friction(item, q, 2) = f.z;
  else
    store_vector(p.body_friction, c.row(item - c.faces), f);
}

SWARF_FN void Press::press_point(int item, int q) const {
  const bool is_face = item < c.faces;
  Touch touch;
  if (!is_face || h.active(c.key(item) / 6) != hex_deleted) {
    const Point point = is_face ? point_of_face(item, q) : point_of_particle(c.row(item - c.faces));
    respond(item, q, point, nearest_face(item, point), touch);
  }
  c.touch(item, q) = touch;
}

// Heat: all of it stays with the point where nothing is touched any more.
SWARF_FN Real heat_of_point(const Touch& t) { return t.other < 0 ? t.dissipated : Real(0.5) * t.dissipated; }
SWARF_FN Real heat_of_other(const Touch& t) { return Real(0.5) * t.dissipated; }

SWARF_FN void Press::gather_node(int a) const {
  Vector3 f{0, 0, 0};
  Real energy = 0, work = 0, heat = 0;
  for (int k = c.corner_start(a); k < c.corner_start(a + 1); ++k) {
    const int face = c.corner(k) / points_of_face, corner = c.corner(k) % points_of_face;
    for (int q = 0; q < points_of_face; ++q) {
      const Touch& t = c.touch(face, q);
      const Real N_a = weight_of_corner(q, corner);
      f = f + N_a * t.force;
      energy += N_a * t.energy, work += N_a * t.dissipated, heat += N_a * heat_of_point(t);
    }
    for (int j = c.start(face); j < c.start(face + 1); ++j)
      for (int q = 0; q < (c.other(j) < c.faces ? points_of_face : 1); ++q) {
        const Touch& t = c.touch(c.other(j), q);
        if (t.other != face) continue;
        f = f - t.weight[corner] * t.force;
        heat += t.weight[corner] * heat_of_other(t);
      }
  }
  h.body_contact_energy(a) = energy;
  h.friction_work(a) += work;
  h.contact_heat(a) += heat;
  if (!(h.constraints(a) & held_bit)) store_vector(h.force, a, load_vector(h.force, a) + f);
}

SWARF_FN void Press::gather_particle(int item) const {
  const int i = c.row(item - c.faces);
  const Touch& t = c.touch(item, 0);
  p.body_contact_energy(i) = t.energy;
  p.friction_work(i) += t.dissipated;
  store_vector(p.force, i, load_vector(p.force, i) + t.force);
  const Real heat = heat_of_point(t);
  if (heat != Real(0))
    p.points.temperature(i) =
        warmed_by(materials(p.points.material(i)), p.points.mass(i), p.points.temperature(i), heat);
}

} // namespace

void press_bodies(const BodyContact& c, const HexMesh& h, const Particles& p, const PressStep& step) {
  if (c.items == 0) return;
  const Press press{c, h, p, step.law, step.materials, step.mass_factor, step.dt};
  Kokkos::parallel_for(
      "press_bodies", UnevenRange(0, c.items), KOKKOS_LAMBDA(int item) {
        for (int q = 0; q < (item < press.c.faces ? points_of_face : 1); ++q) press.press_point(item, q);
      });
  Kokkos::parallel_for(
      "press_bodies_nodes", Range(0, h.nodes), KOKKOS_LAMBDA(int a) {
        if (press.c.corner_start(a) < press.c.corner_start(a + 1)) press.gather_node(a);
      });
  Kokkos::parallel_for(
      "press_bodies_particles", Range(c.faces, c.items),
      KOKKOS_LAMBDA(int item) { press.gather_particle(item); });
}

} // namespace swarf
