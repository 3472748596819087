// Heat through heated faces of bodies, q = (T_face - T) / (R_film + R_own) (face_heat.hpp): of a particle of
// the first layer R_own is half a spacing over the conductivity of the work, as in tool_contact.cpp; a node
// lies on the face itself. Where the face is held (no film) a node takes its temperature, whatever that
// needs. Reads temperature, mass, contact_gap, contact_area, heated_faces; writes temperature or nodal_heat;
// adds to face_heat. Nodes whose hexes are all frozen or are gone conduct nothing, and get nothing.
#include "swarf/kernels.hpp"
#include "swarf/material/heat.hpp"

namespace swarf {
namespace {

SWARF_FN bool is_active(const HexMesh& m, int a) {
  for (int k = m.corner_start(a); k < m.corner_start(a + 1); ++k)
    if (m.active(m.corner_of_node(k) / 8) == hex_active) return true;
  return false;
}

SWARF_FN Real capacity_at(const HexMesh& m, const MaterialTable& materials, int a, Real T) {
  if (m.node_material.extent(0) == 0) return m.heat_capacity(a);
  const Material& mat = materials(m.node_material(a));
  return m.heat_capacity(a) / mat.specific_heat * specific_heat_at(mat, T);
}

} // namespace

void heat_faces(const Particles& p, const HeatedFaces& faces, const MaterialTable& materials, Real dt) {
  if (p.heated_faces.extent(0) == 0) return;
  const MaterialPoints points = p.points;
  Kokkos::parallel_for(
      "heat_faces", Range(0, p.count), KOKKOS_LAMBDA(const int i) {
        const Material& mat = materials(points.material(i));
        const Real T = points.temperature(i), capacity = points.mass(i) * specific_heat_at(mat, T);
        const Real own = p.contact_gap(i) / conductivity_at(mat, T);
        Real heat = 0;
        for (unsigned bits = p.heated_faces(i), b = 0; bits != 0; bits >>= 1, ++b)
          if (bits & 1u) heat += heat_through(faces(b), own, p.contact_area(i), T, capacity, dt);
        if (heat == 0) return;
        points.temperature(i) = warmed_by(mat, points.mass(i), T, heat);
        p.face_heat(i) += heat;
      });
}

void heat_nodes(const HexMesh& m, const HeatedNodes& nodes, const HeatedFaces& faces,
                const MaterialTable& materials, Real dt) {
  Kokkos::parallel_for(
      "heat_nodes", Range(0, nodes.count), KOKKOS_LAMBDA(const int n) {
        const int a = nodes.node(n);
        if (!is_active(m, a)) return;
        const Real T = m.nodal_temperature(a), capacity = capacity_at(m, materials, a, T);
        Real heat = 0;
        for (int k = nodes.start(n); k < nodes.start(n + 1); ++k)
          if (const HeatedFace& face = faces(nodes.face(k)); face.resistance > Real(0))
            heat += heat_through(face, 0, nodes.area(k), T, capacity, dt);
        m.nodal_heat(a) += heat;
        m.face_heat(a) += heat;
      });
}

void hold_temperatures(const HexMesh& m, const HeatedNodes& nodes, const HeatedFaces& faces,
                       const MaterialTable& materials) {
  Kokkos::parallel_for(
      "hold_temperatures", Range(0, nodes.count), KOKKOS_LAMBDA(const int n) {
        const int a = nodes.node(n);
        if (!is_active(m, a)) return;
        for (int k = nodes.start(n); k < nodes.start(n + 1); ++k) {
          const HeatedFace& face = faces(nodes.face(k));
          if (face.resistance > Real(0)) continue;
          const Real heat = node_heat_between(m, materials, a, m.nodal_temperature(a), face.temperature);
          m.face_heat(a) += heat - m.nodal_heat(a);
          m.nodal_heat(a) = heat;
          return; // where two meet, the first in the deck
        }
      });
}

} // namespace swarf
