// 9. Conduction in particles, in hexes and from one to the other. References: Carslaw & Jaeger, Conduction of
// Heat in Solids (1959), ch. 2: a half space whose surface is held, and one with a constant flux through it.
// The held surface is the middle plane of two halves at opposite temperatures.
#include "src/simulation/simulation.hpp"
#include "tests/src/scene_decks.hpp"
#include "tests/verification/case.hpp"
#include <cmath>
#include <functional>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double k = 7.2, rho = 4430, c = 526.3, alpha = k / (rho * c); // Ti-6Al-4V: 3.0881e-6 m2/s
constexpr double end = 10e-6, depth = 10 * um, reach = 60 * um;         // five diffusion lengths
const std::string source = "Carslaw & Jaeger 1959, ch. 2";

enum class Filling { particles, hexes, hybrid };

// The mass factor only lengthens the mechanical step to that of conduction: nothing moves.
Deck slab(Filling fill, double spacing) {
  Deck deck = empty_deck();
  deck.materials[0].conductivity = k;
  const double side = 4 * spacing;
  const auto half = [&](const char* name, const char* filled, double from, double T) {
    BodyDeck b = block(name, filled, {from, 0, 0}, {reach, side, side}, spacing);
    b.temperature = T;
    for (const char* face : {"y_min", "y_max", "z_min", "z_max"})
      b.faces.push_back({face, FaceKind::periodic, {}});
    return b;
  };
  if (fill == Filling::hexes) {
    deck.bodies = {half("slab", "hexes", -reach, 300)};
    deck.bodies[0].size[0] = 2 * reach;
  } else {
    deck.bodies = {half("left", "particles", -reach, 301),
                   half("right", fill == Filling::hybrid ? "hexes" : "particles", 0, 299)};
    if (fill == Filling::hybrid) deck.bodies[0].tie = "right";
  }
  deck.run.courant = 0.3, deck.run.mass_factor = 1e7;
  Simulation trial(deck); // whole steps of conduction, as long as they may be, fill the time
  trial.start();
  const double stable = spacing * spacing / (12 * alpha);
  deck.run.courant *= end / std::ceil(end / stable) / trial.dt();
  return deck;
}

struct Profile {
  std::vector<double> x, T;

  // Between the two nearest planes.
  double at(double where) const {
    double low = -1e9, high = 1e9, T_low = 0, T_high = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (x[i] <= where && x[i] > low) low = x[i], T_low = T[i];
      if (x[i] > where && x[i] < high) high = x[i], T_high = T[i];
    }
    return T_low + (T_high - T_low) * (where - low) / (high - low);
  }
};

Profile profile_of(const Scene& scene) {
  Profile all;
  const auto add = [&](const VectorField& position, const ScalarField& temperature, int rows) {
    const auto x = host_copy(position);
    const auto T = host_copy(temperature);
    for (int i = 0; i < rows; ++i) all.x.push_back(x(i, 0)), all.T.push_back(T(i));
  };
  add(scene.particles.position, scene.particles.points.temperature, scene.particles.count);
  if (scene.hexes.nodes > 0) add(scene.hexes.position, scene.hexes.nodal_temperature, scene.hexes.nodes);
  return all;
}

double energy_of(const Scene& scene) {
  double sum = 0;
  const auto m = host_copy(scene.particles.points.mass), T = host_copy(scene.particles.points.temperature);
  for (int i = 0; i < scene.particles.count; ++i) sum += m(i) * c * T(i);
  if (scene.hexes.nodes == 0) return sum;
  const auto C = host_copy(scene.hexes.heat_capacity), nodal = host_copy(scene.hexes.nodal_temperature);
  for (int a = 0; a < scene.hexes.nodes; ++a) sum += C(a) * nodal(a);
  return sum;
}

void set_nodal_temperature(const Scene& scene, const std::function<double(double)>& T) {
  const auto x = host_copy(scene.hexes.position);
  const auto nodal = host_copy(scene.hexes.nodal_temperature), zero = host_copy(scene.hexes.nodal_heat);
  for (int a = 0; a < scene.hexes.nodes; ++a) nodal(a) = Real(T(x(a, 0))), zero(a) = 0;
  Kokkos::deep_copy(scene.hexes.nodal_temperature, nodal), Kokkos::deep_copy(scene.hexes.nodal_heat, zero);
  spread_temperature(scene.tie, scene.particles, scene.hexes, scene.materials);
}

void run(Simulation& simulation) {
  simulation.start();
  while (simulation.time() < end * (1 - 1e-9)) {
    simulation.step();
    if (simulation.steps_to_check() <= 0) simulation.check();
  }
}

// What is left of the step between the halves: T - 299 at `depth` to the right, erfc by theory.
void step_between_halves(Filling fill, const std::string& name) {
  std::array<double, 3> size{4 * um, 2 * um, 1 * um}, error{};
  const double reference = std::erfc(depth / (2 * std::sqrt(alpha * end)));
  for (std::size_t r = 0; r < 3; ++r) {
    Simulation simulation(slab(fill, size[r]));
    const Scene& scene = simulation.scene();
    if (fill == Filling::hexes)
      set_nodal_temperature(scene, [](double x) { return 300 - (x > 1e-9 ? 1 : x < -1e-9 ? -1 : 0); });
    const double before = energy_of(scene);
    run(simulation);
    const Profile now = profile_of(scene);
    const double right = now.at(depth) - 299, left = 301 - now.at(-depth);
    error[r] = std::max(std::abs(right - reference), std::abs(left - reference)) / reference;
    if (r < 2) continue;
    report({name, "temperature 10 um from the plane after 10 us, over the step", "spacing 1 um", reference,
            "K", source, right, error[r], 0.01});
    report({name, "energy kept", "spacing 1 um", 1, "", "conservation", energy_of(scene) / before,
            std::abs(energy_of(scene) / before - 1), 1e-12, true});
    if (fill != Filling::hybrid) continue;
    Series ours{"particles x < 0, hexes x > 0", now.x, now.T, false, true}, theory{"erfc", {}, {}, true};
    for (double& x : ours.x) x /= um;
    for (double x = -reach; x <= reach; x += um)
      theory.x.push_back(x / um), theory.y.push_back(300 - std::erf(x / (2 * std::sqrt(alpha * end))));
    write_curve({"conduction", "Two halves 2 K apart, after 10 us", "x [um]", "T [K]", {theory, ours}});
  }
  report_order(name, "temperature after a step", "spacing 4, 2, 1 um", size, error, 1, 0.3,
               "first order at a step");
}

} // namespace

TEST(VerifyConduction, StepInParticles) {
  step_between_halves(Filling::particles, "9 conduction, particles");
}
TEST(VerifyConduction, StepInHexes) { step_between_halves(Filling::hexes, "9 conduction, hexes"); }
TEST(VerifyConduction, StepThroughTheTie) {
  step_between_halves(Filling::hybrid, "9 conduction, through the tie");
}

// 1e9 W/m2 through the surface x = -reach of hexes warms it by 2 q sqrt(alpha t / pi) / k = 870.90 K in 10
// us.
TEST(VerifyConduction, FluxIntoHexes) {
  const double flux = 1e9, reference = 2 * flux / k * std::sqrt(alpha * end / pi);
  std::array<double, 3> size{4 * um, 2 * um, 1 * um}, error{};
  double ours = 0;
  for (std::size_t r = 0; r < 3; ++r) {
    Simulation simulation(slab(Filling::hexes, size[r]));
    const Scene& scene = simulation.scene();
    const auto x = host_copy(scene.hexes.position);
    const auto C = host_copy(scene.hexes.heat_capacity);
    double surface_capacity = 0;
    for (int a = 0; a < scene.hexes.nodes; ++a)
      if (x(a, 0) < -reach + 1e-9) surface_capacity += C(a);
    const double area = 16 * size[r] * size[r];
    const auto heat_surface = [&](double dt) {
      const auto T = host_copy(scene.hexes.nodal_temperature);
      for (int a = 0; a < scene.hexes.nodes; ++a)
        if (x(a, 0) < -reach + 1e-9) T(a) += Real(flux * area * dt / surface_capacity);
      Kokkos::deep_copy(scene.hexes.nodal_temperature, T);
      // the hexes follow their nodes, or the next step would take the difference for their own heat
      Kokkos::deep_copy(scene.hexes.nodal_heat, 0);
      spread_temperature(scene.tie, scene.particles, scene.hexes, scene.materials);
    };
    simulation.start();
    while (simulation.time() < end * (1 - 1e-9)) {
      simulation.step();
      heat_surface(simulation.dt()); // Euler's step: conduction has seen the temperatures before
      if (simulation.steps_to_check() <= 0) simulation.check();
    }
    ours = profile_of(scene).T[0] - 300;
    error[r] = relative_error(ours, reference);
  }
  report({"9 conduction, flux", "rise of the surface under 1e9 W/m2 in 10 us", "hexes, 1 um", reference, "K",
          source, ours, error[2], 0.01});
  report_order("9 conduction, flux", "rise of the surface", "hexes, 4, 2, 1 um", size, error, 1, 0.3,
               "first order: the flux enters half a cell");
}
