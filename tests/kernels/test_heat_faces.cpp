// Heat through faces, against heat_through done by hand: a resistance in series with half a spacing of the
// work, and held nodes, which take their temperature and book what that needed.
#include "support/hex_block.hpp"
#include "support/materials.hpp"
#include "support/particle_block.hpp"
#include <gtest/gtest.h>

namespace swarf::test {
namespace {

constexpr double near = sizeof(Real) == 8 ? 1e-12 : 1e-4;

HeatedFaces faces_of(const std::vector<HeatedFace>& rows) {
  HeatedFaces faces("heated_faces", rows.size());
  const auto host = Kokkos::create_mirror_view(faces);
  for (std::size_t k = 0; k < rows.size(); ++k) host(k) = rows[k];
  Kokkos::deep_copy(faces, host);
  return faces;
}

HeatedNodes nodes_of(const std::vector<int>& rows, int face, Real area) {
  HeatedNodes nodes;
  nodes.count = int(rows.size());
  nodes.node = IndexField("node", rows.size()), nodes.face = IndexField("face", rows.size());
  nodes.start = IndexField("start", rows.size() + 1), nodes.area = ScalarField("area", rows.size());
  const auto node = Kokkos::create_mirror_view(nodes.node), start = Kokkos::create_mirror_view(nodes.start);
  for (int k = 0; k <= nodes.count; ++k) start(k) = k;
  for (int k = 0; k < nodes.count; ++k) node(k) = rows[std::size_t(k)];
  Kokkos::deep_copy(nodes.node, node), Kokkos::deep_copy(nodes.start, start);
  Kokkos::deep_copy(nodes.face, face), Kokkos::deep_copy(nodes.area, area);
  return nodes;
}

struct HotHexes {
  HexMesh mesh;
  MaterialTable materials;
};

HotHexes hot_hexes() {
  const Material mat = ti64();
  HotHexes b{make_hex_block({2, 1, 1}, mat,
                            [](int i, int j, int k) {
                              return Point{i * 1e-5, j * 1e-5, k * 1e-5};
                            }),
             make_material_table({mat})};
  HexMesh& m = b.mesh;
  m.nodal_temperature = ScalarField("nodal_temperature", m.nodes);
  m.nodal_heat = ScalarField("nodal_heat", m.nodes), m.face_heat = ScalarField("face_heat", m.nodes);
  m.heat_capacity = ScalarField("heat_capacity", m.nodes);
  Kokkos::deep_copy(m.nodal_temperature, Real(400)), Kokkos::deep_copy(m.heat_capacity, Real(2e-9));
  Kokkos::deep_copy(m.nodal_heat, Real(1e-8));
  return b;
}

} // namespace

TEST(HeatFaces, ParticlesOfAFaceLoseWhatAFilmTakes) {
  ParticleBlock b = particle_block(3, 3, 3, Real(1e-5));
  Particles& p = b.particles;
  const auto materials = host_copy(b.materials);
  materials(0).conductivity = 50;
  Kokkos::deep_copy(b.materials, materials);
  p.heated_faces = View<unsigned*>("heated_faces", p.count), p.face_heat = ScalarField("face_heat", p.count);
  const auto bits = host_copy(p.heated_faces);
  bits(0) = 1u, bits(1) = 3u; // the second is on both faces
  Kokkos::deep_copy(p.heated_faces, bits);
  Kokkos::deep_copy(p.points.temperature, Real(400));
  Kokkos::deep_copy(p.contact_gap, Real(5e-6)), Kokkos::deep_copy(p.contact_area, Real(1e-10));
  const Real dt = Real(1e-6);
  heat_faces(p, faces_of({{Real(1e-6), 300}, {0, 500}}), b.materials, dt);
  const double C = double(host_copy(p.points.mass)(0)) * 500;
  const double film = -100 * 1e-6 / ((1e-6 + 5e-6 / 50) / 1e-10 + 1e-6 / C),
               held = 100 * 1e-6 / ((5e-6 / 50) / 1e-10 + 1e-6 / C);
  const auto T = host_copy(p.points.temperature), heat = host_copy(p.face_heat);
  EXPECT_NEAR(double(heat(0)) / film, 1, near);
  EXPECT_NEAR(double(heat(1)) / (film + held), 1, near);
  EXPECT_NEAR((double(T(0)) - 400) * C / film, 1, 1e3 * near);
  EXPECT_EQ(T(2), Real(400));
  EXPECT_EQ(heat(2), Real(0));
}

TEST(HeatFaces, NodesTakeTheHeatOfAFilm) {
  const HotHexes b = hot_hexes();
  heat_nodes(b.mesh, nodes_of({0, 4}, 0, Real(2.5e-11)), faces_of({{Real(1e-6), 300}}), b.materials,
             Real(1e-6));
  const double heat = -100 * 1e-6 / (1e-6 / 2.5e-11 + 1e-6 / 2e-9);
  EXPECT_NEAR(double(host_copy(b.mesh.nodal_heat)(4)), 1e-8 + heat, std::abs(heat) * near);
  EXPECT_NEAR(double(host_copy(b.mesh.face_heat)(4)) / heat, 1, near);
  EXPECT_EQ(host_copy(b.mesh.nodal_heat)(1), Real(1e-8));
}

TEST(HeatFaces, HeldNodesEndAtTheirTemperatureAndBookIt) {
  const HotHexes b = hot_hexes();
  hold_temperatures(b.mesh, nodes_of({0, 4}, 0, Real(2.5e-11)), faces_of({{0, 300}}), b.materials);
  EXPECT_NEAR(double(host_copy(b.mesh.nodal_heat)(0)), -100 * 2e-9, 2e-7 * near);
  EXPECT_NEAR(double(host_copy(b.mesh.face_heat)(0)), -100 * 2e-9 - 1e-8, 2e-7 * near);
  EXPECT_EQ(host_copy(b.mesh.face_heat)(1), Real(0));
}

TEST(HeatFaces, NodesOfFrozenHexesGetNothing) {
  const HotHexes b = hot_hexes();
  Kokkos::deep_copy(b.mesh.active, int(hex_frozen));
  const HeatedNodes nodes = nodes_of({0, 4}, 0, Real(2.5e-11));
  heat_nodes(b.mesh, nodes, faces_of({{Real(1e-6), 300}}), b.materials, Real(1e-6));
  hold_temperatures(b.mesh, nodes, faces_of({{0, 300}}), b.materials);
  EXPECT_EQ(host_copy(b.mesh.nodal_heat)(0), Real(1e-8));
  EXPECT_EQ(host_copy(b.mesh.face_heat)(0), Real(0));
}

} // namespace swarf::test
