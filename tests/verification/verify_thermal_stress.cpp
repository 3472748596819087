// 12. Stress that heat makes: a free bar that is warmed, one between two walls, and one whose walls have two
// temperatures. References: a strain of exp(alpha dT) - 1 without stress; -E alpha dT where the ends do not
// move and the sides are free; -alpha times the mean of E dT, where E falls with temperature.
#include "tests/verification/case.hpp"
#include "tests/verification/drive.hpp"

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double E = 110e9, nu = 0.33, alpha = 8.7e-6; // Ti-6Al-4V; Demiral & Mamedov (2022), table 1
constexpr double cold = 300, rise = 200, length = 40 * um, width = 16 * um;
const std::string source = "Timoshenko & Goodier, Theory of Elasticity, ch. 13";

struct Bar {
  std::string fill; // particles | hexes | hybrid
  std::string frame = "current";
  bool held = false;    // between walls that let it slide
  bool softens = false; // E(T)
  std::string text() const { return fill + (frame == "initial" ? ", total Lagrangian" : ""); }
};

Deck deck_of(const Bar& bar) {
  Deck deck = shipped_defaults();
  deck.materials = {elastic_material(4430, E, nu)};
  deck.materials[0].thermal_expansion = alpha;
  if (bar.softens) deck.materials[0].youngs_modulus.points = {{cold, E}, {cold + rise, 0.7 * E}};
  deck.particles.kernel_frame = value_of_word<KernelFrame>(bar.frame);
  if (bar.frame == "initial") deck.particles.pressure_diffusion = 0;
  const bool hybrid = bar.fill == "hybrid";
  deck.bodies = {block("bar", hybrid ? "particles" : bar.fill, {0, 0, 0},
                       {hybrid ? 0.5 * length : length, width, width}, 4 * um)};
  if (hybrid) {
    deck.bodies.push_back(block("rest", "hexes", {0.5 * length, 0, 0}, {0.5 * length, width, width}, 4 * um));
    deck.bodies[0].tie = "rest";
  }
  for (BodyDeck& body : deck.bodies) body.temperature = cold;
  if (bar.held)
    hold(deck.bodies.front(), "symmetric", {"x_min"}), hold(deck.bodies.back(), "symmetric", {"x_max"});
  return deck;
}

void set_temperature(const Scene& scene, double T) {
  Kokkos::deep_copy(scene.particles.points.temperature, Real(T));
  Kokkos::deep_copy(scene.hexes.points.temperature, Real(T));
}

struct Extent {
  double length; // m, between the means of the outer layers
  double stress; // Pa, mean xx over the volume
};

Extent extent_of(const Scene& scene) {
  double low = 1e9, high = -1e9, volume = 0, sum = 0;
  const auto look = [&](const VectorField& position, int rows) {
    const auto x = host_copy(position);
    for (int i = 0; i < rows; ++i)
      low = std::min(low, double(x(i, 0))), high = std::max(high, double(x(i, 0)));
  };
  const auto add = [&](const MaterialPoints& p, int rows) {
    const auto stress = host_copy(p.stress);
    const auto mass = host_copy(p.mass), density = host_copy(p.density);
    for (int i = 0; i < rows; ++i) {
      const double V = double(mass(i)) / double(density(i));
      volume += V, sum += V * double(stress(i, 0));
    }
  };
  const int particles = scene.particles.count;
  look(scene.particles.position, particles), look(scene.hexes.position, scene.hexes.nodes);
  add(scene.particles.points, particles + scene.particles.tied),
      add(scene.hexes.points, scene.hexes.points.count);
  return {high - low, sum / volume};
}

struct Outcome {
  double strain, stress;
};

// Warmed as a half wave of a cosine, so slowly that no wave is left: 60 transits, and 40 to come to rest.
Outcome warm(const Bar& bar) {
  Simulation simulation(deck_of(bar));
  simulation.start();
  const double before = extent_of(simulation.scene()).length;
  const double transit = length / std::sqrt(E / 4430), ramp = 60 * transit;
  run_until(simulation, 100 * transit, [&] {
    const double share = std::min(1.0, simulation.time() / ramp);
    set_temperature(simulation.scene(), cold + rise * 0.5 * (1 - std::cos(pi * share)));
  });
  const Extent now = extent_of(simulation.scene());
  return {now.length / before - 1, now.stress};
}

void free_bar(const Bar& bar, double allowed) {
  const Outcome o = warm(bar);
  const double strain = std::expm1(alpha * rise), scale = E * alpha * rise;
  const std::string name = "12 free bar, " + bar.text(), how = "200 K warmer, 10 x 4 x 4 cells";
  report({name, "strain over exp(alpha dT) - 1", how, 1, "", source, o.strain / strain,
          relative_error(o.strain, strain), allowed});
  report({name, "mean stress over E alpha dT", how, 0, "", source, o.stress / scale,
          std::abs(o.stress) / scale, allowed, true});
}

void held_bar(const Bar& bar, double allowed) {
  Bar held = bar;
  held.held = true;
  const double stress = -(bar.softens ? 0.7 : 1) * E * alpha * rise;
  const Outcome o = warm(held);
  report({"12 held bar, " + bar.text() + (bar.softens ? ", softens" : ""), "mean stress along the bar",
          "200 K warmer, ends held, sides free" + std::string(bar.softens ? ", E falls to 0.7 E" : ""),
          stress / 1e6, "MPa", source, o.stress / 1e6, relative_error(o.stress, stress), allowed});
}

} // namespace

TEST(VerifyThermalStress, FreeBarOfHexes) { free_bar({"hexes"}, 1e-4); }
TEST(VerifyThermalStress, FreeBarOfParticles) { free_bar({"particles"}, 1e-3); }
TEST(VerifyThermalStress, FreeBarInTheInitialFrame) { free_bar({"particles", "initial"}, 1e-3); }
TEST(VerifyThermalStress, FreeBarThroughTheTie) { free_bar({"hybrid"}, 1e-3); }
TEST(VerifyThermalStress, HeldBarOfHexes) { held_bar({"hexes"}, 1e-3); }
TEST(VerifyThermalStress, HeldBarOfParticles) { held_bar({"particles"}, 1e-2); }
TEST(VerifyThermalStress, HeldBarInTheInitialFrame) { held_bar({"particles", "initial"}, 1e-2); }
TEST(VerifyThermalStress, HeldBarThroughTheTie) { held_bar({"hybrid"}, 1e-2); }
TEST(VerifyThermalStress, SofteningBarOfHexes) { held_bar({"hexes", "current", false, true}, 1e-3); }
TEST(VerifyThermalStress, SofteningBarOfParticles) { held_bar({"particles", "current", false, true}, 1e-2); }

namespace {

// Conduction brings the heat: nu = 0, all sides on planes, x_min at 500 K and x_max at 300 K until nothing
// changes. The stress is one along the bar, -E alpha times the mean rise of 100 K.
double stress_between_two_temperatures(const std::string& fill) {
  Bar bar{fill};
  bar.held = true;
  Deck deck = deck_of(bar);
  deck.materials[0].poissons_ratio = 0, deck.materials[0].conductivity = 7.2;
  deck.materials[0].specific_heat = 526.3;
  const std::vector<const char*> sides{"y_min", "y_max", "z_min", "z_max"};
  for (BodyDeck& body : deck.bodies) hold(body, "symmetric", sides);
  const auto face = [](BodyDeck& body, const char* name, double T) { // mirrors let no heat through
    for (FaceDeck& f : body.faces)
      if (f.face == name) f.temperature = T;
  };
  face(deck.bodies.front(), "x_min", cold + rise), face(deck.bodies.back(), "x_max", cold);
  deck.run.mass_factor = 1e6;
  Simulation simulation(deck);
  simulation.start();
  run_until(simulation, 1.2e-3, [] {}); // 2.3 L^2 / alpha: what is left of the slowest mode is 1e-10
  return extent_of(simulation.scene()).stress;
}

void two_temperatures(const std::string& fill) {
  const double reference = -E * alpha * 0.5 * rise, stress = stress_between_two_temperatures(fill);
  report({"12 bar between 500 and 300 K, " + fill, "mean stress along the bar",
          "10 x 4 x 4 cells, conduction at rest, nu = 0", reference / 1e6, "MPa", source, stress / 1e6,
          relative_error(stress, reference), 0.01});
}

} // namespace

TEST(VerifyThermalStress, HexesBetweenTwoTemperatures) { two_temperatures("hexes"); }
TEST(VerifyThermalStress, ParticlesBetweenTwoTemperatures) { two_temperatures("particles"); }
TEST(VerifyThermalStress, HybridBetweenTwoTemperatures) { two_temperatures("hybrid"); }
