// Facets without area, which some programs leave between others.
#include "src/geometry/flat_facets.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace swarf {
namespace {

constexpr double least_height = 1e-6; // over the longest side

Triple side(const FacetSurface& surface, int from, int to) {
  const Triple &a = surface.vertices[std::size_t(from)], &b = surface.vertices[std::size_t(to)];
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}
double length(const Triple& t) { return std::hypot(t[0], t[1], t[2]); }

using Facet = std::array<int, 3>;

// The facet that runs along an edge in this direction; -1: several do.
class Directed {
 public:
  Directed(const FacetSurface& surface, const std::vector<bool>& is_gone) {
    for (int f = 0; f < int(surface.facets.size()); ++f)
      if (!is_gone[std::size_t(f)]) add(surface.facets[std::size_t(f)], f);
  }
  int find(int from, int to) const {
    const auto at = facet.find({from, to});
    return at == facet.end() ? -1 : at->second;
  }
  void add(const Facet& corners, int f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [at, is_new] = facet.try_emplace({corners[k], corners[(k + 1) % 3]}, f);
      if (!is_new) at->second = -1;
    }
  }
  void remove(const Facet& corners) {
    for (std::size_t k = 0; k < 3; ++k) facet.erase({corners[k], corners[(k + 1) % 3]});
  }

 private:
  std::map<std::pair<int, int>, int> facet;
};

// The corner that the longest side leads away from.
std::size_t start_of_longest(const FacetSurface& surface, const Facet& f) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (length(side(surface, f[k], f[(k + 1) % 3])) > length(side(surface, f[best], f[(best + 1) % 3])))
      best = k;
  return best;
}

// Two that lie back to back on the same three corners.
void leave_out_pairs(const FacetSurface& surface, const std::vector<int>& flat, std::vector<bool>& is_gone) {
  std::map<Facet, int> waiting; // by corners in ascending order
  for (const int f : flat) {
    Facet key = surface.facets[std::size_t(f)];
    std::sort(key.begin(), key.end());
    const auto [at, is_new] = waiting.try_emplace(key, f);
    if (is_new) continue;
    is_gone[std::size_t(f)] = is_gone[std::size_t(at->second)] = true;
    waiting.erase(at);
  }
}

} // namespace

bool is_flat(const FacetSurface& surface, const Facet& facet) {
  const auto& [a, b, c] = facet;
  const Triple u = side(surface, a, b), v = side(surface, a, c);
  const double longest = std::max({length(u), length(v), length(side(surface, b, c))});
  const Triple n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  return !(length(n) > least_height * longest * longest);
}

void take_out_flat_facets(FacetSurface& surface) {
  std::vector<int> flat;
  for (int f = 0; f < int(surface.facets.size()); ++f)
    if (is_flat(surface, surface.facets[std::size_t(f)])) flat.push_back(f);
  if (flat.empty()) return;
  surface.collapsed += int(flat.size());
  std::vector<bool> is_gone(surface.facets.size(), false);
  leave_out_pairs(surface, flat, is_gone);
  Directed edges(surface, is_gone);
  // Each turn makes the sum of all sides shorter; the bound is for sides that differ by round-off.
  for (std::size_t turns = 0; !flat.empty() && turns < 16 * surface.facets.size(); ++turns) {
    const int f = flat.back();
    flat.pop_back();
    Facet& one = surface.facets[std::size_t(f)];
    if (is_gone[std::size_t(f)] || !is_flat(surface, one)) continue;
    const std::size_t k = start_of_longest(surface, one);
    const int p = one[k], q = one[(k + 1) % 3], r = one[(k + 2) % 3], g = edges.find(q, p);
    if (g < 0 || g == f) continue;
    Facet& other = surface.facets[std::size_t(g)];
    const int t = other[0] + other[1] + other[2] - p - q;
    edges.remove(one), edges.remove(other);
    if (t == r) { // back to back
      is_gone[std::size_t(f)] = is_gone[std::size_t(g)] = true;
      continue;
    }
    one = {r, p, t}, other = {t, q, r};
    for (const int changed : {f, g}) {
      edges.add(surface.facets[std::size_t(changed)], changed);
      if (is_flat(surface, surface.facets[std::size_t(changed)])) flat.push_back(changed);
    }
  }
  std::size_t kept = 0;
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    if (!is_gone[f]) surface.facets[kept++] = surface.facets[f];
  surface.facets.resize(kept);
}

} // namespace swarf
