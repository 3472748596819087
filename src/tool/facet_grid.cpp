// The grid of candidate facets, once, on the host.
#include "src/tool/geometry.hpp"
#include "swarf/tool/signed_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace swarf {
namespace {

constexpr long most_cells = 4'000'000;

Vector3 to_vector(const Triple& t) { return {Real(t[0]), Real(t[1]), Real(t[2])}; }
// Facets as the device sees them, and the lattice of cells.
struct GridBuilder {
  std::vector<Triangle> triangles;
  Tool tool;
  Real half_diagonal = 0;

  Vector3 centre(int i, int j, int k) const {
    const Real half = Real(0.5);
    return tool.grid_origin + tool.cell_size * Vector3{Real(i) + half, Real(j) + half, Real(k) + half};
  }
  long cell(int i, int j, int k) const { return i + tool.cells[0] * (j + long(tool.cells[1]) * k); }
  long cells() const { return long(tool.cells[0]) * tool.cells[1] * tool.cells[2]; }

  void place(double reach);
  // visit(cell, distance of the facet from the cell's centre) for distances up to `within`.
  template <class Visitor>
  void for_each_near_cell(const Triangle& t, Real within, Visitor&& visit) const;
};

// Cells of half the reach, as long as they are not too many; a margin in which points near the surface lie.
void GridBuilder::place(double reach) {
  Vector3 low = triangles.front().a, high = low;
  for (const Triangle& t : triangles)
    for (const Vector3* v : {&t.a, &t.b, &t.c}) {
      low = {std::min(low.x, v->x), std::min(low.y, v->y), std::min(low.z, v->z)};
      high = {std::max(high.x, v->x), std::max(high.y, v->y), std::max(high.z, v->z)};
    }
  const Real margin = Real(reach);
  const Vector3 size = high - low + Vector3{2 * margin, 2 * margin, 2 * margin};
  double edge = reach / 2;
  const auto count = [&edge](Real length) { return long(std::ceil(double(length) / edge)) + 1; };
  while (double(count(size.x)) * double(count(size.y)) * double(count(size.z)) > most_cells) edge *= 1.1;
  tool.cell_size = Real(edge);
  tool.grid_origin = low - Vector3{margin, margin, margin};
  tool.cells[0] = int(count(size.x)), tool.cells[1] = int(count(size.y)), tool.cells[2] = int(count(size.z));
  tool.reach = Real(reach);
  half_diagonal = Real(0.5) * std::sqrt(Real(3)) * tool.cell_size;
}

template <class Visitor>
void GridBuilder::for_each_near_cell(const Triangle& t, Real within, Visitor&& visit) const {
  int from[3], to[3];
  for (int d = 0; d < 3; ++d) {
    const auto component = [d](const Vector3& v) { return d == 0 ? v.x : d == 1 ? v.y : v.z; };
    const Real a = component(t.a), b = component(t.b), c = component(t.c), o = component(tool.grid_origin);
    from[d] = std::max(0, int(std::floor((std::min({a, b, c}) - within - o) / tool.cell_size)));
    to[d] = std::min(tool.cells[d] - 1, int(std::floor((std::max({a, b, c}) + within - o) / tool.cell_size)));
  }
  for (int k = from[2]; k <= to[2]; ++k)
    for (int j = from[1]; j <= to[1]; ++j)
      for (int i = from[0]; i <= to[0]; ++i) {
        const Vector3 x = centre(i, j, k);
        const Real distance = norm(x - nearest_on_triangle(t, x).point);
        if (distance <= within) visit(cell(i, j, k), distance);
      }
}

// A facet t can be nearest to some point of a cell with half diagonal r only if d_t(c) <= min_s d_s(c) + 2 r
// at the centre c. A cell comes within reach only if min_s d_s(c) <= reach + r.
struct Candidates {
  std::vector<Real> nearest; // facet's distance from each centre, infinite where the cell stays empty
  std::vector<int> start;
  std::vector<std::pair<Real, int>> listed; // distance from the centre, facet; in this order within a cell
};

Candidates find_candidates(const GridBuilder& grid) {
  const Tool& tool = grid.tool;
  const Real slack =
      Real(1000) * std::numeric_limits<Real>::epsilon() *
      (norm(tool.grid_origin) + tool.cell_size * Real(tool.cells[0] + tool.cells[1] + tool.cells[2]));
  const Real touch = tool.reach + grid.half_diagonal + slack;
  Candidates result;
  result.nearest.assign(std::size_t(grid.cells()), std::numeric_limits<Real>::infinity());
  for (const Triangle& t : grid.triangles)
    grid.for_each_near_cell(t, touch,
                            [&](long c, Real d) { result.nearest[c] = std::min(result.nearest[c], d); });

  struct Pair {
    int cell, facet;
    Real distance;
  };
  std::vector<Pair> pairs;
  for (std::size_t f = 0; f < grid.triangles.size(); ++f)
    grid.for_each_near_cell(grid.triangles[f], touch + 2 * grid.half_diagonal + slack, [&](long c, Real d) {
      // infinite <= infinite must not pass: such cells are empty.
      if (result.nearest[c] <= touch && d <= result.nearest[c] + 2 * grid.half_diagonal + slack)
        pairs.push_back({int(c), int(f), d});
    });

  result.start.assign(std::size_t(grid.cells()) + 1, 0);
  for (const Pair& p : pairs) ++result.start[p.cell + 1];
  for (std::size_t c = 1; c < result.start.size(); ++c) result.start[c] += result.start[c - 1];
  std::vector<int> next(result.start.begin(), result.start.end() - 1);
  result.listed.resize(pairs.size());
  for (const Pair& p : pairs) result.listed[next[p.cell]++] = {p.distance, p.facet};
  for (std::size_t c = 0; c + 1 < result.start.size(); ++c)
    std::sort(result.listed.begin() + result.start[c], result.listed.begin() + result.start[c + 1]);
  return result;
}

// Cells without facets that lie in the body. The surface does not pass between such cells that share a face,
// so one point tells for all that are connected.
std::vector<char> find_deep_cells(const GridBuilder& grid, const Candidates& candidates,
                                  const Pseudonormals& normals) {
  enum : char { unknown = 0, outside = 1, inside = 2 };
  const int* n = grid.tool.cells;
  std::vector<char> state(std::size_t(grid.cells()), unknown);
  const auto is_empty = [&](long c) { return candidates.start[c] == candidates.start[c + 1]; };
  const auto find_side = [&](long c) {
    const Vector3 x = grid.centre(int(c % n[0]), int(c / n[0] % n[1]), int(c / n[0] / n[1]));
    Real best = std::numeric_limits<Real>::infinity(), side = 0;
    for (std::size_t f = 0; f < grid.triangles.size(); ++f) {
      const NearestOnTriangle nearest = nearest_on_triangle(grid.triangles[f], x);
      const Vector3 d = x - nearest.point;
      if (dot(d, d) < best) best = dot(d, d), side = dot(d, to_vector(normals[f][nearest.feature]));
    }
    return side < 0 ? inside : outside;
  };
  std::vector<long> front;
  for (long seed = 0; seed < grid.cells(); ++seed) {
    if (state[seed] != unknown || !is_empty(seed)) continue;
    const char side = find_side(seed);
    state[seed] = side, front.push_back(seed);
    while (!front.empty()) {
      const long c = front.back();
      front.pop_back();
      const long at[3] = {c % n[0], c / n[0] % n[1], c / n[0] / n[1]};
      const long step[3] = {1, n[0], long(n[0]) * n[1]};
      for (int d = 0; d < 3; ++d)
        for (const int sign : {-1, 1}) {
          if (at[d] + sign < 0 || at[d] + sign >= n[d]) continue;
          const long other = c + sign * step[d];
          if (state[other] == unknown && is_empty(other)) state[other] = side, front.push_back(other);
        }
    }
  }
  for (char& s : state) s = s == inside;
  return state;
}

template <class Field, class Data>
void upload(Field& field, const char* label, const Data& data) {
  field = Field(label, data.size());
  const auto host = Kokkos::create_mirror_view(field);
  for (std::size_t i = 0; i < data.size(); ++i) host(i) = data[i];
  Kokkos::deep_copy(field, host);
}

// Of the centre of a cell from the facet that is nearest to it.
Real centre_distance(const GridBuilder& grid, long c, int facet, const Pseudonormals& normals) {
  const int* n = grid.tool.cells;
  const Vector3 x = grid.centre(int(c % n[0]), int(c / n[0] % n[1]), int(c / n[0] / n[1]));
  const NearestOnTriangle nearest = nearest_on_triangle(grid.triangles[std::size_t(facet)], x);
  const Vector3 d = x - nearest.point;
  return dot(d, to_vector(normals[std::size_t(facet)][std::size_t(nearest.feature)])) < 0 ? -norm(d)
                                                                                          : norm(d);
}

void upload_grid(Tool& tool, const GridBuilder& grid, const Candidates& candidates,
                 const std::vector<char>& deep, const Pseudonormals& normals) {
  std::vector<int> start{0}, facet;
  std::vector<Real> distance, of_centre;
  start.reserve(candidates.start.size());
  for (std::size_t c = 0; c + 1 < candidates.start.size(); ++c) {
    for (int e = candidates.start[c]; e < candidates.start[c + 1]; ++e)
      facet.push_back(candidates.listed[e].second), distance.push_back(candidates.listed[e].first);
    const bool empty = candidates.start[c] == candidates.start[c + 1];
    const Real far = std::numeric_limits<Real>::infinity();
    of_centre.push_back(
        empty ? (deep[c] ? -far : far)
              : centre_distance(grid, long(c), candidates.listed[candidates.start[c]].second, normals));
    if (deep[c]) facet.push_back(Tool::deep_inside), distance.push_back(0);
    start.push_back(int(facet.size()));
  }
  upload(tool.cell_start, "tool_cell_start", start);
  upload(tool.cell_facet, "tool_cell_facet", facet);
  upload(tool.facet_distance, "tool_facet_distance", distance);
  upload(tool.cell_distance, "tool_cell_distance", of_centre);
}

void upload_facets(Tool& tool, const FacetSurface& surface, const Pseudonormals& normals) {
  tool.facets = int(surface.facets.size());
  tool.vertex = View<Real* [3][3]>("tool_vertex", tool.facets);
  tool.pseudonormal = View<Real* [7][3]>("tool_pseudonormal", tool.facets);
  const auto vertex = Kokkos::create_mirror_view(tool.vertex);
  const auto pseudonormal = Kokkos::create_mirror_view(tool.pseudonormal);
  for (int f = 0; f < tool.facets; ++f)
    for (int d = 0; d < 3; ++d) {
      for (int k = 0; k < 3; ++k) vertex(f, k, d) = Real(surface.vertices[surface.facets[f][k]][d]);
      for (int k = 0; k < 7; ++k) pseudonormal(f, k, d) = Real(normals[f][k][d]);
    }
  Kokkos::deep_copy(tool.vertex, vertex);
  Kokkos::deep_copy(tool.pseudonormal, pseudonormal);
}

} // namespace

Tool build_tool(const FacetSurface& surface, const ToolDeck& deck, double reach) {
  const Pseudonormals normals = find_pseudonormals(surface);
  GridBuilder grid;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const auto& [a, b, c] = surface.facets[f];
    grid.triangles.push_back({to_vector(surface.vertices[a]), to_vector(surface.vertices[b]),
                              to_vector(surface.vertices[c]), to_vector(normals[f][0])});
  }
  grid.place(reach);
  const Candidates candidates = find_candidates(grid);
  Tool tool = grid.tool;
  upload_grid(tool, grid, candidates, find_deep_cells(grid, candidates, normals), normals);
  upload_facets(tool, surface, normals);
  tool.teeth = std::max(1, deck.flutes);
  if (deck.kind == ToolKind::end_mill) tool.twist = Real(std::tan(deck.helix) / (deck.diameter / 2));
  return tool;
}

} // namespace swarf
