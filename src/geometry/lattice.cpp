#include "src/geometry/body_file.hpp"
#include <cmath>
#include <numbers>

namespace swarf {
namespace {

using std::numbers::pi;
using Index = std::array<int, 3>;

struct Cell {
  Point centre{0, 0, 0};
  double volume = 0, gap = 0;
  bool inside = true; // cubic cells of a sphere or an stl may lie outside
};

// The lattice of a shape, defined for cells outside it as well.
class Cells {
 public:
  explicit Cells(const Shape& s)
      : shape(s), body(*s.body), origin(body.origin[0], body.origin[1], body.origin[2]) {}

  // Directions: block, sphere x, y, z; ring around, axial, radial; cylinder around, axial, radial.
  Index count() const {
    const Index n = shape.cells;
    return round() ? Index{0, n[1], (n[0] + 1) / 2} : n;
  }
  int count_around(int radial) const { // of a cylinder
    if (odd() && radial == 0) return 1;
    return int(std::lround(pi * (edge(radial) + edge(radial + 1)) / (2 * body.radius / shape.cells[0])));
  }
  bool round() const { return body.shape == BodyShape::cylinder; }
  Cell cell(const Index& i) const {
    if (body.shape == BodyShape::block) return cubic(i, {body.size[0], body.size[1], body.size[2]}, origin);
    if (body.shape == BodyShape::ring) return polar(i);
    if (round()) return concentric(i);
    if (shape.file) {
      Cell c = cubic(i, shape.file->box.sizes(), shape.file->box.min());
      c.inside = shape.signed_distance(c.centre) < 0;
      return c;
    }
    const double R = body.outer_radius;
    Cell c = cubic(i, {2 * R, 2 * R, 2 * R}, origin - Point(R, R, R));
    const double r = (c.centre - origin).norm();
    c.inside = r < R && r >= body.inner_radius;
    return c;
  }

 private:
  const Shape& shape;
  const BodyDeck& body;
  Point origin;

  bool odd() const { return shape.cells[0] % 2 == 1; }
  double edge(int radial) const { // inner radius of ring `radial` of a cylinder
    return std::max(0.0, (radial - (odd() ? 0.5 : 0.0)) * 2 * body.radius / shape.cells[0]);
  }
  Cell cubic(const Index& i, const Point& size, const Point& corner) const {
    const Point pitch(size.x() / shape.cells[0], size.y() / shape.cells[1], size.z() / shape.cells[2]);
    const Point centre((i[0] + 0.5) * pitch.x(), (i[1] + 0.5) * pitch.y(), (i[2] + 0.5) * pitch.z());
    return {corner + centre, pitch.prod(), 0.5 * pitch.minCoeff(), true};
  }
  Cell polar(const Index& i) const {
    const double da = (body.end_angle - body.start_angle) / shape.cells[0], dz = body.height / shape.cells[1];
    const double band = body.outer_radius - body.inner_radius, dr = band / shape.cells[2];
    const double angle = body.start_angle + (i[0] + 0.5) * da, z = (i[1] + 0.5) * dz;
    const double shift = shape.inner(angle, origin.z() + z) - body.inner_radius;
    // The previous tooth moves the inner surface; the shift fades out linearly to the outer one.
    const auto moved = [&](int k) {
      const double r = body.inner_radius + k * dr;
      return r + shift * std::clamp((body.outer_radius - r) / band, 0.0, 1.0);
    };
    const double low = moved(i[2]), high = moved(i[2] + 1), r = 0.5 * (low + high);
    const Point centre = origin + Point(r * std::cos(angle), r * std::sin(angle), z);
    return {centre, r * (high - low) * da * dz, 0.5 * (high - low), low >= 0};
  }
  Cell concentric(const Index& i) const {
    const double dz = body.height / shape.cells[1], low = edge(i[2]), high = edge(i[2] + 1);
    const int around = count_around(i[2]);
    // Rings are turned by the golden ratio, so that their cells do not line up into rays.
    const double turn = 0.6180339887498949 * i[2];
    const double angle = 2 * pi * ((i[0] + 0.5) / around + turn - std::floor(turn));
    const double r = around == 1 ? 0 : 0.5 * (low + high);
    const Point centre = origin + Point(r * std::cos(angle), r * std::sin(angle), (i[1] + 0.5) * dz);
    const double pitch = 2 * body.radius / shape.cells[0];
    return {centre, pi * (high - low) * (high + low) / around * dz, 0.5 * std::min(pitch, dz), true};
  }
};

// Calls visit(index, cell) for cells up to `layers` around the shape, around (the first direction) slowest.
template <class Visit>
void visit_cells(const Shape& shape, int layers, Visit&& visit) {
  const Cells cells(shape);
  const Index n = cells.count();
  const int l0 = shape.closed ? 0 : layers;
  if (cells.round()) {
    for (int k = 0; k < n[2] + layers; ++k)
      for (int i = 0; i < cells.count_around(k); ++i)
        for (int j = -layers; j < n[1] + layers; ++j) visit(Index{i, j, k}, cells.cell({i, j, k}));
    return;
  }
  for (int i = -l0; i < n[0] + l0; ++i)
    for (int j = -layers; j < n[1] + layers; ++j)
      for (int k = -layers; k < n[2] + layers; ++k) visit(Index{i, j, k}, cells.cell({i, j, k}));
}

bool within(const Shape& shape, const Index& i) {
  const Index n = Cells(shape).count();
  const bool first = shape.body->shape == BodyShape::cylinder || (i[0] >= 0 && i[0] < n[0]);
  return first && i[1] >= 0 && i[1] < n[1] && i[2] >= 0 && i[2] < n[2];
}

void mark_faces(PointSet& set, const Shape& shape, const Index& i, const Point& x) {
  const int row = int(set.position.size());
  const auto names = shape.face_names();
  if (shape.body->shape == BodyShape::sphere) {
    const double pitch = 2 * shape.body->outer_radius / shape.cells[0];
    const Point centre(shape.body->origin[0], shape.body->origin[1], shape.body->origin[2]);
    const double r = (x - centre).norm();
    if (r > shape.body->outer_radius - pitch)
      set.faces["outer"].push_back(row), set.behind["outer"].push_back(-1);
    if (r < shape.body->inner_radius + pitch)
      set.faces["inner"].push_back(row), set.behind["inner"].push_back(-1);
    return;
  }
  const Index n = Cells(shape).count();
  // In the order of visit_cells. Rings of a cylinder have different numbers of cells.
  const bool round = shape.body->shape == BodyShape::cylinder;
  const Index stride = round ? Index{0, 1, 0} : Index{n[1] * n[2], n[2], 1};
  for (int d = 0; d < 3; ++d)
    for (const bool high : {false, true}) {
      const std::string& name = names[d][high];
      if (name.empty() || i[d] != (high ? n[d] - 1 : 0)) continue;
      const bool has_next = stride[d] > 0 && n[d] >= 3;
      set.faces[name].push_back(row);
      set.behind[name].push_back(has_next ? row + (high ? -stride[d] : stride[d]) : -1);
    }
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (double v : values) total += v;
  return total;
}

} // namespace

PointSet fill_points(const Shape& shape) {
  if (shape.body->shape == BodyShape::stl) return fill_points_of_stl(shape);
  if (shape.body->shape == BodyShape::mesh) return fill_points_of_mesh(shape);
  PointSet set;
  visit_cells(shape, 0, [&](const Index& i, const Cell& c) {
    if (!c.inside) return;
    mark_faces(set, shape, i, c.centre);
    set.position.push_back(c.centre), set.volume.push_back(c.volume), set.gap.push_back(c.gap);
  });
  if (set.position.empty()) return set;
  if (shape.body->shape == BodyShape::sphere) {
    const double scale = shape.volume() / sum(set.volume);
    for (double& v : set.volume) v *= scale;
  }
  set.spacing = std::cbrt(sum(set.volume) / double(set.volume.size()));
  return set;
}

PointSet continue_points(const Shape& shape, int layers) {
  if (shape.body->shape == BodyShape::mesh) return continue_points_of_mesh(shape, layers);
  PointSet set;
  const bool clipped = shape.body->shape == BodyShape::sphere || shape.body->shape == BodyShape::stl;
  visit_cells(shape, layers, [&](const Index& i, const Cell& c) {
    const bool own = clipped ? c.inside : within(shape, i);
    if (own || (!clipped && !c.inside)) return;
    set.position.push_back(c.centre), set.volume.push_back(c.volume);
  });
  return set;
}

} // namespace swarf
