#include "src/tool/octree.hpp"
#include "src/geometry/upload.hpp"
#include "swarf/kernels.hpp"
#include <algorithm>
#include <cmath>

namespace swarf {

ToolSurvey::ToolSurvey(const Tool& tool, const FacetSurface& surface, const ToolDeck& deck, double farthest)
    : near(tool), far(farthest > double(tool.reach) ? build_tool(surface, deck, farthest) : tool) {}

std::vector<ToolSurvey::At> ToolSurvey::measure(const std::vector<Point>& x, double radius) const {
  const VectorField points = upload<VectorField>("points", int(x.size()), [&](auto& f, int i) {
    for (int d = 0; d < 3; ++d) f(i, d) = Real(x[std::size_t(i)][d]);
  });
  const auto found = host_copy(distance_to_tool(radius <= double(near.reach) ? near : far, points));
  std::vector<At> all;
  for (int i = 0; i < int(x.size()); ++i)
    all.push_back(
        {double(found(i, 0)), Point(double(found(i, 1)), double(found(i, 2)), double(found(i, 3)))});
  return all;
}

int ToolOctree::find(const Point& x) const {
  Point from = low;
  double half = 0.5 * size;
  for (int d = 0; d < (one_layer ? 2 : 3); ++d)
    if (!(x[d] >= low[d] && x[d] < low[d] + size)) return -1;
  int node = 0;
  for (; tree[std::size_t(node)] >= 0; half *= 0.5) {
    int child = tree[std::size_t(node)];
    for (int d = 0; d < (one_layer ? 2 : 3); ++d)
      if (x[d] >= from[d] + half) child += 1 << d, from[d] += half;
    node = child;
  }
  return -1 - tree[std::size_t(node)];
}

Point ToolOctree::beyond_face(int leaf, int direction) const {
  const Leaf& l = leaves[std::size_t(leaf)];
  Point x = l.centre;
  x[direction / 2] += (direction % 2 ? 0.501 : -0.501) * l.size;
  return x;
}

std::vector<ToolOctree::Face> ToolOctree::faces() const {
  const auto holds = [&](int leaf) { return leaf >= 0 && leaves[std::size_t(leaf)].kind >= Kind::cut; };
  std::vector<Face> all;
  for (int a = 0; a < int(leaves.size()); ++a)
    for (int direction = 0; holds(a) && direction < directions(); ++direction) {
      const int b = find(beyond_face(a, direction));
      if (!holds(b)) continue;
      const double own = leaves[std::size_t(a)].size, other = leaves[std::size_t(b)].size;
      if (other > 1.5 * own || (other > 0.75 * own && direction % 2)) all.push_back({a, b, direction / 2});
    }
  return all;
}

namespace {

struct Node {
  int row;
  Point centre;
  double size, to_work;
};

class Grower {
 public:
  Grower(ToolOctree& into, const ToolSurvey& with, const HeatPlan& by)
      : octree(into), survey(with), plan(by) {}

  void grow() {
    octree.tree.assign(1, 0);
    Point centre = octree.low + 0.5 * Point(octree.size, octree.size, octree.size);
    if (octree.one_layer) centre.z() = 0.5 * ((*plan.slice)[0] + (*plan.slice)[1]);
    std::vector<Node> level{{0, centre, octree.size, plan.distance_to_work(centre)}};
    while (!level.empty()) level = refine(level);
  }

 private:
  ToolOctree& octree;
  const ToolSurvey& survey;
  const HeatPlan& plan;

  void end(const Node& node, double distance, ToolOctree::Kind kind) {
    octree.tree[std::size_t(node.row)] = -1 - int(octree.leaves.size());
    octree.leaves.push_back({node.centre, node.size, distance, kind});
  }

  void split(const Node& node, std::vector<Node>& next) {
    const int children = octree.one_layer ? 4 : 8;
    octree.tree[std::size_t(node.row)] = int(octree.tree.size());
    for (int k = 0; k < children; ++k) {
      Point centre = node.centre;
      for (int d = 0; d < (octree.one_layer ? 2 : 3); ++d)
        centre[d] += (k >> d & 1 ? 0.25 : -0.25) * node.size;
      next.push_back({int(octree.tree.size()), centre, 0.5 * node.size, plan.distance_to_work(centre)});
      octree.tree.push_back(0);
    }
  }

  // Edges of a quarter of the distance from the work keep neighbours within a factor of two.
  std::vector<Node> refine(const std::vector<Node>& level) {
    const double size = level.front().size, radius = octree.radius(size);
    const bool sees = survey.sees(radius);
    std::vector<Point> centres;
    for (const Node& node : level) centres.push_back(node.centre);
    const auto at = sees ? survey.measure(centres, radius) : std::vector<ToolSurvey::At>(level.size());
    std::vector<Node> next;
    for (std::size_t k = 0; k < level.size(); ++k) {
      const Node& node = level[k];
      const double nearest = node.to_work - radius, distance = at[k].distance;
      if (nearest > plan.reach)
        end(node, distance, ToolOctree::Kind::beyond);
      else if (sees && distance > radius)
        end(node, distance, ToolOctree::Kind::empty);
      else if (!sees || size > std::max(plan.finest, nearest / 4) * (1 + 1e-9))
        split(node, next);
      else
        end(node, distance, distance < -radius ? ToolOctree::Kind::full : ToolOctree::Kind::cut);
    }
    return next;
  }
};

} // namespace

// Lattice planes pass through the tool's origin, where a wall has its face and a wedge its edge.
ToolOctree grow_octree(const FacetSurface& surface, const ToolSurvey& survey, const HeatPlan& plan) {
  Point low = Point::Constant(1e300), high = -low;
  for (const Triple& v : surface.vertices)
    for (int d = 0; d < 3; ++d) low[d] = std::min(low[d], v[d]), high[d] = std::max(high[d], v[d]);
  ToolOctree octree;
  octree.one_layer = plan.slice.has_value();
  if (octree.one_layer) octree.width = (*plan.slice)[1] - (*plan.slice)[0];
  octree.size = plan.finest;
  for (int d = 0; d < 3; ++d) {
    octree.low[d] = plan.finest * std::floor(low[d] / plan.finest);
    while (d < (octree.one_layer ? 2 : 3) && octree.low[d] + octree.size < high[d]) octree.size *= 2;
  }
  Grower(octree, survey, plan).grow();
  return octree;
}

} // namespace swarf
