// Meshes as they are: hexes from Abaqus' own text, particles from rows x, y, z, volume.
#include "src/files/results.hpp"
#include "src/geometry/body_file.hpp"
#include "src/geometry/mesh_text.hpp"
#include "src/geometry/surface_quads.hpp"
#include "swarf/hexes/hex8.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <set>
#include <unordered_map>

namespace swarf {
namespace {

// Along the three edges that leave a corner, such that their product is positive in a hex that is in order.
constexpr int next_corners[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                    {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};

class HexReader {
 public:
  HexReader(const BodyDeck& from, const std::string& named) : body(from), file(named) {}

  HexSet read() {
    for (const MeshKeyword& keyword : read_mesh_text(read_text(file))) take(keyword);
    if (set.hex.empty())
      throw DeckError(file +
                      ": holds no hexes: expected *NODE and *ELEMENT, TYPE=C3D8R (or C3D8), as Abaqus writes "
                      "them");
    leave_out_unused();
    return std::move(set);
  }

 private:
  const BodyDeck& body;
  const std::string& file;
  HexSet set;
  std::unordered_map<long, int> node; // row of a node's number
  std::set<long> elements;
  std::map<std::array<int, 8>, long> element_of; // nodes in ascending order
  int parts = 0;

  void take(const MeshKeyword& k) {
    static const std::set<std::string> makers = {"INCLUDE", "NGEN",   "NFILL",  "NCOPY",   "NMAP",
                                                 "ELGEN",   "ELCOPY", "SYSTEM", "INSTANCE"};
    if (k.name.empty() && !k.rows.empty())
      refuse_line(file, k.rows.front().line,
                  "stands before the first keyword: expected *NODE; a mesh of particles "
                  "needs fill = \"particles\"");
    if (k.name == "PART" && ++parts > 1)
      refuse_line(file, k.line,
                  "begins a second part, whose nodes have the numbers of the first: expected one part "
                  "in the file; give each a file of its own, or use swarf import");
    if (makers.contains(k.name))
      refuse_line(file, k.line,
                  fmt::format("*{} makes or moves nodes in a way that is not read: expected *NODE, "
                              "*ELEMENT and *NSET alone; write the mesh out, or use swarf import",
                              k.name));
    const bool turned = k.has("SYSTEM") && upper(k.option("SYSTEM")) != "R";
    if ((k.name == "NODE" || k.name == "ELEMENT") && (turned || k.has("INPUT") || k.has("OFFSET")))
      refuse_line(file, k.line,
                  fmt::format("*{} has a system of its own, a file or an offset: expected Cartesian "
                              "coordinates and numbers in this file",
                              k.name));
    if (k.name == "NODE") take_nodes(k);
    if (k.name == "ELEMENT") take_elements(k);
    if (k.name == "NSET") take_set(k);
  }

  void take_nodes(const MeshKeyword& k) {
    for (const MeshRow& row : k.rows) {
      const long label = label_in(row, 0, file);
      if (!node.try_emplace(label, int(set.node.size())).second)
        refuse_line(file, row.line,
                    fmt::format("node {} is there already: expected each number once", label));
      Point x;
      for (std::size_t d = 0; d < 3; ++d)
        x[int(d)] = body.origin[d] + body.file_scale * number_in(row, d + 1, file);
      if (!k.option("NSET").empty()) members_of(k.option("NSET")).push_back(int(set.node.size()));
      set.node.push_back(x);
    }
  }

  int find_node(const MeshRow& row, std::size_t field) const {
    const long label = label_in(row, field, file);
    const auto at = node.find(label);
    if (at == node.end())
      refuse_line(file, row.line,
                  fmt::format("there is no node {} before this line: expected *NODE first", label));
    return at->second;
  }

  void take_elements(const MeshKeyword& k) {
    const std::string type = upper(k.option("TYPE"));
    if (type != "C3D8R" && type != "C3D8")
      refuse_line(file, k.line,
                  fmt::format("elements of type {} are not read: expected C3D8R or C3D8", type));
    for (const MeshRow& row : k.rows) {
      const long label = label_in(row, 0, file);
      if (row.fields.size() != 9)
        refuse_line(file, row.line,
                    fmt::format("element {} has {} nodes: expected 8", label, row.fields.size() - 1));
      if (!elements.insert(label).second)
        refuse_line(file, row.line,
                    fmt::format("element {} is there already: expected each number once", label));
      std::array<int, 8> hex{};
      for (std::size_t a = 0; a < 8; ++a) hex[a] = find_node(row, a + 1);
      set.hex.push_back(in_order(hex, label, row.line));
      std::sort(hex.begin(), hex.end());
      if (const auto [other, is_new] = element_of.try_emplace(hex, label); !is_new)
        refuse_line(file, row.line,
                    fmt::format("element {} has the nodes of element {}: expected one in each place", label,
                                other->second));
    }
  }

  // Names are compared as Abaqus does it, whatever their letters.
  std::vector<int>& members_of(const std::string& name) {
    for (auto& [known, members] : set.faces)
      if (upper(known) == upper(name)) return members;
    return set.faces[name];
  }

  // All corners turned the wrong way: the layers have changed places, and change back. Some: no hex.
  std::array<int, 8> in_order(std::array<int, 8> hex, long label, int line) const {
    int wrong = 0;
    double corners = 0; // of the Jacobian, their mean
    for (std::size_t a = 0; a < 8; ++a) {
      const auto edge = [&](int k) -> Point {
        return set.node[std::size_t(hex[std::size_t(next_corners[a][k])])] - set.node[std::size_t(hex[a])];
      };
      const double jacobian = edge(0).cross(edge(1)).dot(edge(2));
      wrong += jacobian > 0 ? 0 : 1, corners += std::abs(jacobian) / 8;
    }
    if (wrong == 8) std::rotate(hex.begin(), hex.begin() + 4, hex.end());
    if (wrong > 0 && wrong < 8)
      refuse_line(
          file, line,
          fmt::format("element {} is turned inside out or flat at {} of its corners: expected nodes 1 to 4 "
                      "around one side and 5 to 8 above them; mend it in the program that made the mesh",
                      label, wrong));
    if (jacobian_in_the_middle(hex) < least_middle * corners)
      refuse_line(
          file, line,
          fmt::format("element {} is twisted: expected node 5 above node 1; mend it in the program that "
                      "made the mesh",
                      label));
    return hex;
  }

  // Where one side is turned against the other by an angle a the section in the middle keeps cos2(a / 2):
  // less than this share beyond 66 deg, where the sides cut through each other.
  static constexpr double least_middle = 0.7;
  double jacobian_in_the_middle(const std::array<int, 8>& hex) const {
    constexpr int sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
    Eigen::Matrix3d edges = Eigen::Matrix3d::Zero();
    for (std::size_t a = 0; a < 8; ++a)
      for (int d = 0; d < 3; ++d) edges.col(d) += 0.25 * sign[a][d] * set.node[std::size_t(hex[a])];
    return edges.determinant();
  }

  void take_set(const MeshKeyword& k) {
    const std::string name = k.option("NSET");
    if (name.empty()) refuse_line(file, k.line, "has no name: expected *NSET, NSET=NAME");
    auto& members = members_of(name);
    for (const MeshRow& row : k.rows) {
      if (!k.has("GENERATE")) {
        for (std::size_t f = 0; f < row.fields.size(); ++f) members.push_back(find_node(row, f));
        continue;
      }
      const long first = label_in(row, 0, file), last = label_in(row, 1, file);
      const long step = row.fields.size() > 2 ? label_in(row, 2, file) : 1;
      for (const auto& [label, at] : node)
        if (label >= first && label <= last && (label - first) % step == 0) members.push_back(at);
    }
  }

  // Nodes without a hex have no mass. A node is once in a set.
  void leave_out_unused() {
    std::vector<int> row(set.node.size(), -1);
    for (const auto& hex : set.hex)
      for (const int n : hex) row[std::size_t(n)] = 0;
    std::vector<Point> kept;
    for (std::size_t n = 0; n < row.size(); ++n)
      if (row[n] >= 0) row[n] = int(kept.size()), kept.push_back(set.node[n]);
    set.node = kept;
    for (auto& hex : set.hex)
      for (int& n : hex) n = row[std::size_t(n)];
    for (auto& [name, members] : set.faces) {
      std::set<int> left;
      for (const int n : members)
        if (row[std::size_t(n)] >= 0) left.insert(row[std::size_t(n)]);
      members.assign(left.begin(), left.end());
    }
  }
};

FacetSurface outer_sides(const HexSet& hexes) {
  FacetSurface surface;
  for (const Point& x : hexes.node) surface.vertices.push_back({x.x(), x.y(), x.z()});
  for (const SurfaceQuad& quad : find_surface(hexes)) {
    const auto& [a, b, c, d] = quad.node;
    surface.facets.push_back({a, b, c}), surface.facets.push_back({a, c, d});
  }
  return surface;
}

double volume_of(const HexSet& set, const std::array<int, 8>& hex) {
  HexVectors x;
  for (int a = 0; a < 8; ++a)
    x.at[a] = to_vector3(Point(set.node[std::size_t(hex[std::size_t(a)])] - set.node[std::size_t(hex[0])]));
  return double(mean_gradient(x).volume);
}

std::string checksum(const HexSet& hexes, const PointSet& points) {
  std::string bytes;
  const auto add = [&](const auto& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), sizeof(values[0]) * values.size());
  };
  for (const Point& x : hexes.node) bytes.append(reinterpret_cast<const char*>(x.data()), 3 * sizeof(double));
  for (const auto& hex : hexes.hex) add(hex);
  for (const Point& x : points.position)
    bytes.append(reinterpret_cast<const char*>(x.data()), 3 * sizeof(double));
  add(points.volume);
  for (const FaceMembers* faces : {&hexes.faces, &points.faces})
    for (const auto& [name, members] : *faces) bytes += name, add(members);
  return hash_text(bytes);
}

} // namespace

BodyFile read_mesh(const BodyDeck& body, const std::string& name) {
  BodyFile mesh;
  if (body.fill == Fill::hexes) {
    mesh.hexes = HexReader(body, name).read();
    mesh.surface = std::make_shared<ClosedSurface>(outer_sides(mesh.hexes), Triple{});
    for (const auto& hex : mesh.hexes.hex) mesh.volume += volume_of(mesh.hexes, hex);
    mesh.box = mesh.surface->box();
  } else {
    mesh.points = read_mesh_points(body, name);
    std::vector<FacetTree::Box> cubes;
    for (std::size_t i = 0; i < mesh.points.position.size(); ++i) {
      const Point half = Point::Constant(mesh.points.gap[i]);
      cubes.emplace_back(mesh.points.position[i] - half, mesh.points.position[i] + half);
      mesh.box.extend(cubes.back()), mesh.volume += mesh.points.volume[i];
    }
    mesh.cubes = std::make_shared<FacetTree>(cubes);
  }
  mesh.contents =
      fmt::format("{} {} with the checksum {}", std::max(mesh.hexes.hex.size(), mesh.points.position.size()),
                  word_of(body.fill), checksum(mesh.hexes, mesh.points));
  return mesh;
}

namespace {

// Names of sets are those of the deck, in whatever letters the file has them.
void name_sets(const Shape& shape, FaceMembers& sets) {
  std::vector<std::string> known;
  for (const auto& [name, members] : sets) known.push_back(name);
  for (const FaceDeck& face : shape.body->faces) {
    const auto at = std::find_if(known.begin(), known.end(),
                                 [&](const std::string& name) { return upper(name) == upper(face.face); });
    if (at == known.end() || sets.at(*at).empty())
      reject(*shape.deck, *shape.body, "faces." + face.face,
             fmt::format("finds no set \"{}\" in its file, or one without a {}. Its sets are {}", face.face,
                         shape.body->fill == Fill::hexes ? "node" : "particle",
                         known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
    if (const auto members = sets.at(*at); *at != face.face) sets[face.face] = members;
  }
}

} // namespace

HexSet fill_hexes_of_mesh(const Shape& shape) {
  HexSet set = shape.file->hexes;
  name_sets(shape, set.faces);
  return set;
}

PointSet fill_points_of_mesh(const Shape& shape) {
  PointSet set = shape.file->points;
  name_sets(shape, set.faces);
  for (auto& [name, members] : set.faces) set.behind[name].assign(members.size(), -1);
  return set;
}

} // namespace swarf
