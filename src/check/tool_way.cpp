// Warnings about where the tool goes.
#include "src/check/scene.hpp"
#include "src/geometry/upload.hpp"
#include "src/tool/geometry.hpp"
#include "swarf/kernels.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace swarf {
namespace {

constexpr double most_looks = 4e8; // points times poses: seconds

double length(const Triple& v) { return std::hypot(v[0], v[1], v[2]); }

ContactPoints points_of(const VectorField& position, const ScalarField& gap, const ScalarField& area,
                        int count) {
  ContactPoints points;
  points.count = count, points.position = position, points.gap = gap, points.area = area;
  return points;
}

bool moves(const Deck& deck) {
  if (length(deck.run.gravity) > 0) return true;
  for (const BodyDeck& body : deck.bodies) {
    if (length(body.velocity) > 0) return true;
    for (const FaceDeck& face : body.faces)
      if (length(face.velocity) > 0) return true;
  }
  return false;
}

// Where bodies may get to by themselves, without what the tool does.
Box reach_of_bodies(const Deck& deck, const Scene& scene) {
  const std::vector<Box> boxes = boxes_of_bodies(deck, scene);
  const double end = end_time_of(deck);
  Box all;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    std::vector<Triple> speeds{{0, 0, 0}, deck.bodies[b].velocity};
    for (const FaceDeck& face : deck.bodies[b].faces) speeds.push_back(face.velocity);
    for (const Triple& v : speeds)
      for (const double fall : {0.0, 0.5 * end * end}) {
        Triple way;
        for (std::size_t c = 0; c < 3; ++c) way[c] = v[c] * end + deck.run.gravity[c] * fall;
        all.add(boxes[b].moved(way));
      }
  }
  return all;
}

// Poses along the way, so dense that what is touched between two of them is near at one. Bodies as they are.
bool comes_near(const Deck& deck, const Scene& scene) {
  const Particles& p = scene.particles;
  const HexMesh& m = scene.hexes;
  const ContactPoints all[] = {points_of(p.position, p.contact_gap, p.contact_area, p.count),
                               points_of(m.position, m.contact_gap, m.contact_area, m.nodes)};
  double radius = 0;
  for (const auto& facet : scene.tool_facets)
    for (const Triple& v : facet) radius = std::max(radius, std::hypot(v[0], v[1]));
  const ToolPose start = tool_pose(*deck.tool, 0);
  const double speed = double(norm(start.velocity)) + std::abs(double(start.angular_velocity)) * radius;
  const double end = end_time_of(deck), way = speed * end, reach = double(scene.tool.reach);
  const double poses = std::ceil(way / reach) + 1;
  if (poses * double(p.count + m.nodes) > most_looks) return true; // by their boxes they may
  for (double k = 0; k < poses; ++k) {
    const ToolPose pose = tool_pose(*deck.tool, poses > 1 ? end * k / (poses - 1) : 0.0);
    for (const ContactPoints& points : all)
      if (points.count > 0 && double(find_closest_point(points, scene.tool, pose).depth) > -0.6 * reach)
        return true;
  }
  return false;
}

void warn_if_it_misses(const Deck& deck, const Scene& scene, std::vector<std::string>& warnings) {
  const Box bodies = reach_of_bodies(deck, scene), tool = way_of_tool(deck, scene);
  if (tool.meets(bodies) && (moves(deck) || comes_near(deck, scene))) return;
  warnings.push_back(fmt::format(
      "tool and bodies never meet: all the tool's way lies in {}, the bodies in {}. Look at "
      "tool.position, {} and run.{}",
      describe_box(tool), describe_box(bodies), deck.tool->spindle_speed > 0 ? "start_angle" : "velocity",
      deck.run.end_time ? "end_time" : "end_immersion"));
}

void warn_of_size(const Deck& deck, const Scene& scene, std::vector<std::string>& warnings) {
  if (deck.tool->kind != ToolKind::stl) return;
  Box bodies;
  for (const Box& box : boxes_of_bodies(deck, scene)) bodies.add(box);
  const double tool = box_of_tool(deck, scene, 0).diagonal(), ratio = tool / bodies.diagonal();
  if (ratio > 0.01 && ratio < 300) return;
  warnings.push_back(fmt::format(
      "the tool of {} is {} across, the bodies {}: is tool.file_scale = \"{}\" the unit of the file? One "
      "step of 1000 would make it {}",
      deck.tool->file, describe_length(tool), describe_length(bodies.diagonal()),
      describe_length(deck.tool->file_scale), describe_length(tool * (ratio < 1 ? 1000 : 0.001))));
}

// Contact looks from the points of the work to the tool: between them it sees nothing.
void warn_of_thinness(const Deck& deck, const Scene& scene, std::vector<std::string>& warnings) {
  const Box tool = box_of_tool(deck, scene, 0);
  double extent = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < 3; ++c) extent = std::min(extent, tool.high[c] - tool.low[c]);
  const double cell =
      std::max(scene.spacing, scene.particles.count > 0 ? 0 : scene.hex_diagonal / std::sqrt(3.0));
  if (extent >= 2 * cell) return;
  warnings.push_back(fmt::format("the tool is {} thin and the cells of the work are {}: it may pass between "
                                 "them unseen. Take a larger tool or smaller cells",
                                 describe_length(extent), describe_length(cell)));
}

// Middles and mid-edges of the quads whose nodes a tool may touch.
ContactPoints between_nodes(const HexMesh& m) {
  static constexpr int quads[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                      {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  const auto corner = host_copy(m.connectivity);
  const auto area = host_copy(m.contact_area);
  const auto x = host_copy(m.position);
  std::vector<Vector3> points;
  for (int e = 0; e < m.points.count; ++e)
    for (const auto& quad : quads) {
      Vector3 at[4], middle{0, 0, 0};
      bool is_free = true;
      for (int k = 0; k < 4; ++k) {
        const int n = corner(e, quad[k]);
        is_free = is_free && area(n) > 0;
        at[k] = load_vector(x, n), middle = middle + Real(0.25) * at[k];
      }
      if (!is_free) continue;
      points.push_back(middle);
      for (int k = 0; k < 4; ++k) points.push_back(Real(0.5) * (at[k] + at[(k + 1) % 4]));
    }
  const int n = int(points.size());
  return points_of(
      upload<VectorField>("between", n, [&](auto& f, int i) { store_vector(f, i, points[std::size_t(i)]); }),
      ScalarField("gap", std::size_t(n)), upload<ScalarField>("area", n, [](auto& f, int i) { f(i) = 1; }),
      n);
}

// Contact looks from the nodes to the tool: where it goes on in a face before it has come to a node it is not
// felt, and its edge is finer than the mesh. The poses up to its first node decide.
void warn_of_gaps(const Deck& deck, const Scene& scene, std::vector<std::string>& warnings) {
  const HexMesh& m = scene.hexes;
  if (m.points.count == 0) return;
  const double edge = scene.hex_diagonal / std::sqrt(3.0);
  const ContactPoints nodes = points_of(m.position, m.contact_gap, m.contact_area, m.nodes),
                      between = between_nodes(m);
  double radius = 0;
  for (const auto& facet : scene.tool_facets)
    for (const Triple& v : facet) radius = std::max(radius, std::hypot(v[0], v[1]));
  const ToolPose start = tool_pose(*deck.tool, 0);
  const double speed = double(norm(start.velocity)) + std::abs(double(start.angular_velocity)) * radius;
  const double end = end_time_of(deck), poses = std::ceil(4 * speed * end / edge) + 1;
  if (between.count == 0 || poses * double(between.count + m.nodes) > most_looks) return;
  double first = -1;
  for (double k = 0; k < poses; ++k) {
    const ToolPose pose = tool_pose(*deck.tool, poses > 1 ? end * k / (poses - 1) : 0.0);
    if (double(find_closest_point(nodes, scene.tool, pose).depth) > 0) return;
    const ClosestPoint in_face = find_closest_point(between, scene.tool, pose);
    if (in_face.row < 0 || double(in_face.depth) <= 0) continue;
    if (first < 0) first = k;
    const double way = poses > 1 ? speed * end * (k - first) / (poses - 1) : 0;
    if (way < 0.5 * edge) continue;
    const Vector3 at = load_vector(host_copy(between.position), in_face.row);
    warnings.push_back(
        fmt::format("the tool goes {} into the hexes between their nodes, at ({:.4g}, {:.4g}, {:.4g}) m, "
                    "before it comes to one "
                    "of them: until then it is not felt. Take hexes of at most {}, or particles there",
                    describe_length(way), at.x, at.y, at.z, describe_length(0.5 * edge)));
    return;
  }
}

bool is_slice(const BodyDeck& body) {
  return std::any_of(body.faces.begin(), body.faces.end(), [](const FaceDeck& f) {
    return f.kind == FaceKind::periodic && (f.face == "z_min" || f.face == "bottom");
  });
}

// What the tool does not reach is not cut, and by its images the chip would be torn along the slice.
void warn_of_width(const Deck& deck, const Scene& scene, std::vector<std::string>& warnings) {
  const std::vector<Box> boxes = boxes_of_bodies(deck, scene);
  Box tool = box_of_tool(deck, scene, 0);
  const Box last = box_of_tool(deck, scene, end_time_of(deck));
  const double low = std::max(tool.low[2], last.low[2]), high = std::min(tool.high[2], last.high[2]);
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    if (!is_slice(deck.bodies[b]) || boxes[b].empty()) continue;
    const double tolerance = 1e-6 * (boxes[b].high[2] - boxes[b].low[2]);
    if (low <= boxes[b].low[2] + tolerance && high >= boxes[b].high[2] - tolerance) continue;
    const ToolKind kind = deck.tool->kind;
    warnings.push_back(fmt::format(
        "the tool is narrower than the periodic slice \"{}\": along z it reaches from {} to {}, the slice "
        "from {} to {}. Take a larger tool.{}, or move tool.position",
        deck.bodies[b].name, describe_length(low), describe_length(high), describe_length(boxes[b].low[2]),
        describe_length(boxes[b].high[2]),
        kind == ToolKind::wedge      ? "width"
        : kind == ToolKind::end_mill ? "length"
        : kind == ToolKind::stl      ? "file_scale"
                                     : "size"));
    return;
  }
}

} // namespace

std::vector<std::string> warn_of_tool(const Deck& deck, const Scene& scene) {
  std::vector<std::string> warnings;
  warn_of_size(deck, scene, warnings);
  warn_of_thinness(deck, scene, warnings);
  if (warnings.empty()) warn_of_gaps(deck, scene, warnings);
  warn_if_it_misses(deck, scene, warnings);
  warn_of_width(deck, scene, warnings);
  return warnings;
}

} // namespace swarf
