#include "src/geometry/surface_quads.hpp"
#include "src/geometry/upload.hpp"
#include "src/scene/parts.hpp"
#include <algorithm>

namespace swarf {
namespace {

// The hex at each side of each; what no body can touch are periodic and symmetric planes, and where particles
// are tied.
std::vector<std::array<int, 6>> list_sides(const std::vector<FilledBody>& bodies) {
  std::vector<std::array<int, 6>> behind;
  std::vector<std::array<int, 8>> corners;
  for (const FilledBody& b : bodies)
    for (std::size_t e = 0; const auto& next : find_face_neighbors(b.hexes)) {
      auto& sides = behind.emplace_back();
      auto& nodes = corners.emplace_back(b.hexes.hex[e++]);
      for (int& node : nodes) node += b.first;
      for (std::size_t s = 0; s < 6; ++s) sides[s] = next[s] < 0 ? no_surface : b.first_hex + next[s];
    }
  for (const FreeQuad& quad : list_free_quads(bodies))
    for (int s = 0; s < 6; ++s) {
      bool same = true;
      for (int k = 0; k < 4; ++k)
        same = same &&
               corners[std::size_t(quad.hex)][std::size_t(corner_of_side(s, k))] == quad.node[std::size_t(k)];
      if (same) behind[std::size_t(quad.hex)][std::size_t(s)] = no_hex;
    }
  return behind;
}

double shortest_edge(const FilledBody& b) {
  double least = b.points.position.empty() ? 1e300 : b.points.spacing;
  for (const auto& hex : b.hexes.hex)
    for (const auto& [from, to] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 4)})
      least = std::min(least, (b.hexes.node[std::size_t(hex[std::size_t(to)])] -
                               b.hexes.node[std::size_t(hex[std::size_t(from)])])
                                  .norm());
  return least;
}

} // namespace

ContactGroups make_contact_groups(const Deck& deck, const std::vector<FilledBody>& bodies) {
  ContactGroups groups;
  if (!can_meet(deck)) return groups;
  const std::vector<int> of_body = contact_groups(deck);
  groups.count = int(bodies.size()); // numbers that tied bodies leave out are groups without anything
  groups.of_body = upload("contact_groups.of_body", of_body);
  std::vector<int> of_hex;
  double edge = 1e300;
  for (const FilledBody& b : bodies) {
    of_hex.insert(of_hex.end(), b.hexes.hex.size(), of_body[std::size_t(b.row)]);
    edge = std::min(edge, shortest_edge(b));
  }
  groups.of_hex = upload("contact_groups.of_hex", of_hex);
  groups.skin = Real(0.3 * edge);
  const auto behind = list_sides(bodies);
  groups.behind = upload<View<int* [6]>>("contact_groups.behind", int(behind.size()), [&](auto& f, int e) {
    for (int s = 0; s < 6; ++s) f(e, s) = behind[std::size_t(e)][std::size_t(s)];
  });
  return groups;
}

} // namespace swarf
