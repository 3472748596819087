#include "src/deck/lines.hpp"
#include "src/scene/parts.hpp"
#include "src/tool/geometry.hpp"
#include "swarf/kernels.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace swarf {
namespace {

constexpr double tolerance = 0.05;       // of a cell
constexpr double touch_tolerance = 1e-3; // of a cell, of bodies and a tool that are placed to touch

// Centres of the cells of a body, and how far each is from its own surface at least.
struct Centres {
  std::vector<Point> position;
  std::vector<double> inset;
};

// How far the chords of a ring's hexes lie inside of its arcs.
double chord_depth(const FilledBody& body) {
  const BodyDeck& b = *body.deck;
  return b.outer_radius * (1 - std::cos(0.5 * (b.end_angle - b.start_angle) / body.shape.cells[0]));
}

Centres find_centres(const FilledBody& body) {
  Centres c;
  const bool clipped =
      body.has_particles() && (body.deck->shape == BodyShape::sphere || body.deck->has_file());
  // Centres may lie on its surface.
  const bool straight =
      body.deck->shape == BodyShape::block || body.deck->shape == BodyShape::ring; // hexes are nearly bricks
  c.position = body.points.position;
  for (double gap : body.points.gap) c.inset.push_back(clipped ? 0 : gap);
  for (const auto& hex : body.hexes.hex) {
    Point mean(0, 0, 0);
    for (int node : hex) mean += body.hexes.node[node] / 8;
    double across = (body.hexes.node[hex[6]] - body.hexes.node[hex[0]]).norm();
    for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {0, 4}})
      across = std::min(across, (body.hexes.node[hex[a]] - body.hexes.node[hex[b]]).norm());
    c.position.push_back(mean);
    c.inset.push_back(straight ? std::max(0.0, 0.5 * across - chord_depth(body)) : 0);
  }
  return c;
}

int body_of_node(const Scene& scene, int node) {
  const auto corner = host_copy(scene.hexes.connectivity);
  for (int e = 0; e < scene.hexes.points.count; ++e)
    for (int a = 0; a < 8; ++a)
      if (corner(e, a) == node) return host_copy(scene.hex_body)(e);
  return 0;
}

} // namespace

void check_overlap(const Deck& deck, const std::vector<FilledBody>& bodies) {
  if (bodies.size() < 2) return;
  for (const FilledBody& body : bodies) {
    const Centres centres = find_centres(body);
    for (const FilledBody& other : bodies) {
      if (&other == &body) continue;
      for (std::size_t c = 0; c < centres.position.size(); ++c) {
        const Point& x = centres.position[c];
        if (other.shape.signed_distance(x) >= (1 - 2 * tolerance) * centres.inset[c]) continue;
        reject(deck, *body.deck, "origin",
               fmt::format(
                   "overlaps body \"{}\" of line {}, at ({:.6g}, {:.6g}, {:.6g}) m: expected bodies that at "
                   "most touch. Move one or make it smaller",
                   other.deck->name, other.deck->line, x.x(), x.y(), x.z()));
      }
    }
  }
}

void check_freeze(const Deck& deck, const Scene& scene) {
  const auto check = [&](const std::string& section, const std::optional<double>& distance, double least,
                         const char* measure, const char* without) {
    if (!distance || *distance >= least) return;
    throw DeckError(fmt::format(
        "{}: {}.distance: expected at least {:.3g} um, twice the reach of a kernel{}, got {:.3g} um. Make "
        "it larger, or leave it out so that nothing {}.",
        line_of(deck.file, "[" + section + "]", "distance"), section, 1e6 * least, measure, 1e6 * *distance,
        without));
  };
  check("sleep", deck.sleep.distance, 2 * (scene.cutoff + scene.hex_diagonal), " and a hex", "freezes");
  check("retire", deck.retire.distance, 2 * scene.cutoff, "", "leaves");
}

void check_tool_outside(const Deck& deck, const Scene& scene) {
  if (!deck.tool) return;
  const Particles& p = scene.particles;
  const HexMesh& m = scene.hexes;
  ContactPoints of_particles, of_nodes;
  of_particles.count = p.count, of_particles.position = p.position, of_particles.area = p.contact_area;
  of_particles.gap = p.contact_gap;
  of_nodes.count = m.nodes, of_nodes.position = m.position, of_nodes.area = m.contact_area;
  of_nodes.gap = m.contact_gap;
  const ToolPose pose = tool_pose(*deck.tool, 0);
  const double cell = scene.spacing > 0 ? scene.spacing : double(scene.tool.reach) / 2;
  for (const ContactPoints* points : {&of_particles, &of_nodes}) {
    const ClosestPoint deepest = find_closest_point(*points, scene.tool, pose);
    if (deepest.row < 0 || deepest.depth <= touch_tolerance * cell) continue;
    const bool is_node = points == &of_nodes;
    const BodyDeck& body =
        deck.bodies[std::size_t(is_node ? body_of_node(scene, deepest.row) : host_copy(p.body)(deepest.row))];
    const Vector3 x = load_vector(host_copy(points->position), deepest.row);
    const bool is_known = deepest.depth < scene.tool.reach;
    throw DeckError(fmt::format(
        "{}: tool.position: the tool overlaps body \"{}\" of line {} by {}{:.4g} um at the start, deepest at "
        "({:.6g}, {:.6g}, {:.6g}) m{}: expected none. Move the tool or the body apart{}.",
        line_of(deck.file, "[tool]", "position"), body.name, body.line, is_known ? "" : "more than ",
        1e6 * std::min(double(deepest.depth), double(scene.tool.reach)), x.x, x.y, x.z,
        is_node ? "" : ", the centre of a particle, whose own surface lies half a spacing around it",
        deck.tool->kind == ToolKind::end_mill ? ", or choose a start_angle outside of the material" : ""));
  }
}

} // namespace swarf
