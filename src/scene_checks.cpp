#include "src/scene_parts.hpp"
#include "src/tool_geometry.hpp"
#include "swarf/kernels.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>

namespace swarf {
namespace {

constexpr double tolerance = 0.05; // of a cell

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
  const bool clipped = body.has_particles() && body.deck->shape == "sphere"; // centres may lie on its surface
  const bool straight = body.deck->shape == "block" || body.deck->shape == "ring"; // hexes are nearly bricks
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

// Line of a section in the deck's file, which a Deck does not keep; 0 without the file.
int find_line(const std::string& file, const std::string& section) {
  std::ifstream deck(file);
  std::string text;
  for (int line = 1; std::getline(deck, text); ++line)
    if (text.find_first_not_of(" \t") == text.find(section) && text.find(section) != std::string::npos)
      return line;
  return 0;
}

int count_inside(const Tool& tool, const ToolPose& pose, ContactPoints points, double depth) {
  return points.count > 0 ? count_points_inside(points, tool, pose, Real(depth)) : 0;
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

void check_sleep(const Deck& deck, const Scene& scene) {
  const auto check = [&](const std::string& section, const std::optional<double>& distance, double least,
                         const char* measure, const char* without) {
    if (!distance || *distance >= least) return;
    throw DeckError(fmt::format(
        "{}:{}: {}.distance: expected at least {:.3g} um, twice the reach of a kernel{}, got {:.3g} um. Make "
        "it larger, or leave it out so that nothing {}.",
        deck.file, find_line(deck.file, "[" + section + "]"), section, 1e6 * least, measure, 1e6 * *distance,
        without));
  };
  check("sleep", deck.sleep.distance, 2 * (scene.cutoff + scene.hex_diagonal), " and a hex", "sleeps");
  check("retire", deck.retire.distance, 2 * scene.cutoff, "", "leaves");
}

void check_tool_outside(const Deck& deck, const Scene& scene) {
  if (!deck.tool) return;
  const Particles& p = scene.particles;
  const HexMesh& m = scene.hexes;
  ContactPoints of_particles, of_nodes;
  of_particles.count = p.count, of_particles.position = p.position, of_particles.area = p.contact_area;
  of_nodes.count = m.nodes, of_nodes.position = m.position, of_nodes.area = m.contact_area;
  const ToolPose pose = tool_pose(*deck.tool, 0);
  const double depth = tolerance * (scene.spacing > 0 ? scene.spacing : double(scene.tool.reach) / 2);
  const int particles = count_inside(scene.tool, pose, of_particles, depth);
  const int nodes = count_inside(scene.tool, pose, of_nodes, depth);
  if (particles + nodes == 0) return;
  throw DeckError(
      fmt::format("{}:{}: tool.position: {} of {} particles and {} nodes lie inside the tool at the start: "
                  "expected none. Move the tool or the bodies{}.",
                  deck.file, find_line(deck.file, "[tool]"), particles, p.count, nodes,
                  deck.tool->kind == "end_mill" ? ", or choose a start_angle outside of the material" : ""));
}

} // namespace swarf
