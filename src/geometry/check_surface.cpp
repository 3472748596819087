#include "src/geometry/flat_facets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace swarf {
namespace {

std::string describe(const FacetSurface& surface, int f) {
  std::string text = fmt::format("facet {}", f + 1);
  for (int k = 0; k < 3; ++k) {
    const Triple& v = surface.vertices[surface.facets[f][k]];
    text += fmt::format("{}({:.6g}, {:.6g}, {:.6g})", k == 0 ? " with corners " : ", ", v[0], v[1], v[2]);
  }
  return text + " m";
}

void check_areas(const FacetSurface& surface, const std::string& name) {
  for (int f = 0; f < int(surface.facets.size()); ++f)
    if (is_flat(surface, surface.facets[f]))
      throw DeckError(fmt::format(
          "{}: {} has no area, and no neighbour along its longest side could take it over; remove "
          "it and join its neighbours, or export the surface again with coarser facets or more "
          "digits",
          name, describe(surface, f)));
}

using Edge = std::pair<int, int>;
struct EdgeUse {
  std::vector<int> forward, backward; // facets that run along the edge, and against it
};

std::map<Edge, EdgeUse> list_edges(const FacetSurface& surface) {
  std::map<Edge, EdgeUse> edges;
  for (int f = 0; f < int(surface.facets.size()); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = surface.facets[f][k], b = surface.facets[f][(k + 1) % 3];
      EdgeUse& use = edges[std::minmax(a, b)];
      (a < b ? use.forward : use.backward).push_back(f);
    }
  return edges;
}

// Of two neighbours that disagree, the wrong one disagrees with more of its other neighbours.
void check_winding(const FacetSurface& surface, const std::map<Edge, EdgeUse>& edges,
                   const std::string& name) {
  std::vector<int> conflicts(surface.facets.size(), 0);
  for (const auto& [edge, use] : edges)
    if (use.forward.size() + use.backward.size() == 2 && use.forward.size() != 1)
      for (const auto* side : {&use.forward, &use.backward})
        for (const int f : *side) ++conflicts[f];
  const auto worst = std::max_element(conflicts.begin(), conflicts.end());
  if (worst != conflicts.end() && *worst > 0)
    throw DeckError(
        fmt::format("{}: {} is inverted: it is turned against {} of its 3 neighbours; list its corners "
                    "counter-clockwise seen from outside",
                    name, describe(surface, int(worst - conflicts.begin())), *worst));
}

void check_edges(const FacetSurface& surface, const std::map<Edge, EdgeUse>& edges, const std::string& name) {
  for (const auto& [edge, use] : edges) {
    const std::size_t facets = use.forward.size() + use.backward.size();
    if (facets == 2) continue;
    const int f = use.forward.empty() ? use.backward.front() : use.forward.front();
    const Triple &a = surface.vertices[edge.first], &b = surface.vertices[edge.second];
    const std::string where =
        fmt::format("{}: {}: its edge ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}) m", name,
                    describe(surface, f), a[0], a[1], a[2], b[0], b[1], b[2]);
    if (facets == 1)
      throw DeckError(where + " is open: no other facet shares it; close the hole, and see that "
                              "neighbours use the very same corners");
    throw DeckError(where + fmt::format(" is shared by {} facets instead of 2; the surface must bound "
                                        "one body without touching itself",
                                        facets));
  }
}

// Signed volume of each connected part by the divergence theorem.
void check_outward(const FacetSurface& surface, const std::string& name) {
  std::vector<int> part(surface.vertices.size());
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](int v) {
    while (part[v] != v) v = part[v] = part[part[v]];
    return v;
  };
  for (const auto& [a, b, c] : surface.facets) part[root(b)] = root(a), part[root(c)] = root(a);
  std::map<int, std::pair<double, int>> volume; // of a part, and its first facet
  const Triple& o = surface.vertices.front();
  for (int f = 0; f < int(surface.facets.size()); ++f) {
    Triple p[3];
    for (int k = 0; k < 3; ++k)
      for (int d = 0; d < 3; ++d) p[k][d] = surface.vertices[surface.facets[f][k]][d] - o[d];
    auto& [sum, first] = volume.try_emplace(root(surface.facets[f][0]), 0.0, f).first->second;
    sum += (p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
            p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
            p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])) /
           6;
  }
  for (const auto& [key, value] : volume)
    if (!(value.first > 0))
      throw DeckError(
          fmt::format("{}: the part of the surface that holds {} is inside out (volume {:.3g} m3); turn "
                      "all its facets around, or fill the cavity",
                      name, describe(surface, value.second), value.first));
}

} // namespace

void check_surface(const FacetSurface& surface, const std::string& name) {
  if (surface.facets.empty()) throw DeckError(name + ": no facets; give a closed surface");
  for (int f = 0; f < int(surface.facets.size()); ++f)
    for (const int v : surface.facets[f])
      for (const double x : surface.vertices[v])
        if (!std::isfinite(x))
          throw DeckError(
              fmt::format("{}: {} is not finite; export the surface again", name, describe(surface, f)));
  check_areas(surface, name);
  const auto edges = list_edges(surface);
  check_winding(surface, edges, name);
  check_edges(surface, edges, name);
  check_outward(surface, name);
}

} // namespace swarf
