// Hertz's contact: a rigid sphere presses, without friction, on an elastic layer that is bonded to a rigid
// base. The reference is Hertz with the layer's finite thickness: Dimitriadis, Horkay, Maresca, Kachar &
// Chadwick (2002), Biophys. J. 82, 2798: F = 4/3 E/(1-nu^2) sqrt(R) d^(3/2) times a series in chi = sqrt(R d)
// / thickness.
#include "src/tool/geometry.hpp"
#include "tests/verification/case.hpp"
#include "tests/verification/point_masses.hpp"
#include <fmt/format.h>
#include <unistd.h>

using namespace swarf;
using namespace swarf::test;

namespace {

// Lengths in units of the final contact radius a.
constexpr double a = 10 * um, R = 50 * a, depth = a * a / R, thickness = 3 * a, width = 7 * a;
constexpr double E = 110e9, nu = 0.33;

double layer_force(double d, double layer_thickness) {
  if (!(d > 0)) return 0;
  const double chi = std::sqrt(R * d) / layer_thickness;
  const double alpha = -(1.2876 - 1.4678 * nu + 1.3442 * nu * nu) / (1 - nu);
  const double beta = (0.6387 - 1.0277 * nu + 1.5164 * nu * nu) / (1 - nu);
  const double a2 = alpha * alpha, p2 = pi * pi;
  const double series = 1 - 2 * alpha / pi * chi + 4 * a2 / p2 * chi * chi -
                        8 / (p2 * pi) * (a2 * alpha + 4 * p2 / 15 * beta) * chi * chi * chi +
                        16 * alpha / (p2 * p2) * (a2 * alpha + 3 * p2 / 5 * beta) * std::pow(chi, 4);
  return 4.0 / 3 * E / (1 - nu * nu) * std::sqrt(R) * std::pow(d, 1.5) * series;
}

// The pole of a sphere down to 4 a from the axis, closed by a lid; the lowest point is the origin.
std::string write_cap() {
  const int rings = 100, around = 120;
  FacetSurface s;
  s.vertices = {{0, 0, 0}};
  for (int k = 1; k <= rings; ++k)
    for (int i = 0; i < around; ++i) {
      const double r = 4 * a * k / rings, angle = 2 * pi * i / around;
      s.vertices.push_back({r * std::cos(angle), r * std::sin(angle), R - std::sqrt(R * R - r * r)});
    }
  const auto at = [&](int k, int i) { return 1 + (k - 1) * around + i % around; };
  const int lid = int(s.vertices.size());
  s.vertices.push_back({0, 0, a});
  for (int i = 0; i < around; ++i) {
    s.facets.push_back({0, at(1, i + 1), at(1, i)});
    for (int k = 1; k < rings; ++k) {
      s.facets.push_back({at(k, i), at(k, i + 1), at(k + 1, i)});
      s.facets.push_back({at(k, i + 1), at(k + 1, i + 1), at(k + 1, i)});
    }
    s.facets.push_back({lid, at(rings, i), at(rings, i + 1)});
  }
  const auto file =
      std::filesystem::temp_directory_path() / ("swarf_cap_" + std::to_string(getpid()) + ".stl");
  write_stl(s, file.string());
  return file.string();
}

// A quarter; `cells` per contact radius.
Deck layer(const std::string& fill, int cells, const std::string& file) {
  Deck deck = default_deck();
  deck.materials[0].youngs_modulus = E, deck.materials[0].poissons_ratio = nu;
  deck.bodies = {block("layer", fill, {0, 0, -thickness}, {width, width, thickness}, a / cells)};
  deck.bodies[0].faces = {
      {"x_min", FaceKind::symmetric, {}}, {"y_min", FaceKind::symmetric, {}}, {"z_min", FaceKind::fixed, {}}};
  deck.tool = ToolDeck(ToolKind::stl);
  deck.tool->file = file, deck.tool->file_scale = 1;
  const double c = std::sqrt(E / deck.materials[0].density);
  deck.tool->velocity = {0, 0, -depth / (30 * thickness / c)};
  deck.output.force_scale = 4;
  return deck;
}

struct Press {
  std::vector<double> tool, surface, force; // depth of the tool's pole and of the hexes' surface, m; N
};

// How far the node at the axis has sunk.
double sunk(const Scene& scene, double spacing) {
  const auto x = host_copy(scene.hexes.position);
  for (int n = 0; n < scene.hexes.nodes; ++n)
    if (std::abs(double(x(n, 0))) + std::abs(double(x(n, 1))) < 1e-3 * spacing &&
        double(x(n, 2)) > -0.5 * spacing)
      return -double(x(n, 2));
  return 0;
}

Press press(const Deck& deck) {
  Simulation simulation(deck);
  simulation.start();
  Press p;
  const double speed = -deck.tool->velocity[2];
  double half = 0;
  advance(simulation, depth / speed, [&] {
    const double t = simulation.time();
    p.force.push_back(simulation.take_sample().force[2]);
    p.tool.push_back(speed * 0.5 * (t + half));
    half = t;
    p.surface.push_back(sunk(simulation.scene(), *deck.bodies[0].spacing));
  });
  return p;
}

// Over the second half of the way: the mean ratio of the force to the reference's at that depth.
double mean_ratio(const std::vector<double>& force, const std::vector<double>& depth_of,
                  double layer_thickness) {
  double sum = 0, count = 0;
  for (std::size_t k = force.size() / 2; k < force.size(); ++k)
    sum += force[k] / layer_force(depth_of[k], layer_thickness), count += 1;
  return sum / count;
}

} // namespace

// The material between a particle and its surface is in no pair of particles: the contact's spring stands for
// it. With a stiff one the same layer of particles is 9 % too stiff at 4 cells.
TEST(HertzLong, SphereOnElasticLayer) {
  const std::string file = write_cap();
  const char* const source = "Hertz, with the finite thickness of Dimitriadis et al. 2002";
  Curve curve{"hertz",
              "Rigid sphere on an elastic layer, 4 cells per contact radius",
              "depth / last depth",
              "force, N",
              {{"Hertz, finite thickness", {}, {}, true}}};
  for (int k = 0; k <= 50; ++k)
    curve.series[0].x.push_back(k / 50.0),
        curve.series[0].y.push_back(layer_force(depth * k / 50, thickness));
  for (const std::string fill : {"hexes", "particles"}) {
    const std::string name = "8 Hertz, " + fill;
    const bool is_particles = fill == "particles";
    for (const int cells : {2, 3, 4}) {
      const std::string parameters = fmt::format("{} cells per contact radius, shipped defaults", cells);
      const Press p = press(layer(fill, cells, file));
      const double by_tool = mean_ratio(p.force, p.tool, thickness);
      const char* const coarse =
          "the spring of a node, 1 mass / dt^2, gives way: of first order in spacing / contact radius";
      report({name, "force / reference, by the depth of the tool", parameters, 1, "", source, by_tool,
              std::abs(by_tool - 1), 0.05, false, is_particles || cells > 2 ? "" : coarse});
      if (cells < 4) continue;
      Series series{fill, p.tool, p.force};
      for (double& x : series.x) x /= depth;
      curve.series.push_back(series);
      if (is_particles) continue; // their surface is where the tool is
      const double by_surface = mean_ratio(p.force, p.surface, thickness);
      report({name, "force / reference, by the depth of the surface", parameters, 1, "", source, by_surface,
              std::abs(by_surface - 1), 0.05});
    }
  }
  write_curve(curve);
  std::filesystem::remove(file);
}
