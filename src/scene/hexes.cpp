#include "src/geometry/upload.hpp"
#include "src/scene/parts.hpp"
#include "swarf/hexes/hex8.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace swarf {
namespace {

struct Node {
  const FilledBody* body;
  Point position;
};
struct Hex {
  const FilledBody* body;
  std::array<int, 8> node;
  double volume;
};

double volume_of(const FilledBody& body, const std::array<int, 8>& hex) {
  HexVectors x;
  for (int a = 0; a < 8; ++a) x.at[a] = to_vector3(Point(body.hexes.node[hex[a]] - body.hexes.node[hex[0]]));
  return double(mean_gradient(x).volume);
}

std::vector<Hex> list_hexes(const Deck& deck, const std::vector<FilledBody>& bodies) {
  std::vector<Hex> hexes;
  for (const FilledBody& b : bodies)
    for (const auto& corners : b.hexes.hex) {
      Hex hex{&b, corners, volume_of(b, corners)};
      if (!(hex.volume > 0)) {
        const Point& x = b.hexes.node[corners[0]];
        reject(
            deck, *b.deck, b.deck->cells ? "cells" : "spacing",
            fmt::format(
                "has an inverted hex at ({:.6g}, {:.6g}, {:.6g}) m: expected a positive volume. Change the "
                "number of cells",
                x.x(), x.y(), x.z()));
      }
      for (int& node : hex.node) node += b.first;
      hexes.push_back(hex);
    }
  return hexes;
}

} // namespace

std::vector<FreeQuad> list_free_quads(const std::vector<FilledBody>& bodies) {
  std::vector<FreeQuad> free;
  for (const FilledBody& b : bodies) {
    if (b.has_particles()) continue;
    std::vector<std::vector<bool>> inner_faces;
    for (const FaceDeck& face : b.deck->faces) {
      const auto at = b.hexes.faces.find(face.face);
      if ((face.kind != FaceKind::periodic && face.kind != FaceKind::symmetric) || at == b.hexes.faces.end())
        continue;
      inner_faces.emplace_back(b.hexes.node.size(), false);
      for (int node : at->second) inner_faces.back()[std::size_t(node)] = true;
    }
    for (const SurfaceQuad& quad : find_surface(b.hexes)) {
      const bool inner = std::any_of(inner_faces.begin(), inner_faces.end(), [&](const auto& on_face) {
        return std::all_of(quad.node.begin(), quad.node.end(),
                           [&](int n) { return on_face[std::size_t(n)]; });
      });
      const bool tied = std::any_of(bodies.begin(), bodies.end(), [&](const FilledBody& p) {
        return p.has_particles() && p.deck->tie == b.deck->name && touches_particles(b.hexes, quad, p);
      });
      if (inner || tied) continue;
      FreeQuad one{quad.node, b.first_hex + quad.hex, area_of(b.hexes, quad).norm()};
      for (int& node : one.node) node += b.first;
      free.push_back(one);
    }
  }
  return free;
}

void share_masses(std::vector<double>& mass, const Faces& faces) {
  for (std::size_t pass = 0; pass < faces.transforms.size(); ++pass) // as couple_nodes does with forces
    for (const auto& [master, slave, transform] : faces.coupled_nodes)
      if (transform == int(pass)) mass[master] = mass[slave] = 0.5 * (mass[master] + mass[slave]);
}

namespace {

void gather_corners(HexMesh& m, const std::vector<Hex>& hexes) {
  std::vector<int> start(std::size_t(m.nodes) + 1, 0), corner(8 * hexes.size());
  for (const Hex& hex : hexes)
    for (int node : hex.node) ++start[std::size_t(node) + 1];
  for (std::size_t n = 1; n < start.size(); ++n) start[n] += start[n - 1];
  std::vector<int> next(start.begin(), start.end() - 1);
  for (std::size_t h = 0; h < hexes.size(); ++h)
    for (std::size_t a = 0; a < 8; ++a)
      corner[std::size_t(next[std::size_t(hexes[h].node[a])]++)] = int(8 * h + a);
  m.corner_start = upload("corner_start", start);
  m.corner_of_node = upload("corner_of_node", corner);
}

} // namespace

HeatedNodes make_heated_nodes(const std::vector<FilledBody>& bodies, const Faces& faces) {
  std::map<int, std::vector<std::pair<int, double>>> of_node; // face and area
  for (std::size_t row = 0; row < faces.heated.size(); ++row) {
    const FilledBody& b = bodies[std::size_t(faces.heated_hexes[row].first)];
    const auto members = b.hexes.faces.find(faces.heated_hexes[row].second);
    if (b.has_particles() || members == b.hexes.faces.end()) continue;
    std::vector<double> area(b.hexes.node.size(), -1); // not of the face
    for (int node : members->second) area[std::size_t(node)] = 0;
    for (const SurfaceQuad& quad : find_surface(b.hexes)) {
      const auto is_member = [&](int n) { return area[std::size_t(n)] >= 0; };
      if (!std::all_of(quad.node.begin(), quad.node.end(), is_member)) continue;
      for (int node : quad.node) area[std::size_t(node)] += 0.25 * area_of(b.hexes, quad).norm();
    }
    for (int node : members->second) of_node[b.first + node].emplace_back(int(row), area[std::size_t(node)]);
  }
  std::vector<int> node, start{0}, face;
  std::vector<double> area;
  for (const auto& [n, entries] : of_node) {
    node.push_back(n);
    for (const auto& [row, part] : entries) face.push_back(row), area.push_back(part);
    start.push_back(int(face.size()));
  }
  HeatedNodes nodes;
  nodes.count = int(node.size());
  nodes.node = upload("heated_nodes.node", node), nodes.start = upload("heated_nodes.start", start);
  nodes.face = upload("heated_nodes.face", face);
  nodes.area = upload<ScalarField>("heated_nodes.area", int(area.size()),
                                   [&](auto& f, int k) { f(k) = Real(area[std::size_t(k)]); });
  return nodes;
}

HexMesh make_hex_mesh(const Deck& deck, const std::vector<FilledBody>& bodies, const Faces& faces) {
  const std::vector<Hex> hexes = list_hexes(deck, bodies);
  std::vector<Node> nodes;
  for (const FilledBody& b : bodies)
    for (const Point& x : b.hexes.node) nodes.push_back({&b, x});
  const auto density = [&](const Hex& h) { return deck.materials[std::size_t(h.body->material)].density; };
  std::vector<double> mass(nodes.size(), 0);
  for (const Hex& hex : hexes)
    for (int node : hex.node) mass[std::size_t(node)] += density(hex) * hex.volume / 8;
  share_masses(mass, faces);
  std::vector<double> area(nodes.size(), 0);
  for (const FreeQuad& quad : list_free_quads(bodies))
    for (int node : quad.node) area[std::size_t(node)] += 0.25 * quad.area;

  HexMesh m;
  const int n = int(hexes.size());
  m.points.count = n;
  m.nodes = int(nodes.size());
  for_each_field(m, [&](const char* name, auto& field, auto facts) {
    allocate(field, name, facts, deck, facts.per == Per::per_node ? m.nodes : n);
  });
  if (conducts_heat(deck))
    m.nodal_temperature = upload<ScalarField>(
        "nodal_temperature", m.nodes, [&](auto& f, int a) { f(a) = Real(nodes[a].body->deck->temperature); });
  m.heat_capacity = upload<ScalarField>("heat_capacity", m.nodes, [&](auto& f, int a) {
    f(a) = Real(mass[a] * deck.materials[std::size_t(nodes[a].body->material)].specific_heat.least());
  });
  if (m.node_material.extent(0) > 0)
    m.node_material =
        upload<IndexField>("node_material", m.nodes, [&](auto& f, int a) { f(a) = nodes[a].body->material; });

  m.points.mass = upload<ScalarField>(
      "mass", n, [&](auto& f, int e) { f(e) = Real(density(hexes[e]) * hexes[e].volume); });
  m.points.density =
      upload<ScalarField>("density", n, [&](auto& f, int e) { f(e) = Real(density(hexes[e])); });
  m.points.temperature = upload<ScalarField>(
      "temperature", n, [&](auto& f, int e) { f(e) = Real(hexes[e].body->deck->temperature); });
  if (m.points.stress_temperature.extent(0) > 0)
    Kokkos::deep_copy(m.points.stress_temperature, m.points.temperature);
  m.points.material =
      upload<IndexField>("material", n, [&](auto& f, int e) { f(e) = hexes[e].body->material; });
  m.volume = upload<ScalarField>("volume", n, [&](auto& f, int e) { f(e) = Real(hexes[e].volume); });
  m.active = upload<View<int*>>("active", n, [](auto& f, int e) { f(e) = 1; });
  m.connectivity = upload<View<int* [8]>>("connectivity", n, [&](auto& f, int e) {
    for (int a = 0; a < 8; ++a) f(e, a) = hexes[e].node[a];
  });
  m.position = upload<VectorField>(
      "position", m.nodes, [&](auto& f, int a) { store_vector(f, a, to_vector3(nodes[a].position)); });
  m.velocity = upload<VectorField>("velocity", m.nodes, [&](auto& f, int a) {
    store_vector(f, a, to_vector3(nodes[a].body->deck->velocity));
  });
  m.mass = upload<ScalarField>("mass", m.nodes, [&](auto& f, int a) { f(a) = Real(mass[a]); });
  m.contact_area =
      upload<ScalarField>("contact_area", m.nodes, [&](auto& f, int a) { f(a) = Real(area[a]); });
  m.constraints =
      upload<View<unsigned*>>("constraints", m.nodes, [&](auto& f, int a) { f(a) = faces.node_bits[a]; });
  m.coupled_nodes =
      upload<View<int* [3]>>("coupled_nodes", int(faces.coupled_nodes.size()), [&](auto& f, int r) {
        for (int d = 0; d < 3; ++d) f(r, d) = faces.coupled_nodes[r][d];
      });
  gather_corners(m, hexes);
  return m;
}

} // namespace swarf
