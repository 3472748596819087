// The tool's volume as a tree of cubes (squares of one layer in a periodic slice), fine where the work comes
// near.
#pragma once
#include "src/geometry/shape.hpp"
#include "src/tool/geometry.hpp"
#include <optional>

namespace swarf {

struct HeatPlan {
  MaterialDeck material;
  double finest = 0;                          // m, edge of the cells that the work touches
  double reach = 0;                           // m from what the work touches: no heat gets farther in the run
  std::optional<double> held_beyond;          // m from there: the temperature is held
  std::optional<std::array<double, 2>> slice; // z of a periodic slice, tool's frame: one layer of cells
  std::function<double(const Point&)> distance_to_work; // of a point of the tool, the least over the run, m
};

// Signed distances of points from the tool's surface, whatever the size of the cells that ask.
class ToolSurvey {
 public:
  ToolSurvey(const Tool& near, const FacetSurface& surface, const ToolDeck& deck, double farthest);
  struct At {
    double distance;
    Point normal;
  };
  // Exact within `radius` of the surface, else infinite with its sign.
  std::vector<At> measure(const std::vector<Point>& x, double radius) const;
  bool sees(double radius) const { return radius <= double(far.reach); }

 private:
  Tool near, far; // exact within a few spacings; within the largest cell
};

struct ToolOctree {
  enum class Kind { empty, beyond, cut, full };
  struct Leaf {
    Point centre;
    double size, distance; // m; of the centre from the tool's surface
    Kind kind;
    double share = 0; // of the volume that the tool fills
  };
  struct Face { // between leaves a and b, a not larger than b
    int a, b, axis;
    double open = 0; // share of the area that the tool fills
  };

  Point low;
  double size = 0, width = 0; // m; of the root, and of the slice
  bool one_layer = false;
  std::vector<int> tree; // as ToolHeat::tree, with leaves in place of cells
  std::vector<Leaf> leaves;

  int find(const Point& x) const; // leaf; -1 outside the root
  int directions() const { return one_layer ? 4 : 6; }
  Point beyond_face(int leaf, int direction) const; // a point just beyond the middle of a face
  std::vector<Face> faces() const;
  Point extent(double edge) const { return {edge, edge, one_layer ? width : edge}; }
  double radius(double edge) const { return 0.5 * edge * std::sqrt(one_layer ? 2.0 : 3.0); }
};

ToolOctree grow_octree(const FacetSurface& surface, const ToolSurvey& survey, const HeatPlan& plan);

// Share of a box about the origin, of edges `size` (0: a face), in which distance + normal . x <= 0: exact
// for a plane (Scardovelli & Zaleski, J. Comput. Phys. 164 (2000) 228).
double share_of_box(double distance, const Point& normal, const Point& size);

// Shares of cut leaves and of the faces between leaves; each in parts, with the surface a plane in each part.
void measure_shares(ToolOctree& octree, std::vector<ToolOctree::Face>& faces, const ToolSurvey& survey);

} // namespace swarf
