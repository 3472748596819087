#include "src/scene/scene.hpp"
#include "src/deck/lines.hpp"
#include "src/geometry/body_file.hpp"
#include "src/geometry/upload.hpp"
#include "src/scene/hex_conversion.hpp"
#include "src/scene/parts.hpp"
#include "src/tool/cells.hpp"
#include "src/tool/surface.hpp"
#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <map>

namespace swarf {

namespace {

TemperatureTable make_table(const OverTemperature& deck, double unit) {
  TemperatureTable t;
  t.points = int(deck.points.size());
  for (int k = 0; k < t.points; ++k) {
    const auto& [T, value] = deck.points[std::size_t(k)];
    t.temperature[k] = Real(T), t.value[k] = Real(value / unit);
    if (k > 0)
      t.integral_to[k] = t.integral_to[k - 1] + Real(0.5) * (t.value[k - 1] + t.value[k]) *
                                                    (t.temperature[k] - t.temperature[k - 1]);
  }
  return t;
}

} // namespace

Material make_material(const MaterialDeck& deck) {
  Material m;
  m.density = Real(deck.density);
  const double stiffest = deck.youngs_modulus.greatest();
  m.bulk_modulus = Real(stiffest / (3 * (1 - 2 * deck.poissons_ratio)));
  m.shear_modulus = Real(stiffest / (2 * (1 + deck.poissons_ratio)));
  m.specific_heat = Real(deck.specific_heat.least()), m.conductivity = Real(deck.conductivity.greatest());
  m.stiffness_table = make_table(deck.youngs_modulus, stiffest);
  m.specific_heat_table = make_table(deck.specific_heat, 1);
  m.conductivity_table = make_table(deck.conductivity, 1);
  m.thermal_expansion = Real(deck.thermal_expansion);
  m.taylor_quinney = Real(deck.taylor_quinney);
  static const std::map<Law, FlowLaw> laws = {{Law::linear_hardening, FlowLaw::linear_hardening},
                                              {Law::johnson_cook, FlowLaw::johnson_cook},
                                              {Law::johnson_cook_tanh, FlowLaw::johnson_cook_tanh},
                                              {Law::zerilli_armstrong, FlowLaw::zerilli_armstrong}};
  if (laws.contains(deck.law)) m.law = laws.at(deck.law);
  if (m.law == FlowLaw::linear_hardening)
    m.linear_hardening = {Real(deck.yield_stress), Real(deck.hardening_modulus)};
  if (m.law == FlowLaw::johnson_cook || m.law == FlowLaw::johnson_cook_tanh)
    m.johnson_cook = {Real(deck.A),
                      Real(deck.B),
                      Real(deck.n),
                      Real(deck.C),
                      Real(deck.m),
                      Real(deck.reference_rate),
                      Real(deck.reference_temperature),
                      Real(deck.melt_temperature)};
  if (m.law == FlowLaw::johnson_cook_tanh)
    m.strain_softening = {Real(deck.softening_a), Real(deck.softening_b), Real(deck.softening_c),
                          Real(deck.softening_d)};
  if (m.law == FlowLaw::zerilli_armstrong)
    m.zerilli_armstrong = {Real(deck.C0), Real(deck.C1), Real(deck.C2), Real(deck.C3),
                           Real(deck.C4), Real(deck.C5), Real(deck.n),  Real(deck.reference_rate)};
  if (deck.damage) {
    const auto& D = *deck.damage;
    m.damage = {true, Real(D[0]), Real(D[1]), Real(D[2]), Real(D[3]), Real(D[4])};
  }
  return m;
}

namespace {

std::vector<Shape> shapes_of(const Deck& deck) {
  std::vector<Shape> shapes;
  for (const BodyDeck& body : deck.bodies) shapes.push_back(make_shape(deck, body));
  return shapes;
}

std::vector<FilledBody> fill_bodies(const Deck& deck) {
  const std::vector<Shape> shapes = shapes_of(deck); // all counts are checked before the first is filled
  check_memory(deck);
  std::vector<FilledBody> bodies;
  int particles = 0, nodes = 0, hexes = 0;
  for (std::size_t row = 0; row < deck.bodies.size(); ++row) {
    const BodyDeck& body = deck.bodies[row];
    FilledBody filled;
    filled.deck = &body, filled.row = int(row), filled.shape = shapes[row];
    const auto material = std::find_if(deck.materials.begin(), deck.materials.end(),
                                       [&](const MaterialDeck& m) { return m.name == body.material; });
    if (material == deck.materials.end())
      reject(deck, body, "material", fmt::format("has no [material.{}]. Add it", body.material));
    filled.material = int(material - deck.materials.begin());
    if (filled.has_particles()) {
      filled.points = fill_points(filled.shape), filled.first = particles;
      if (filled.points.position.empty()) reject(deck, body, "spacing", "holds no particle. Make it smaller");
    } else {
      filled.hexes = fill_hexes(filled.shape), filled.first = nodes, filled.first_hex = hexes;
      if (body.converts())
        filled.points.spacing =
            std::cbrt(filled.shape.volume() / double(filled.hexes.hex.size())) / body.convert_particles;
    }
    particles += int(filled.points.position.size());
    nodes += int(filled.hexes.node.size()), hexes += int(filled.hexes.hex.size());
    bodies.push_back(std::move(filled));
  }
  return bodies;
}

// Failed points compare their density with that at the start; bodies of one material start alike (deck).
MaterialTable make_materials(const Deck& deck, const std::vector<FilledBody>& bodies) {
  return upload<MaterialTable>("materials", int(deck.materials.size()), [&](auto& f, int row) {
    f(row) = make_material(deck.materials[std::size_t(row)]);
    for (const FilledBody& b : bodies)
      if (b.material == row) f(row).start_temperature = Real(b.deck->temperature);
  });
}

// Particles have the identity of their row.
HeldRows make_held_rows(const Faces& faces) {
  std::map<int, std::vector<int>> of_host;
  for (std::size_t i = 0; i < faces.particle_host.size(); ++i)
    if (faces.particle_host[i] >= 0) of_host[faces.particle_host[i]].push_back(int(i));
  std::vector<int> host, start{0}, held, face;
  for (const auto& [at, particles] : of_host) {
    host.push_back(at);
    for (const int i : particles)
      held.push_back(i), face.push_back(std::countr_zero(faces.particle_bits[std::size_t(i)]));
    start.push_back(int(held.size()));
  }
  const int rows = host.empty() ? 0 : int(faces.particle_host.size());
  return {int(host.size()),
          upload("held_rows.host", host),
          upload("held_rows.start", start),
          upload("held_rows.held", held),
          upload("held_rows.face", face),
          IndexField("held_rows.row", rows)};
}

// Particles sharing a plane's ghosts need the largest support of all.
double largest_smoothing_length(const Deck& deck, const std::vector<FilledBody>& bodies) {
  double largest = 0;
  for (const FilledBody& b : bodies)
    largest = std::max(largest, deck.particles.smoothing_ratio * b.points.spacing);
  return largest;
}

// Its cells hold a particle each, in the middle; those of hexes that will be particles begin at the nodes.
CellGrid lattice_of(const FilledBody& body) {
  const bool filled = !body.points.position.empty();
  const std::vector<Point>& points = filled ? body.points.position : body.hexes.node;
  const double half = filled ? 0.5 * body.points.spacing : 0;
  Point low = points.front();
  for (const Point& x : points) low = low.cwiseMin(x);
  return {to_vector3(Point(low - Point(half, half, half))), Real(body.points.spacing)};
}

// The mass of a hex as a material point is that of the volume that carries stress; its nodes keep it all.
void set_stress_shares(HexMesh& mesh, const std::vector<double>& share) {
  const auto mass = host_copy(mesh.points.mass);
  mesh.share = upload<ScalarField>("share", mesh.points.count, [&](auto& f, int e) {
    f(e) = Real(share[std::size_t(e)]);
    mass(e) *= f(e);
  });
  Kokkos::deep_copy(mesh.points.mass, mass);
}

double largest_diagonal(const std::vector<FilledBody>& bodies) {
  double largest = 0;
  for (const FilledBody& b : bodies)
    for (const auto& hex : b.hexes.hex)
      for (const auto& [from, to] : {std::pair(0, 6), std::pair(1, 7), std::pair(2, 4), std::pair(3, 5)})
        largest = std::max(largest, (b.hexes.node[std::size_t(hex[std::size_t(to)])] -
                                     b.hexes.node[std::size_t(hex[std::size_t(from)])])
                                        .norm());
  return largest;
}

std::vector<TiedPoint> tie_bodies(const Deck& deck, const std::vector<FilledBody>& bodies, double reach) {
  std::vector<TiedPoint> tied;
  for (int row = 0; row < int(bodies.size()); ++row) {
    if (!bodies[row].has_particles() || bodies[row].deck->tie.empty()) continue;
    const auto points = place_tied_points(deck, bodies, row, reach);
    tied.insert(tied.end(), points.begin(), points.end());
  }
  return tied;
}

// The geometry's own words, at the key of the deck that they are about.
FacetSurface make_surface(const Deck& deck) {
  try {
    return make_tool_surface(*deck.tool, std::filesystem::path(deck.file).parent_path().string());
  } catch (const DeckError& error) {
    const std::string what = error.what();
    const bool is_file = deck.tool->kind == ToolKind::stl;
    const bool names_key = what.starts_with("tool.");
    const std::string key = is_file ? "file" : names_key ? what.substr(5, what.find(':') - 5) : "kind";
    throw DeckError(
        fmt::format("{}: {}{}.", line_of(deck.file, "[tool]", key), is_file ? "tool.file: " : "", what));
  }
}

void add_tool(const Deck& deck, const std::vector<FilledBody>& bodies, Scene& scene) {
  const FacetSurface surface = make_surface(deck);
  scene.collapsed_facets = surface.collapsed;
  for (const auto& f : surface.facets)
    scene.tool_facets.push_back({surface.vertices[f[0]], surface.vertices[f[1]], surface.vertices[f[2]]});
  double cell = 0; // largest, so that gaps and penetrations of a cell stay within reach
  for (const FilledBody& b : bodies) {
    const double share = b.shape.volume() / double(std::max<std::size_t>(1, b.hexes.hex.size()));
    const bool touches = scene.spacing == 0 || b.deck->converts();
    cell = std::max(cell, b.has_particles() ? b.points.spacing : touches ? std::cbrt(share) : 0.0);
  }
  scene.tool = build_tool(surface, *deck.tool, 2 * cell);
  scene.patch_spacing = scene.spacing > 0 ? scene.spacing : cell;
  make_patches(deck, scene, end_time_of(deck));
  if (deck.tool->material.empty()) return;
  const HeatPlan plan = plan_tool_heat(deck, shapes_of(deck), scene.patch_spacing);
  scene.tool.heat = build_tool_heat(scene.tool, surface, *deck.tool, plan);
  scene.tool.heat.first = IndexField("tool_first", std::size_t(scene.tool.heat.cells) + 1);
  scene.heat_reach = plan.reach;
}

} // namespace

void make_patches(const Deck& deck, Scene& scene, double end) {
  const double finest = scene.patch_spacing;
  ToolSurface& patches = scene.tool.surface;
  patches = build_tool_surface(make_surface(deck),
                               {finest, find_distance_to_work(deck, shapes_of(deck), finest, end)});
  patches.wear_A = Real(deck.tool->wear_A.value_or(0)), patches.wear_B = Real(deck.tool->wear_B.value_or(0));
  scene.patch_end = end;
}

Scene build_scene(const Deck& deck) {
  if (deck.run.accuracy) throw std::logic_error("run.accuracy must be applied before the scene is built");
  if (deck.bodies.empty())
    throw DeckError(fmt::format("{}: body: expected at least one [[body]], found none. Add one.", deck.file));
  const std::vector<FilledBody> bodies = fill_bodies(deck);
  check_overlap(deck, bodies);

  Scene scene;
  for (const FilledBody& b : bodies) scene.body_files.push_back(b.shape.file ? b.shape.file->contents : "");
  const double support = 2 * largest_smoothing_length(deck, bodies);
  scene.skin =
      deck.particles.kernel_frame == KernelFrame::initial ? 0 : deck.particles.skin * support; // nobody moves
  scene.cutoff = support + scene.skin;
  for (const FilledBody& b : bodies)
    if (b.points.spacing > 0 && (scene.spacing == 0 || b.points.spacing < scene.spacing))
      scene.spacing = b.points.spacing, scene.lattice = lattice_of(b);

  scene.hex_diagonal = largest_diagonal(bodies);
  check_freeze(deck, scene);
  const Faces faces = collect_faces(deck, bodies, scene.cutoff);
  const std::vector<TiedPoint> tied = tie_bodies(deck, bodies, scene.cutoff);
  scene.materials = make_materials(deck, bodies);
  scene.particles = make_particles(deck, bodies, tied, faces);
  scene.hexes = make_hex_mesh(deck, bodies, faces);
  std::vector<int> hex_body;
  for (const FilledBody& b : bodies) hex_body.insert(hex_body.end(), b.hexes.hex.size(), b.row);
  scene.hex_body = upload("hex_body", hex_body);
  scene.contact_groups = make_contact_groups(deck, bodies);
  scene.conversion = make_conversion(deck, bodies, faces, scene.hexes, scene.cutoff);
  scene.tie = make_tie(tied, scene.hexes);
  scene.tie.row = upload<IndexField>("tie.row", scene.tie.count,
                                     [&](auto& f, int k) { f(k) = scene.particles.count + k; });
  set_stress_shares(scene.hexes, stress_shares(bodies, scene.cutoff));
  scene.ghost_planes = faces.planes;
  scene.node_transforms = upload<TransformTable>("node_transforms", int(faces.transforms.size()),
                                                 [&](auto& f, int t) { f(t) = faces.transforms[t]; });
  scene.constraints = upload<ConstraintTable>("constraints", int(faces.constraints.size()),
                                              [&](auto& f, int c) { f(c) = faces.constraints[c]; });
  scene.held_rows = make_held_rows(faces);
  scene.heated_faces = upload<HeatedFaces>("heated_faces", int(faces.heated.size()),
                                           [&](auto& f, int k) { f(k) = faces.heated[std::size_t(k)]; });
  scene.heated_nodes = make_heated_nodes(bodies, faces);
  if (deck.tool) {
    add_tool(deck, bodies, scene);
    check_tool_outside(deck, scene);
  }
  return scene;
}

} // namespace swarf
