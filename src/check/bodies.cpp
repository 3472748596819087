// Warnings about what holds bodies, what joins them, and whether they feel each other.
#include "src/check/scene.hpp"
#include "src/geometry/shape.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace swarf {
namespace {

bool is_zero(const Triple& v) { return v == Triple{}; }

bool are_tied(const BodyDeck& a, const BodyDeck& b) { return a.tie == b.name || b.tie == a.name; }

// Particles of two bodies feel each other by their kernels, pull as well as push.
bool feel(const Deck& deck, const BodyDeck& a, const BodyDeck& b) {
  return a.fill == Fill::particles && b.fill == Fill::particles &&
         deck.particles.kernel_frame != KernelFrame::initial;
}

// Centres or nodes of each body, and how far its own surface lies around them.
struct Points {
  std::vector<Point> at;
  std::vector<double> margin;
};

std::vector<Points> points_of_bodies(const Deck& deck, const Scene& scene) {
  std::vector<Points> all(deck.bodies.size());
  const auto x = host_copy(scene.particles.position), node = host_copy(scene.hexes.position);
  const auto gap = host_copy(scene.particles.contact_gap);
  const auto body = host_copy(scene.particles.body), hex_body = host_copy(scene.hex_body);
  const auto corner = host_copy(scene.hexes.connectivity);
  const auto add = [&](int row, const auto& field, int i, double margin) {
    all[std::size_t(row)].at.emplace_back(field(i, 0), field(i, 1), field(i, 2));
    all[std::size_t(row)].margin.push_back(margin);
  };
  for (int i : particle_rows(scene.particles)) add(body(i), x, i, double(gap(i)));
  std::vector<bool> seen(std::size_t(scene.hexes.nodes), false);
  for (int e = 0; e < scene.hexes.points.count; ++e)
    for (int a = 0; a < 8; ++a) {
      const int n = corner(e, a);
      if (!seen[std::size_t(n)]) add(hex_body(e), node, n, 0);
      seen[std::size_t(n)] = true;
    }
  return all;
}

double cell_of(const Deck& deck, const BodyDeck& body, const Shape& shape) {
  return std::cbrt(shape.volume() / count_cells(deck, body));
}

// A face of at least a few points in common: an edge or a corner joins nothing.
bool touch(const Points& points, const Shape& other, double tolerance) {
  int count = 0;
  for (std::size_t k = 0; k < points.at.size() && count < 3; ++k)
    count += std::abs(other.signed_distance(points.at[k]) - points.margin[k]) <= tolerance ? 1 : 0;
  return count >= 3;
}

// Whether box a, going by `way`, ever meets b: a straight line against a box grown by the other.
bool hits(const Box& a, const Triple& way, const Box& b) {
  double first = 0, last = 1;
  for (std::size_t c = 0; c < 3; ++c) {
    const double near = b.low[c] - a.high[c], far = b.high[c] - a.low[c];
    if (way[c] == 0) {
      if (near > 0 || far < 0) return false;
      continue;
    }
    const auto [enter, leave] = std::minmax({near / way[c], far / way[c]});
    first = std::max(first, enter), last = std::min(last, leave);
  }
  return first <= last;
}

class BodyCheck {
 public:
  BodyCheck(const Deck& from, const Scene& scene)
      : deck(from), boxes(boxes_of_bodies(from, scene)), points(points_of_bodies(from, scene)),
        group(from.bodies.size()), contact_group(contact_groups(from)) {
    for (const BodyDeck& body : deck.bodies) shapes.push_back(make_shape(deck, body));
    std::iota(group.begin(), group.end(), std::size_t(0));
  }

  BodyReport run() {
    for (std::size_t a = 0; a < deck.bodies.size(); ++a)
      for (std::size_t b = a + 1; b < deck.bodies.size(); ++b) look_at_pair(a, b);
    look_at_holds();
    look_at_cells();
    return {warnings, joined, met};
  }

 private:
  const Deck& deck;
  std::vector<Box> boxes;
  std::vector<Points> points;
  std::vector<Shape> shapes;
  std::vector<std::size_t> group;
  std::vector<int> contact_group; // of ties, direct and by way of others
  std::vector<std::string> warnings, joined, met;

  std::size_t root(std::size_t b) const { return group[b] == b ? b : root(group[b]); }

  void look_at_pair(std::size_t a, std::size_t b) {
    const BodyDeck &one = deck.bodies[a], &other = deck.bodies[b];
    const double tolerance = 0.1 * std::min(cell_of(deck, one, shapes[a]), cell_of(deck, other, shapes[b]));
    Box near = boxes[a];
    near.grow(near.low, tolerance), near.grow(near.high, tolerance);
    const bool touching = near.meets(boxes[b]) &&
                          (touch(points[a], shapes[b], tolerance) || touch(points[b], shapes[a], tolerance));
    if (are_tied(one, other) || (touching && feel(deck, one, other))) group[root(a)] = root(b);
    if (are_tied(one, other)) return;
    const std::string pair = fmt::format("bodies \"{}\" of line {} and \"{}\" of line {}", one.name, one.line,
                                         other.name, other.line);
    if (feel(deck, one, other)) {
      if (touching)
        joined.push_back(pair + " touch: their particles push and pull each other");
      else if (come_together(a, b))
        joined.push_back(pair +
                         " come together: from where they meet their particles push and pull each other, "
                         "and do not part again");
      return;
    }
    const bool press = can_meet(deck, one, other) && contact_group[a] != contact_group[b];
    if (touching)
      warnings.push_back(fmt::format("{} touch, and nothing joins them: they part when pulled and {} when "
                                     "pressed. {}",
                                     pair, press ? "press each other" : "pass through each other",
                                     advice(one, other)));
    else if (press && come_together(a, b))
      met.push_back(
          fmt::format("{} come together: contact, with friction {:.3g}", pair, deck.contact.friction));
    else if (come_together(a, b))
      warnings.push_back(fmt::format("{} come together and do not feel each other: they pass through. {}",
                                     pair, remedy(one, other)));
  }

  std::string advice(const BodyDeck& one, const BodyDeck& other) const {
    const std::string& taken = one.fill == Fill::hexes ? other.tie : one.tie;
    if (one.fill != other.fill && taken.empty())
      return fmt::format("Give the particles tie = \"{}\"", one.fill == Fill::hexes ? one.name : other.name);
    return "Make them one body, or fill one with particles and tie it to the other";
  }

  // What lets two bodies feel each other that would pass through.
  std::string remedy(const BodyDeck& one, const BodyDeck& other) const {
    if (one.fill == Fill::particles && other.fill == Fill::particles)
      return "Take kernel_frame = \"current\", or fill one with hexes";
    return deck.contact.between_bodies == BetweenBodies::none ? "Leave contact.between_bodies = \"none\" out"
                                                              : "Ties to other bodies make them one";
  }

  std::vector<Triple> ways(std::size_t b) const {
    const double end = end_time_of(deck);
    std::vector<Triple> speeds{deck.bodies[b].velocity}, all;
    for (const FaceDeck& face : deck.bodies[b].faces) speeds.push_back(face.velocity);
    const bool falls = !is_held(deck.bodies[b]);
    for (const Triple& v : speeds) {
      Triple way;
      for (std::size_t c = 0; c < 3; ++c)
        way[c] = v[c] * end + (falls ? 0.5 * deck.run.gravity[c] * end * end : 0);
      all.push_back(way);
    }
    return all;
  }

  bool come_together(std::size_t a, std::size_t b) const {
    for (const Triple& first : ways(a))
      for (const Triple& second : ways(b)) {
        const Triple way{first[0] - second[0], first[1] - second[1], first[2] - second[2]};
        if (!is_zero(way) && hits(boxes[a], way, boxes[b])) return true;
      }
    return false;
  }

  static bool is_held(const BodyDeck& body) {
    return std::any_of(body.faces.begin(), body.faces.end(), [](const FaceDeck& face) {
      return face.kind != FaceKind::periodic && face.kind != FaceKind::free;
    });
  }

  // The surface of a body of particles is half a cell beyond their centres: half of the least edge.
  void look_at_cells() {
    for (const BodyDeck& body : deck.bodies) {
      if (body.shape != BodyShape::block || body.fill != Fill::particles) continue;
      const Triple cells = find_cells(deck, body);
      Triple edge;
      for (std::size_t c = 0; c < 3; ++c) edge[c] = body.size[c] / cells[c];
      const auto [least, most] = std::minmax_element(edge.begin(), edge.end());
      if (*most > 1.1 * *least)
        warnings.push_back(
            fmt::format("the cells of body \"{}\" of line {} are {:.3g} times as long as wide: across "
                        "the long way the tool meets it too late. Take cells nearer to cubes",
                        body.name, body.line, *most / *least));
      for (const FaceDeck& face : body.faces) {
        const std::size_t axis = std::size_t(face.face[0] - 'x');
        const bool held = face.kind == FaceKind::fixed || face.kind == FaceKind::velocity;
        if (held && axis < 3 && cells[axis] <= 2)
          warnings.push_back(
              fmt::format("body \"{}\" of line {} has {} layer(s) of particles across its held face "
                          "{}: take three or more, or it is too stiff",
                          body.name, body.line, cells[axis], face.face));
      }
    }
  }

  // A body at rest before a tool is meant to stay, as far as the tool lets it.
  void look_at_holds() {
    if (!deck.tool || !is_zero(deck.run.gravity)) return;
    for (std::size_t a = 0; a < deck.bodies.size(); ++a) {
      bool held = false;
      for (std::size_t b = 0; b < deck.bodies.size(); ++b)
        held = held || (root(a) == root(b) && (is_held(deck.bodies[b]) || !is_zero(deck.bodies[b].velocity)));
      if (!held)
        warnings.push_back(
            fmt::format("nothing holds body \"{}\" of line {}: the tool pushes it away. Hold a face "
                        "(body.faces), or tie it to a body that is held",
                        deck.bodies[a].name, deck.bodies[a].line));
    }
  }
};

} // namespace

BodyReport look_at_bodies(const Deck& deck, const Scene& scene) { return BodyCheck(deck, scene).run(); }

} // namespace swarf
