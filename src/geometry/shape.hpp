// The shapes of a deck's bodies: cells of their lattices, signed distance, plane faces, volume.
#pragma once
#include "src/deck/deck.hpp"
#include <Eigen/Core>
#include <functional>
#include <memory>

namespace swarf {

using Point = Eigen::Vector3d;

// Throws DeckError "file:line: body.KEY: "NAME" text.".
[[noreturn]] void reject(const Deck& deck, const BodyDeck& body, const std::string& key,
                         const std::string& text);

struct Plane {
  Point normal; // unit, into the body
  double offset;
};

struct BodyFile; // what the file of a body holds, see body_file.hpp

// How far out the inner surface of a ring lies, at an angle about its axis and a height in the scene, m.
using InnerSurface = std::function<double(double angle, double z)>;

struct Shape {
  const Deck* deck = nullptr; // for messages
  const BodyDeck* body = nullptr;
  // Directions: block, stl (of its box) x, y, z; ring around, axial, radial; cylinder across, axial, across;
  // sphere across (solid lattice) or along an edge of the cube, along another, radial (hexes); mesh: all in
  // the first.
  std::array<int, 3> cells{};
  std::shared_ptr<const BodyFile> file; // stl, mesh
  InnerSurface inner;                   // rings only
  double inner_least = 0;               // least radius of that surface
  bool closed = false;                  // a ring of a whole turn

  // Negative inside; outside at most the distance. Bent surfaces are exact, not the mesh's chords.
  double signed_distance(const Point& x) const;
  double volume() const; // of the shape without the previous tooth
  // Names of the faces at the low and the high end of each direction of the lattice, "" where there is none.
  std::array<std::array<std::string, 2>, 3> face_names() const;
  // Throws std::out_of_range for a bent face.
  Plane plane(const std::string& face) const;
  bool is_plane(const std::string& face) const;
};

// Throws DeckError for a body too small for one cell, too many cells for this machine, or a shape that cannot
// be meshed.
Shape make_shape(const Deck& deck, const BodyDeck& body);

// Corners of least and greatest x, y, z.
std::array<Triple, 2> find_box(const Deck& deck, const BodyDeck& body);

// Along the directions of the lattice, see Shape::cells; as reals: they may be absurd.
Triple find_cells(const Deck& deck, const BodyDeck& body);

// Particles or hexes of the shape, counted before anything is allocated.
double count_cells(const Deck& deck, const BodyDeck& body);

double machine_memory(); // bytes that a process may have
// Throws DeckError where all bodies together need more than the machine has.
void check_memory(const Deck& deck);

// Radius, about the axis through `origin`, of the surface that the teeth of an end mill have left before time
// 0. A tooth was last at immersion phi a time -s T ago, T the time between two teeth and s in [0, 1); the
// tool's centre then lay s feeds behind its start. Runout is left out.
InnerSurface previous_tooth_surface(const ToolDeck& tool, const Triple& origin);

} // namespace swarf
