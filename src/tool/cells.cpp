#include "src/tool/cells.hpp"
#include "src/geometry/upload.hpp"
#include "swarf/kernels.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace swarf {
namespace {

using Leaf = ToolOctree::Leaf;
using Face = ToolOctree::Face;

bool is_whole(const Leaf& leaf) { return leaf.share >= 0.5 && leaf.distance < 0; }

double area_of(const ToolOctree& octree, const Face& f) {
  const double edge = octree.leaves[std::size_t(f.a)].size;
  return f.open * edge * (octree.one_layer ? octree.width : edge);
}

// The leaf whose cell each leaf belongs to, or -1: a sliver, or a leaf whose centre lies outside, goes to the
// neighbour that it has the widest opening to. Else its small volume would ask for short steps.
std::vector<int> merge_slivers(const ToolOctree& octree, const std::vector<Face>& faces) {
  const std::size_t n = octree.leaves.size();
  std::vector<int> host(n, -1);
  for (std::size_t k = 0; k < n; ++k)
    if (is_whole(octree.leaves[k])) host[k] = int(k);
  for (bool changed = true; changed;) { // a sliver beside slivers only waits for them
    changed = false;
    std::vector<double> widest(n, 0);
    std::vector<int> found(n, -1);
    for (const Face& f : faces)
      for (const auto& [from, to] : {std::pair(f.a, f.b), std::pair(f.b, f.a)}) {
        const double area = area_of(octree, f);
        if (host[std::size_t(from)] >= 0 || host[std::size_t(to)] < 0 || area <= widest[std::size_t(from)])
          continue;
        widest[std::size_t(from)] = area, found[std::size_t(from)] = host[std::size_t(to)];
      }
    for (std::size_t k = 0; k < n; ++k)
      if (found[k] >= 0) host[k] = found[k], changed = true;
  }
  return host;
}

// Leaves outside the tool, or beyond its cells, show the nearest cell: a point on the surface may lie there.
void fill_around(const ToolOctree& octree, std::vector<int>& cell) {
  for (bool changed = true; changed;) {
    changed = false;
    const std::vector<int> before = cell;
    for (int k = 0; k < int(cell.size()); ++k)
      for (int direction = 0; before[std::size_t(k)] < 0 && direction < octree.directions(); ++direction) {
        const int other = octree.find(octree.beyond_face(k, direction));
        if (other < 0 || before[std::size_t(other)] < 0) continue;
        cell[std::size_t(k)] = before[std::size_t(other)], changed = true;
        break;
      }
  }
}

struct Link {
  int from, to;
  double conductance;
};

// Both directions, in order, one for each pair of cells.
std::vector<Link> link_cells(const ToolOctree& octree, const std::vector<Face>& faces,
                             const std::vector<int>& cell, double conductivity) {
  std::vector<Link> links;
  for (const Face& f : faces) {
    const int a = cell[std::size_t(f.a)], b = cell[std::size_t(f.b)];
    const double way = 0.5 * (octree.leaves[std::size_t(f.a)].size + octree.leaves[std::size_t(f.b)].size);
    const double conductance = conductivity * area_of(octree, f) / way;
    if (a < 0 || b < 0 || a == b || conductance == 0) continue;
    links.push_back({a, b, conductance}), links.push_back({b, a, conductance});
  }
  std::stable_sort(links.begin(), links.end(), [](const Link& x, const Link& y) {
    return std::pair(x.from, x.to) < std::pair(y.from, y.to);
  });
  std::vector<Link> all;
  for (const Link& link : links)
    if (!all.empty() && all.back().from == link.from && all.back().to == link.to)
      all.back().conductance += link.conductance;
    else
      all.push_back(link);
  return all;
}

void upload_links(ToolHeat& heat, const std::vector<Link>& links) {
  std::vector<int> start(std::size_t(heat.cells) + 1, 0), neighbor;
  for (const Link& link : links) ++start[std::size_t(link.from) + 1], neighbor.push_back(link.to);
  for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
  heat.start = upload("tool_start", start), heat.neighbor = upload("tool_neighbor", neighbor);
  heat.conductance = upload<ScalarField>("tool_conductance", int(links.size()), [&](auto& f, int e) {
    f(e) = Real(links[std::size_t(e)].conductance);
  });
}

} // namespace

ToolHeat build_tool_heat(const Tool& tool, const FacetSurface& surface, const ToolDeck& deck,
                         const HeatPlan& plan) {
  const MaterialDeck& material = plan.material;
  const double coarsest = std::max(plan.finest, plan.reach / 4);
  const ToolSurvey survey(tool, surface, deck, coarsest);
  ToolOctree octree = grow_octree(surface, survey, plan);
  std::vector<Face> faces = octree.faces();
  measure_shares(octree, faces, survey);

  const std::vector<int> host = merge_slivers(octree, faces);
  std::vector<int> cell(host.size(), -1);
  std::vector<const Leaf*> cells;
  for (std::size_t k = 0; k < host.size(); ++k)
    if (host[k] == int(k)) cell[k] = int(cells.size()), cells.push_back(&octree.leaves[k]);
  for (std::size_t k = 0; k < host.size(); ++k)
    if (host[k] >= 0) cell[k] = cell[std::size_t(host[k])];
  if (cells.empty())
    throw DeckError(
        "tool.material: no part of the tool comes near the bodies during the run, so there is nothing "
        "to conduct. Check tool.position and velocity, or leave tool.material out");
  std::vector<double> capacity(cells.size(), 0);
  for (std::size_t k = 0; k < host.size(); ++k)
    if (cell[k] >= 0)
      capacity[std::size_t(cell[k])] += material.density * material.specific_heat.value *
                                        octree.leaves[k].share * octree.extent(octree.leaves[k].size).prod();

  ToolHeat heat;
  heat.cells = int(cells.size());
  heat.conductivity = Real(material.conductivity.value), heat.start_temperature = Real(deck.temperature);
  upload_links(heat, link_cells(octree, faces, cell, material.conductivity.value));
  heat.capacity = upload<ScalarField>("tool_capacity", heat.cells, [&](auto& f, int c) {
    const bool held =
        plan.held_beyond && plan.distance_to_work(cells[std::size_t(c)]->centre) > *plan.held_beyond;
    f(c) = held ? std::numeric_limits<Real>::infinity() : Real(capacity[std::size_t(c)]);
  });
  heat.temperature = ScalarField("tool_temperature", cells.size());
  Kokkos::deep_copy(heat.temperature, heat.start_temperature);
  heat.depth = upload<ScalarField>("tool_depth", heat.cells, [&](auto& f, int c) {
    const Leaf& leaf = *cells[std::size_t(c)];
    f(c) = Real(std::min(-leaf.distance, leaf.size)); // only cells at the surface are asked
  });
  heat.centre = upload<VectorField>("tool_centre", heat.cells, [&](auto& f, int c) {
    store_vector(f, c, to_vector3(cells[std::size_t(c)]->centre));
  });
  heat.heat = ScalarField("tool_heat", cells.size()), heat.out = ScalarField("tool_out", cells.size());

  fill_around(octree, cell);
  heat.tree = upload<IndexField>("tool_tree", int(octree.tree.size()), [&](auto& f, int k) {
    const int entry = octree.tree[std::size_t(k)];
    f(k) = entry >= 0 ? entry : -1 - std::max(0, cell[std::size_t(-1 - entry)]);
  });
  heat.low = {Real(octree.low.x()), Real(octree.low.y()), Real(octree.low.z())};
  heat.size = Real(octree.size), heat.finest = Real(plan.finest), heat.one_layer = octree.one_layer;
  return heat;
}

void idle_tool(const ToolHeat& heat, double time, double stable_step) {
  const double parts = std::ceil(time / stable_step);
  for (double k = 0; k < parts; ++k) conduct_tool(heat, Real(time / parts));
}

} // namespace swarf
