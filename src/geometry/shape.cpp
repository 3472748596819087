#include "src/geometry/shape.hpp"
#include "src/geometry/body_file.hpp"
#include "src/geometry/memory.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <numbers>
#include <unistd.h>

namespace swarf {

using std::numbers::pi;

void reject(const Deck& deck, const BodyDeck& body, const std::string& key, const std::string& text) {
  throw DeckError(fmt::format("{}:{}: body.{}: \"{}\" {}.", deck.file, body.line, key, body.name, text));
}

namespace {

constexpr double pi_2 = 0.5 * pi;
constexpr double index_limit = std::numeric_limits<int>::max() / 8; // 8 corners of a hex

double sector(const BodyDeck& b) { return b.end_angle - b.start_angle; }

// Extents along the directions of the lattice, m.
Triple extents(const Deck& deck, const BodyDeck& b) {
  if (b.has_file()) {
    const Point size = read_body_file(deck, b)->box.sizes();
    return {size.x(), size.y(), size.z()};
  }
  if (b.shape == BodyShape::block) return b.size;
  if (b.shape == BodyShape::ring)
    return {sector(b) * 0.5 * (b.inner_radius + b.outer_radius), b.height, b.outer_radius - b.inner_radius};
  if (b.shape == BodyShape::cylinder) return {2 * b.radius, b.height, 2 * b.radius};
  if (b.fill == Fill::particles) return {2 * b.outer_radius, 2 * b.outer_radius, 2 * b.outer_radius};
  const double edge = pi_2 * 0.5 * (b.inner_radius + b.outer_radius);
  return {edge, edge, b.outer_radius - b.inner_radius};
}

} // namespace

Triple find_cells(const Deck& deck, const BodyDeck& b) {
  Triple n{};
  if (b.shape == BodyShape::mesh) {
    const auto file = read_body_file(deck, b);
    return {double(std::max(file->points.position.size(), file->hexes.hex.size())), 1, 1};
  }
  if (b.cells) {
    for (int d = 0; d < 3; ++d) n[d] = (*b.cells)[d];
    if (b.shape == BodyShape::cylinder) {
      if (n[0] != n[1])
        reject(deck, b, "cells",
               "needs equal counts in both directions across the axis. Give [across, axial]");
      n = {n[0], n[2], n[0]};
    }
    return n;
  }
  const Triple size = extents(deck, b);
  for (int d = 0; d < 3; ++d) {
    n[d] = std::round(size[d] / *b.spacing);
    if (n[d] < 1)
      reject(deck, b, "spacing",
             fmt::format("holds not one cell: expected at most its least extent of {:.6g} m, got {:.6g} m. "
                         "Make it smaller",
                         *std::min_element(size.begin(), size.end()), *b.spacing));
  }
  return n;
}

namespace {

double cells_of(const Deck& deck, const BodyDeck& b, const Triple& n) {
  if (b.shape == BodyShape::stl) {
    const auto file = read_body_file(deck, b);
    return n[0] * n[1] * n[2] * file->volume / file->box.volume();
  }
  if (b.shape == BodyShape::cylinder)
    return b.fill == Fill::particles ? pi / 4 * n[0] * n[0] * n[1] : n[0] * n[0] * n[1];
  if (b.shape == BodyShape::sphere) {
    if (b.fill == Fill::hexes) return 6 * n[0] * n[1] * n[2];
    const double hollow = b.inner_radius / b.outer_radius;
    return pi / 6 * n[0] * n[0] * n[0] * (1 - hollow * hollow * hollow);
  }
  return n[0] * n[1] * n[2];
}

void check_meshable(const Deck& deck, const BodyDeck& b, const Triple& n) {
  if (b.fill != Fill::hexes) return;
  if (b.shape == BodyShape::sphere && !(b.inner_radius > 0))
    reject(deck, b, "inner_radius",
           "is solid, which hexes cannot fill: expected more than 0 m. Make it hollow, or fill it with "
           "particles");
  if (b.shape == BodyShape::cylinder && n[0] < 3)
    reject(deck, b, b.cells ? "cells" : "spacing",
           fmt::format("expected at least 3 hexes across the cylinder, got {:.0f}. Make the hexes smaller",
                       n[0]));
  if (b.shape == BodyShape::ring && sector(b) >= pi && n[0] < 3)
    reject(
        deck, b, b.cells ? "cells" : "spacing",
        fmt::format("expected at least 3 hexes around the ring, got {:.0f}. Make the hexes smaller", n[0]));
}

// Kernels are round: along the long edges particles would not see each other, across they would see
// thousands.
void check_cell_shape(const Deck& deck, const BodyDeck& body, const Triple& n) {
  if (body.shape == BodyShape::mesh) return;
  Triple edge = extents(deck, body);
  for (std::size_t d = 0; d < 3; ++d) edge[d] /= n[d];
  const double most = body.fill == Fill::particles ? 100 : 1000;
  const auto [least, largest] = std::minmax_element(edge.begin(), edge.end());
  if (*largest <= most * *least) return;
  reject(
      deck, body, body.cells ? "cells" : "spacing",
      fmt::format(
          "makes cells of {:.3g} m by {:.3g} m by {:.3g} m: expected edges of which none is more than {:.0f} "
          "times another. Look at the units of its sizes, or change the counts",
          edge[0], edge[1], edge[2], most));
}

} // namespace

double count_cells(const Deck& deck, const BodyDeck& body) {
  return cells_of(deck, body, find_cells(deck, body));
}

std::array<Triple, 2> find_box(const Deck& deck, const BodyDeck& b) {
  const auto around = [&](double radius, double low, double high) -> std::array<Triple, 2> {
    return {{{b.origin[0] - radius, b.origin[1] - radius, b.origin[2] + low},
             {b.origin[0] + radius, b.origin[1] + radius, b.origin[2] + high}}};
  };
  if (b.has_file()) {
    const Eigen::AlignedBox3d box = read_body_file(deck, b)->box;
    return {{{box.min().x(), box.min().y(), box.min().z()}, {box.max().x(), box.max().y(), box.max().z()}}};
  }
  if (b.shape == BodyShape::block)
    return {{b.origin, {b.origin[0] + b.size[0], b.origin[1] + b.size[1], b.origin[2] + b.size[2]}}};
  if (b.shape == BodyShape::sphere) return around(b.outer_radius, -b.outer_radius, b.outer_radius);
  return around(b.shape == BodyShape::cylinder ? b.radius : b.outer_radius, 0, b.height);
}

// Of the machine, or what its administrator leaves to this group of processes.
double machine_memory() {
  const double all = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
  double granted = all;
  std::ifstream limit("/sys/fs/cgroup/memory.max"); // "max" where there is none
  if (double bytes = 0; limit >> bytes) granted = bytes;
  return std::min(all, granted);
}

void check_memory(const Deck& deck) {
  double sum = 0;
  std::string parts;
  const auto gib = [](double bytes) { return bytes / (1 << 30); };
  for (const BodyDeck& body : deck.bodies) {
    const double bytes = count_cells(deck, body) * bytes_per_cell;
    sum += bytes;
    parts += fmt::format("{}\"{}\" {:.3g}", parts.empty() ? "" : ", ", body.name, gib(bytes));
  }
  if (sum < machine_memory() && sum / bytes_per_cell < index_limit) return;
  const BodyDeck& largest =
      *std::max_element(deck.bodies.begin(), deck.bodies.end(), [&](const BodyDeck& a, const BodyDeck& b) {
        return count_cells(deck, a) < count_cells(deck, b);
      });
  reject(deck, largest, largest.cells ? "cells" : "spacing",
         fmt::format(
             "and the other bodies make {:.4g} cells, which need about {:.3g} GiB ({}): expected what fits "
             "into the {:.3g} GiB of this machine. Make the cells larger or the bodies smaller",
             sum / bytes_per_cell, gib(sum), parts, gib(machine_memory())));
}

Shape make_shape(const Deck& deck, const BodyDeck& body) {
  const Triple n = find_cells(deck, body);
  check_meshable(deck, body, n);
  check_cell_shape(deck, body, n);
  const double count = cells_of(deck, body, n);
  const double memory = machine_memory();
  const double looked_at = body.shape == BodyShape::stl ? n[0] * n[1] * n[2] : count;
  if (!(count < index_limit && looked_at < index_limit && count * bytes_per_cell < memory))
    reject(
        deck, body, body.cells ? "cells" : "spacing",
        fmt::format("makes {:.4g} {}, which need {:.3g} GiB: expected what fits into the {:.3g} GiB of this "
                    "machine. Make the cells larger or the body smaller",
                    count, word_of(body.fill), count * bytes_per_cell / (1 << 30), memory / (1 << 30)));
  Shape shape;
  shape.deck = &deck, shape.body = &body;
  if (body.has_file()) shape.file = read_body_file(deck, body);
  for (int d = 0; d < 3; ++d) shape.cells[d] = int(n[d]);
  if (body.shape != BodyShape::ring) return shape;

  shape.closed = sector(body) > 2 * pi * (1 - 1e-12);
  shape.inner = [radius = body.inner_radius](double, double) { return radius; };
  shape.inner_least = body.inner_radius;
  if (!body.previous_tooth) return shape;
  if (!deck.tool || deck.tool->kind != ToolKind::end_mill)
    reject(deck, body, "previous_tooth", "needs a tool of kind \"end_mill\"");
  shape.inner = previous_tooth_surface(*deck.tool, body.origin);
  double most = 0;
  for (int i = 0; i <= shape.cells[0]; ++i)
    for (int j = 0; j <= shape.cells[1]; ++j) {
      const double r = shape.inner(body.start_angle + sector(body) * i / shape.cells[0],
                                   body.origin[2] + body.height * j / shape.cells[1]);
      shape.inner_least = i + j == 0 ? r : std::min(shape.inner_least, r);
      most = std::max(most, r);
    }
  if (!(shape.inner_least > 0 && most < body.outer_radius)) // also NaN: the ring's axis lies outside the tool
    reject(deck, body, "previous_tooth",
           fmt::format(
               "has an outer_radius of {:.6g} m: expected more than {:.6g} m, how far the previous tooth "
               "cut. Move the tool or enlarge the ring",
               body.outer_radius, most));
  return shape;
}

double Shape::volume() const {
  const BodyDeck& b = *body;
  if (file) return file->volume;
  const auto cube = [](double r) { return r * r * r; };
  if (b.shape == BodyShape::block) return b.size[0] * b.size[1] * b.size[2];
  if (b.shape == BodyShape::cylinder) return pi * b.radius * b.radius * b.height;
  if (b.shape == BodyShape::sphere) return 4.0 / 3.0 * pi * (cube(b.outer_radius) - cube(b.inner_radius));
  return 0.5 * sector(b) * (b.outer_radius - b.inner_radius) * (b.outer_radius + b.inner_radius) * b.height;
}

double Shape::signed_distance(const Point& x) const {
  if (file) return file->signed_distance(x);
  const BodyDeck& b = *body;
  const Point r = x - Point(b.origin[0], b.origin[1], b.origin[2]);
  if (b.shape == BodyShape::block) {
    double distance = -std::numeric_limits<double>::infinity();
    for (int d = 0; d < 3; ++d) distance = std::max({distance, -r[d], r[d] - b.size[d]});
    return distance;
  }
  if (b.shape == BodyShape::sphere) {
    const double outside = r.norm() - b.outer_radius;
    return b.inner_radius > 0 ? std::max(outside, b.inner_radius - r.norm()) : outside;
  }
  const double radius = std::hypot(r.x(), r.y());
  const double along = std::max(-r.z(), r.z() - b.height);
  if (b.shape == BodyShape::cylinder) return std::max(along, radius - b.radius);
  const double angle = std::atan2(r.y(), r.x());
  // The inner surface costs an iteration, and cannot matter outside.
  const double outside = radius - b.outer_radius;
  const double radial = outside > 0 ? outside : std::max(outside, inner(angle, x.z()) - radius);
  if (closed) return std::max(along, radial);
  const double middle = 0.5 * (b.start_angle + b.end_angle);
  const double from_end = std::abs(std::remainder(angle - middle, 2 * pi)) - 0.5 * sector(b);
  const double around = radius * std::sin(std::clamp(from_end, -pi_2, pi_2));
  return std::max({along, radial, around});
}

std::array<std::array<std::string, 2>, 3> Shape::face_names() const {
  if (body->shape == BodyShape::mesh) return {};
  if (body->shape == BodyShape::block || body->shape == BodyShape::stl)
    return {{{"x_min", "x_max"}, {"y_min", "y_max"}, {"z_min", "z_max"}}};
  if (body->shape == BodyShape::cylinder) return {{{"", ""}, {"bottom", "top"}, {"", "side"}}};
  if (body->shape == BodyShape::sphere) return {{{"", ""}, {"", ""}, {"inner", "outer"}}};
  if (closed) return {{{"", ""}, {"bottom", "top"}, {"inner", "outer"}}};
  return {{{"start", "end"}, {"bottom", "top"}, {"inner", "outer"}}};
}

bool Shape::is_plane(const std::string& face) const {
  return !file && face != "inner" && face != "outer" && face != "side";
}

Plane Shape::plane(const std::string& face) const {
  const BodyDeck& b = *body;
  const Point origin(b.origin[0], b.origin[1], b.origin[2]);
  const auto at = [](const Point& normal, const Point& x) { return Plane{normal, normal.dot(x)}; };
  if (face == "start") return at({-std::sin(b.start_angle), std::cos(b.start_angle), 0}, origin);
  if (face == "end") return at({std::sin(b.end_angle), -std::cos(b.end_angle), 0}, origin);
  if (face == "bottom") return at(Point::UnitZ(), origin);
  if (face == "top") return at(-Point::UnitZ(), origin + b.height * Point::UnitZ());
  if (!is_plane(face)) throw std::out_of_range(face);
  const int d = face[0] - 'x';
  const Point along = Point::Unit(d);
  return face.substr(2) == "min" ? at(along, origin) : at(-along, origin + b.size[d] * along);
}

} // namespace swarf
