#include "src/scene/hex_conversion.hpp"
#include "src/geometry/upload.hpp"
#include "src/tool/geometry.hpp"
#include <algorithm>
#include <cmath>
#include <filesystem>

namespace swarf {
namespace {

// Nodes that are one node seen twice get one number.
std::vector<int> join_pairs(const Faces& faces, std::size_t nodes) {
  std::vector<int> one(nodes);
  for (std::size_t a = 0; a < nodes; ++a) one[a] = int(a);
  for (std::size_t pass = 0; pass < faces.transforms.size(); ++pass) // as share_masses
    for (const auto& [master, slave, transform] : faces.coupled_nodes)
      one[std::size_t(master)] = one[std::size_t(slave)] =
          std::min(one[std::size_t(master)], one[std::size_t(slave)]);
  return one;
}

void list_hexes_at_nodes(HexConversion& c) {
  c.hex_start.assign(c.node.size() + 1, 0);
  const auto of = [&](int node) { return std::size_t(c.one_of_pair[std::size_t(node)]); };
  for (const auto& hex : c.hex)
    for (int node : hex) ++c.hex_start[of(node) + 1];
  for (std::size_t a = 1; a < c.hex_start.size(); ++a) c.hex_start[a] += c.hex_start[a - 1];
  c.hex_at.resize(std::size_t(c.hex_start.back()));
  std::vector<int> next(c.hex_start.begin(), c.hex_start.end() - 1);
  for (std::size_t e = 0; e < c.hex.size(); ++e)
    for (int node : c.hex[e]) c.hex_at[std::size_t(next[of(node)]++)] = int(e);
}

// Hexes with a node on a fixed or driven face stay what they are: nothing would hold their particles.
ConversionLimits make_limits(const Deck& deck, const HexConversion& c) {
  const auto is_held = [&](int e) {
    unsigned bits = 0;
    for (int node : c.hex[std::size_t(e)]) bits |= c.faces.node_bits[std::size_t(node)];
    for (std::size_t b = 0; b < c.faces.constraints.size(); ++b)
      if ((bits >> b & 1u) && c.faces.constraints[b].all) return true;
    return false;
  };
  ConversionLimits limits;
  const int n = int(c.hex.size());
  const auto limit = [&](const std::string& name, auto&& of_body) {
    return upload<ScalarField>(name, n, [&](auto& f, int e) {
      const BodyDeck& body = deck.bodies[std::size_t(c.body[std::size_t(e)])];
      f(e) = c.cells_of(e) == 0 || is_held(e) ? Real(0) : Real(of_body(body).value_or(0));
    });
  };
  limits.distance = limit("convert_distance", [](const BodyDeck& b) { return b.convert_distance; });
  limits.strain = limit("convert_strain", [](const BodyDeck& b) { return b.convert_strain; });
  double farthest = 0;
  for (const BodyDeck& body : deck.bodies) farthest = std::max(farthest, body.convert_distance.value_or(0));
  if (deck.tool && farthest > 0) {
    const std::string folder = std::filesystem::path(deck.file).parent_path().string();
    limits.tool = build_tool(make_tool_surface(*deck.tool, folder), *deck.tool, farthest);
  }
  return limits;
}

double least_edge(const HexConversion& c, std::size_t e) {
  double least = 1e300;
  for (const auto& [a, b] : {std::pair{0, 1},
                             {1, 2},
                             {2, 3},
                             {3, 0},
                             {4, 5},
                             {5, 6},
                             {6, 7},
                             {7, 4},
                             {0, 4},
                             {1, 5},
                             {2, 6},
                             {3, 7}})
    least = std::min(least, (c.node[std::size_t(c.hex[e][a])] - c.node[std::size_t(c.hex[e][b])]).norm());
  return least;
}

} // namespace

int HexConversion::count() const {
  int sum = 0;
  for (int e = 0; e < int(hex.size()); ++e) sum += cells_of(e) > 0 ? 1 : 0;
  return sum;
}

int HexConversion::cells_of(int e) const {
  const int n = lattice[std::size_t(body[std::size_t(e)])].n;
  return n * n * n;
}

std::array<double, 8> HexConversion::shape(int n, int c) {
  const double xi[3] = {(2.0 * (c % n) + 1) / n - 1, (2.0 * (c / n % n) + 1) / n - 1,
                        (2.0 * (c / n / n) + 1) / n - 1};
  std::array<double, 8> N{};
  for (int a = 0; a < 8; ++a)
    N[std::size_t(a)] = (((a + 1) / 2) % 2 ? 1 + xi[0] : 1 - xi[0]) * ((a / 2) % 2 ? 1 + xi[1] : 1 - xi[1]) *
                        (a / 4 ? 1 + xi[2] : 1 - xi[2]) / 8;
  return N;
}

Point HexConversion::place(int e, int c) const {
  const auto N = shape(lattice[std::size_t(body[std::size_t(e)])].n, c);
  Point x(0, 0, 0);
  for (std::size_t a = 0; a < 8; ++a) x += N[a] * node[std::size_t(hex[std::size_t(e)][a])];
  return x;
}

std::shared_ptr<const HexConversion> make_conversion(const Deck& deck, const std::vector<FilledBody>& bodies,
                                                     const Faces& faces, const HexMesh& mesh, double reach) {
  if (std::none_of(deck.bodies.begin(), deck.bodies.end(), [](const BodyDeck& b) { return b.converts(); }))
    return nullptr;
  auto made = std::make_shared<HexConversion>();
  HexConversion& c = *made;
  for (const FilledBody& b : bodies) {
    c.lattice.push_back({b.deck->converts() ? b.deck->convert_particles : 0, b.points.spacing, b.material});
    c.node.insert(c.node.end(), b.hexes.node.begin(), b.hexes.node.end());
    c.body.insert(c.body.end(), b.hexes.hex.size(), b.row);
    for (auto hex : b.hexes.hex) {
      for (int& node : hex) node += b.first;
      c.hex.push_back(hex);
    }
  }
  const auto mass = host_copy(mesh.points.mass);
  c.travel = 1e300;
  for (std::size_t e = 0; e < c.hex.size(); ++e) {
    const int n = std::max(1, c.lattice[std::size_t(c.body[e])].n);
    c.mass.push_back(double(mass(int(e)))), c.gap.push_back(0.5 * least_edge(c, e) / n);
    if (c.cells_of(int(e)) > 0) c.travel = std::min(c.travel, 0.25 * least_edge(c, e));
  }
  c.quads = list_free_quads(bodies), c.faces = faces, c.reach = reach;
  c.one_of_pair = join_pairs(faces, c.node.size());
  list_hexes_at_nodes(c);
  c.limits = make_limits(deck, c);
  return made;
}

} // namespace swarf
