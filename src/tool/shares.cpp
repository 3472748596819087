// How much of each cell, and of each face between cells, the tool fills.
#include "src/tool/octree.hpp"
#include <algorithm>
#include <cmath>

namespace swarf {
namespace {

// Share of a unit cube where m . x <= a, all m >= 0 with sum 1 and a <= 1/2.
double share_of_cube(std::array<double, 3> m, double a) {
  std::sort(m.begin(), m.end());
  for (double& x : m) x = x < 1e-7 ? 0 : x; // a slope that no corner sees
  const auto [m1, m2, m3] = m;
  const double m12 = m1 + m2;
  const double first = m1 > 0 ? m1 * m1 / (6 * m2 * m3) : 0;
  if (a < m1) return a * a * a / (6 * m1 * m2 * m3);
  if (a < m2) return a * (a - m1) / (2 * m2 * m3) + first;
  if (a >= m12 && m12 <= m3) return (2 * a - m12) / (2 * m3);
  double cubes = a * a * (3 * m12 - a) + m1 * m1 * (m1 - 3 * a) + m2 * m2 * (m2 - 3 * a);
  if (a >= m3)
    cubes = a * a * (3 - 2 * a) + m1 * m1 * (m1 - 3 * a) + m2 * m2 * (m2 - 3 * a) + m3 * m3 * (m3 - 3 * a);
  return cubes / (6 * m1 * m2 * m3);
}

constexpr int parts = 3; // along each edge of a cell

struct Box {
  Point centre, size;
};

// The parts of a box; flat ones are not cut along their normal, nor layers along z.
std::vector<Box> divide(const Box& box, bool one_layer) {
  std::vector<Box> all;
  int n[3];
  for (int d = 0; d < 3; ++d) n[d] = box.size[d] == 0 || (one_layer && d == 2) ? 1 : parts;
  const Point size(box.size.x() / n[0], box.size.y() / n[1], box.size.z() / n[2]);
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
        all.push_back({box.centre - 0.5 * box.size +
                           Point((i + 0.5) * size.x(), (j + 0.5) * size.y(), (k + 0.5) * size.z()),
                       size});
  return all;
}

// Shares of boxes of one size.
std::vector<double> shares_of(const std::vector<Box>& boxes, double radius, const ToolOctree& octree,
                              const ToolSurvey& survey) {
  std::vector<Box> all;
  for (const Box& box : boxes)
    for (const Box& part : divide(box, octree.one_layer)) all.push_back(part);
  std::vector<Point> centres;
  for (const Box& part : all) centres.push_back(part.centre);
  const auto at = survey.measure(centres, radius);
  const std::size_t each = boxes.empty() ? 1 : all.size() / boxes.size();
  std::vector<double> shares(boxes.size(), 0);
  for (std::size_t k = 0; k < all.size(); ++k)
    shares[k / each] += share_of_box(at[k].distance, at[k].normal, all[k].size) / double(each);
  return shares;
}

template <class Rows, class SizeOf>
std::vector<double> sizes_of(const Rows& rows, const SizeOf& size_of) {
  std::vector<double> sizes;
  for (const auto& row : rows) sizes.push_back(size_of(row));
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

} // namespace

double share_of_box(double distance, const Point& normal, const Point& size) {
  if (std::isinf(distance)) return distance < 0 ? 1 : 0;
  std::array<double, 3> m;
  double sum = 0;
  for (int d = 0; d < 3; ++d) sum += m[std::size_t(d)] = std::abs(normal[d]) * size[d];
  if (sum == 0) return distance < 0 ? 1 : 0;
  const double a = 0.5 - distance / sum; // of the way from the box's deepest corner to its highest
  if (a <= 0) return 0;
  if (a >= 1) return 1;
  for (double& x : m) x /= sum;
  return a <= 0.5 ? share_of_cube(m, a) : 1 - share_of_cube(m, 1 - a);
}

void measure_shares(ToolOctree& octree, std::vector<ToolOctree::Face>& faces, const ToolSurvey& survey) {
  using Kind = ToolOctree::Kind;
  for (ToolOctree::Leaf& leaf : octree.leaves) leaf.share = leaf.kind == Kind::full ? 1 : 0;
  for (const double size : sizes_of(octree.leaves, [](const auto& l) { return l.size; })) {
    std::vector<std::size_t> rows;
    std::vector<Box> boxes;
    for (std::size_t k = 0; k < octree.leaves.size(); ++k)
      if (octree.leaves[k].kind == Kind::cut && octree.leaves[k].size == size)
        rows.push_back(k), boxes.push_back({octree.leaves[k].centre, octree.extent(size)});
    const auto shares = shares_of(boxes, octree.radius(size), octree, survey);
    for (std::size_t k = 0; k < rows.size(); ++k) octree.leaves[rows[k]].share = shares[k];
  }
  const auto size_of = [&](const auto& f) { return octree.leaves[std::size_t(f.a)].size; };
  for (const double size : sizes_of(faces, size_of)) {
    std::vector<std::size_t> rows;
    std::vector<Box> boxes;
    for (std::size_t k = 0; k < faces.size(); ++k) {
      ToolOctree::Face& f = faces[k];
      const auto &a = octree.leaves[std::size_t(f.a)], &b = octree.leaves[std::size_t(f.b)];
      if (a.size != size) continue;
      f.open = 1;
      if (a.kind == Kind::full || b.kind == Kind::full) continue;
      Box box{a.centre, octree.extent(size)};
      box.centre[f.axis] += (b.centre[f.axis] > a.centre[f.axis] ? 0.5 : -0.5) * size, box.size[f.axis] = 0;
      rows.push_back(k), boxes.push_back(box);
    }
    const auto shares = shares_of(boxes, octree.radius(size), octree, survey);
    for (std::size_t k = 0; k < rows.size(); ++k) faces[rows[k]].open = shares[k];
  }
}

} // namespace swarf
