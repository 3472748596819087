// Finds the facets of a surface near a point, across a box, along a ray: a binary tree of boxes.
#pragma once
#include "src/geometry/facet_surface.hpp"
#include <Eigen/Geometry>
#include <algorithm>

namespace swarf {

class FacetTree {
 public:
  using Box = Eigen::AlignedBox3d;

  explicit FacetTree(const std::vector<Box>& of_facets) : boxes(of_facets) {
    for (int f = 0; f < int(boxes.size()); ++f) order.push_back(f);
    if (!boxes.empty()) split(0, int(boxes.size()));
  }

  const Box& box(int facet) const { return boxes[std::size_t(facet)]; }

  // Calls visit(facet) for those of the boxes that `enter` lets through, near ones first as `nearness` says.
  // enter(box) may change its mind as visits go on: a search for the nearest.
  template <class Enter, class Nearness, class Visit>
  void search(const Enter& enter, const Nearness& nearness, const Visit& visit) const {
    if (nodes.empty()) return;
    std::vector<int> open{0};
    while (!open.empty()) {
      const Node& node = nodes[std::size_t(open.back())];
      open.pop_back();
      if (!enter(node.box)) continue;
      if (node.second < 0) {
        for (int k = node.begin; k < node.end; ++k)
          if (const int f = order[std::size_t(k)]; enter(boxes[std::size_t(f)])) visit(f);
        continue;
      }
      const int first = int(&node - nodes.data()) + 1;
      const bool swap =
          nearness(nodes[std::size_t(node.second)].box) < nearness(nodes[std::size_t(first)].box);
      open.push_back(swap ? first : node.second);
      open.push_back(swap ? node.second : first);
    }
  }

 private:
  struct Node {
    Box box;
    int begin, end;  // of order
    int second = -1; // child; the first one is the next node; -1: a leaf
  };
  std::vector<Box> boxes;
  std::vector<int> order;
  std::vector<Node> nodes;

  int split(int begin, int end) {
    const int row = int(nodes.size());
    nodes.push_back({Box(), begin, end});
    Box centres;
    for (int k = begin; k < end; ++k) {
      const Box& b = boxes[std::size_t(order[std::size_t(k)])];
      nodes[std::size_t(row)].box.extend(b), centres.extend(b.center());
    }
    if (end - begin <= 4) return row;
    int axis = 0;
    centres.sizes().maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end, [&](int a, int b) {
      const double p = boxes[std::size_t(a)].center()[axis], q = boxes[std::size_t(b)].center()[axis];
      return p < q || (p == q && a < b);
    });
    split(begin, middle);
    const int second = split(middle, end);
    nodes[std::size_t(row)].second = second;
    return row;
  }
};

FacetTree make_facet_tree(const FacetSurface& surface);

} // namespace swarf
