#include "src/scene/faces.hpp"
#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace swarf {
namespace {

using Eigen::Matrix3d;

struct RigidMap {
  Matrix3d R = Matrix3d::Identity();
  Point t{0, 0, 0};
  Point operator()(const Point& x) const { return R * x + t; }
};

Transform to_transform(const RigidMap& map) {
  const Matrix3d& R = map.R;
  return {{Real(R(0, 0)), Real(R(0, 1)), Real(R(0, 2)), Real(R(1, 0)), Real(R(1, 1)), Real(R(1, 2)),
           Real(R(2, 0)), Real(R(2, 1)), Real(R(2, 2))},
          to_vector3(map.t)};
}

Point origin_of(const BodyDeck& b) { return {b.origin[0], b.origin[1], b.origin[2]}; }

const FaceDeck* find_face(const BodyDeck& body, const std::string& name, FaceKind kind) {
  for (const FaceDeck& face : body.faces)
    if (face.face == name && face.kind == kind) return &face;
  return nullptr;
}

// From the low face of a direction to the high one.
RigidMap period(const Shape& shape, const std::string& low, const std::string& high) {
  const Plane from = shape.plane(low), to = shape.plane(high);
  RigidMap map;
  if (low == "start") {
    const Point centre = origin_of(*shape.body);
    map.R = Eigen::AngleAxisd(shape.body->end_angle - shape.body->start_angle, Point::UnitZ()).matrix();
    map.t = centre - map.R * centre;
  } else {
    map.t = (-to.offset - from.offset) * from.normal;
  }
  return map;
}

RigidMap mirror(const Plane& plane) {
  return {Matrix3d::Identity() - 2 * plane.normal * plane.normal.transpose(),
          2 * plane.offset * plane.normal};
}

GhostPlane make_ghost_plane(const Plane& plane, const RigidMap& to_ghost, bool periodic, bool active) {
  return {to_vector3(plane.normal), Real(plane.offset), to_transform(to_ghost), periodic, active};
}

// Least distance between a particle and its ghost.
double slice_thickness(const Shape& shape, const std::string& low, const std::string& high) {
  if (low != "start") return std::abs(-shape.plane(high).offset - shape.plane(low).offset);
  return 2 * shape.inner_least * std::sin(0.5 * (shape.body->end_angle - shape.body->start_angle));
}

class Collector {
 public:
  Collector(const Deck& scene, const std::vector<FilledBody>& filled, double range)
      : deck(scene), bodies(filled), cutoff(range) {}

  Faces collect() {
    std::size_t particles = 0, nodes = 0;
    for (const FilledBody& b : bodies) particles += b.points.position.size(), nodes += b.hexes.node.size();
    faces.particle_bits.assign(particles, 0), faces.particle_host.assign(particles, -1);
    faces.node_bits.assign(nodes, 0);
    faces.heated_bits.assign(particles, 0);
    for (const FilledBody& b : bodies) {
      hold_faces(b);
      heat_faces(b);
      for (const auto& [low, high] : b.shape.face_names())
        b.has_particles() || b.deck->converts() ? add_planes(b, low, high) : void();
      if (!b.has_particles()) couple_faces(b);
    }
    let_rows_follow();
    check_tied_faces();
    check_all_inside();
    return std::move(faces);
  }

 private:
  const Deck& deck;
  const std::vector<FilledBody>& bodies;
  double cutoff;
  Faces faces;

  unsigned bit_of(const FilledBody& body, const FaceDeck& face, const Constraint& row) {
    auto& rows = faces.constraints;
    const auto same = [&](const Constraint& c) {
      const auto equal = [](const Vector3& a, const Vector3& b) {
        return a.x == b.x && a.y == b.y && a.z == b.z;
      };
      return c.all == row.all && equal(c.velocity, row.velocity) && (c.all || equal(c.normal, row.normal));
    };
    const auto at = std::find_if(rows.begin(), rows.end(), same);
    const std::size_t bit = std::size_t(at - rows.begin());
    if (at == rows.end()) rows.push_back(row);
    if (bit >= 28) // the others say what a particle does
      reject(
          deck, *body.deck, "faces." + face.face,
          "is the 29th different hold: expected at most 28. Hold fewer faces, or give them equal velocities");
    return 1u << bit;
  }

  void hold_faces(const FilledBody& body) {
    for (const FaceDeck& face : body.deck->faces) {
      const bool all = face.kind == FaceKind::fixed || face.kind == FaceKind::velocity;
      if (!all && (body.has_particles() || face.kind != FaceKind::symmetric)) continue;
      if (!all && !body.shape.is_plane(face.face))
        reject(deck, *body.deck, "faces." + face.face,
               "must be plane to be symmetric. Use \"fixed\" or a velocity");
      Constraint row;
      row.all = all;
      row.velocity = to_vector3(face.kind == FaceKind::velocity ? face.velocity : Triple{});
      if (!all) row.normal = to_vector3(body.shape.plane(face.face).normal);
      const unsigned bit = bit_of(body, face, row);
      const FaceMembers& members = body.has_particles() ? body.points.faces : body.hexes.faces;
      auto& bits = body.has_particles() ? faces.particle_bits : faces.node_bits;
      if (const auto at = members.find(face.face); at != members.end())
        for (int member : at->second) bits[std::size_t(body.first + member)] |= bit;
      if (const auto at = body.points.behind.find(face.face);
          all && body.has_particles() && at != body.points.behind.end())
        for (std::size_t k = 0; k < at->second.size(); ++k)
          if (at->second[k] >= 0)
            faces.particle_host[std::size_t(body.first + members.at(face.face)[k])] =
                body.first + at->second[k];
    }
  }

  // Each has a row of its own; of hexes it knows its face.
  void heat_faces(const FilledBody& body) {
    for (const FaceDeck& face : body.deck->faces) {
      if (!face.temperature) continue;
      const std::size_t row = faces.heated.size();
      if (row >= 32)
        reject(deck, *body.deck, "faces." + face.face,
               "is the 33rd face that heat goes through: expected at most 32. Let fewer have a temperature");
      faces.heated.push_back({face.film ? Real(1 / *face.film) : Real(0), Real(*face.temperature)});
      faces.heated_hexes.emplace_back(body.row, face.face);
      if (!body.has_particles()) continue;
      if (const auto at = body.points.faces.find(face.face); at != body.points.faces.end())
        for (int member : at->second) faces.heated_bits[std::size_t(body.first + member)] |= 1u << row;
    }
  }

  // Where held faces meet, the row itself is held.
  void let_rows_follow() {
    std::vector<unsigned> follows(faces.particle_bits.size(), 0);
    for (std::size_t i = 0; i < follows.size(); ++i) {
      int& host = faces.particle_host[i];
      if (host < 0) continue;
      if (faces.particle_bits[std::size_t(host)] != 0 || std::popcount(faces.particle_bits[i]) > 1) host = -1;
      if (host >= 0) follows[i] = follows_bit;
    }
    for (std::size_t i = 0; i < follows.size(); ++i) faces.particle_bits[i] |= follows[i];
  }

  bool has_plane(const GhostPlane& p) const {
    return std::any_of(faces.planes.begin(), faces.planes.end(), [&](const GhostPlane& q) {
      const double apart = std::abs(double(q.offset) - double(p.offset)) / cutoff + norm(q.normal - p.normal);
      return q.active && q.periodic == p.periodic && apart < 1e-6;
    });
  }

  // The two faces of one direction of a body of particles.
  void add_planes(const FilledBody& body, const std::string& low, const std::string& high) {
    if (low.empty() || high.empty() || !body.shape.is_plane(low)) return;
    const bool periodic =
        find_face(*body.deck, low, FaceKind::periodic) && find_face(*body.deck, high, FaceKind::periodic);
    const bool at_low = periodic || find_face(*body.deck, low, FaceKind::symmetric);
    const bool at_high = periodic || find_face(*body.deck, high, FaceKind::symmetric);
    if (!at_low && !at_high) return;
    const std::string key = "faces." + (at_low ? low : high);
    if (low == "start" && body.deck->end_angle - body.deck->start_angle > std::numbers::pi * (1 + 1e-12))
      reject(deck, *body.deck, key,
             "bounds a sector of more than 180 deg: expected at most that. Make it smaller");
    const double thickness = slice_thickness(body.shape, low, high);
    if (at_low && at_high && thickness < cutoff)
      reject(
          deck, *body.deck, key,
          fmt::format(
              "is {:.6g} m from the opposite {} face: expected at least the reach of a particle, {:.6g} m. "
              "Make the body thicker or the spacing smaller",
              thickness, periodic ? "periodic" : "symmetric", cutoff));
    const Plane a = body.shape.plane(low), b = body.shape.plane(high);
    const RigidMap forth = periodic ? period(body.shape, low, high) : mirror(a);
    const RigidMap back =
        periodic ? RigidMap{forth.R.transpose(), -(forth.R.transpose() * forth.t)} : mirror(b);
    GhostPlane first = make_ghost_plane(a, forth, periodic, at_low);
    GhostPlane second = make_ghost_plane(b, back, periodic, at_high);
    first.active = first.active && !has_plane(first);
    second.active = second.active && !has_plane(second);
    if (!first.active && !second.active) return;
    if (faces.planes.size() + 2 > max_ghost_planes)
      reject(
          deck, *body.deck, key,
          fmt::format(
              "is one face too many: expected at most {} pairs of periodic or symmetric planes. Let bodies "
              "share their planes",
              max_ghost_planes / 2));
    faces.planes.push_back(first), faces.planes.push_back(second);
  }

  void couple_faces(const FilledBody& body) {
    for (const auto& [low, high] : body.shape.face_names()) {
      if (!find_face(*body.deck, low, FaceKind::periodic) || !find_face(*body.deck, high, FaceKind::periodic))
        continue;
      const RigidMap map = period(body.shape, low, high);
      const int row = transform_row(map);
      const auto &from = body.hexes.faces.at(low), &to = body.hexes.faces.at(high);
      for (std::size_t n = 0; n < from.size(); ++n) {
        const double off = (map(body.hexes.node[from[n]]) - body.hexes.node[to[n]]).norm();
        if (off > 1e-6 * std::cbrt(body.shape.volume()))
          reject(deck, *body.deck, "faces." + low,
                 fmt::format(
                     "is not the image of the {} face: a node lies {:.3g} m off. Periodic faces need equal "
                     "shapes; previous_tooth makes those of a sector differ",
                     high, off));
        faces.coupled_nodes.push_back({body.first + from[n], body.first + to[n], row});
      }
    }
  }

  int transform_row(const RigidMap& map) {
    const Transform wanted = to_transform(map);
    const auto distance = [&](const Transform& a) {
      const Tensor3 &p = a.R, &q = wanted.R;
      return std::abs(p.xx - q.xx) + std::abs(p.xy - q.xy) + std::abs(p.yx - q.yx) +
             std::abs(a.t.x - wanted.t.x) + std::abs(a.t.y - wanted.t.y) + std::abs(a.t.z - wanted.t.z);
    };
    for (std::size_t row = 0; row < faces.transforms.size(); ++row)
      if (distance(faces.transforms[row]) == 0) return int(row);
    faces.transforms.push_back(wanted);
    return int(faces.transforms.size()) - 1;
  }

  // Where tied bodies end in one plane, both are periodic or none, and the hexes behind a mirror of particles
  // may not move through it.
  void check_tied_faces() const {
    const auto kind = [](const BodyDeck& body, const std::string& face) {
      for (const FaceDeck& f : body.faces)
        if (f.face == face) return f.kind;
      return FaceKind::free;
    };
    for (const FilledBody& body : bodies)
      for (const FilledBody& host : bodies) {
        if (body.deck->tie.empty() || host.deck->name != body.deck->tie) continue;
        for (const auto& [name, plane] : list_planes(body))
          for (const auto& [other, at] : list_planes(host)) {
            const double apart =
                std::abs(plane.offset - at.offset) / cutoff + (plane.normal - at.normal).norm();
            const FaceKind a = kind(*body.deck, name), b = kind(*host.deck, other);
            const bool differ = (a == FaceKind::periodic) != (b == FaceKind::periodic) ||
                                (a == FaceKind::symmetric && b == FaceKind::free);
            if (apart < 1e-6 && differ)
              reject(deck, *body.deck, "faces." + name,
                     fmt::format(
                         "is {}, and face {} of \"{}\" in the same plane is {}: expected the same for both. "
                         "Change one",
                         word_of(a), other, host.deck->name, word_of(b)));
          }
      }
  }

  static std::vector<std::pair<std::string, Plane>> list_planes(const FilledBody& body) {
    std::vector<std::pair<std::string, Plane>> planes;
    for (const auto& direction : body.shape.face_names())
      for (const std::string& face : direction)
        if (!face.empty() && body.shape.is_plane(face)) planes.emplace_back(face, body.shape.plane(face));
    return planes;
  }

  void check_all_inside() const {
    for (const FilledBody& body : bodies)
      for (const Point& x : body.points.position)
        for (const GhostPlane& p : faces.planes)
          if (p.active && double(dot(p.normal, to_vector3(x))) < double(p.offset))
            reject(deck, *body.deck, "origin",
                   fmt::format(
                       "has particles behind a periodic or symmetric plane, at ({:.6g}, {:.6g}, {:.6g}) m: "
                       "such planes bound the whole scene. Move the body",
                       x.x(), x.y(), x.z()));
  }
};

} // namespace

Faces collect_faces(const Deck& deck, const std::vector<FilledBody>& bodies, double cutoff) {
  return Collector(deck, bodies, cutoff).collect();
}

} // namespace swarf
