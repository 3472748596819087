// A plane longitudinal pulse runs from particles through the tie into hexes of one to three times the
// spacing. In the continuum nothing is reflected: both sides have the same impedance. No viscosity, no other
// damping. What is reflected is the difference to a bar of particles only, so that the dispersion of the
// particles does not count.
#include "src/simulation/simulation.hpp"
#include "tests/src/scene_decks.hpp"
#include "tests/verification/case.hpp"
#include <algorithm>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double side = 2e-3, spacing = side / 6;
constexpr double length = 60 * spacing; // of each half
constexpr double crest = 1;             // m/s
constexpr double E = 3e11, density = 7800;
const double speed = std::sqrt(E / density); // nu = 0: waves of the bar, the plate and the bulk are one

// Half particles, z > 0, half hexes of `ratio` spacings; ratio 0: particles in both.
Deck bar(int ratio) {
  Deck deck = empty_deck();
  deck.materials[0].density = density, deck.materials[0].youngs_modulus = E;
  deck.materials[0].poissons_ratio = 0;
  if (ratio == 0) {
    deck.bodies = {block("zone", "particles", {0, 0, -length}, {side, side, 2 * length}, spacing)};
  } else {
    deck.bodies = {block("zone", "particles", {0, 0, 0}, {side, side, length}, spacing),
                   block("bulk", "hexes", {0, 0, -length}, {side, side, length}, ratio * spacing)};
    deck.bodies[0].tie = "bulk";
  }
  for (BodyDeck& b : deck.bodies)
    for (const char* face : {"x_min", "x_max", "y_min", "y_max"})
      b.faces.push_back({face, FaceKind::periodic, {}});
  deck.hexes.hourglass_coefficient = 0.05;
  deck.run.courant = ratio == 1 ? 0.4 : 0.4 / 1.2; // dt = 0.4 spacing / speed in all
  return deck;
}

// u = f(z + c t), v = c f': strain v / c, stress E v / c. Half a sine in the middle of the particles.
void start_pulse(const Scene& scene, double pulse) {
  const Particles& p = scene.particles;
  const auto x = host_copy(p.position), v = host_copy(p.velocity);
  const auto stress = host_copy(p.points.stress);
  const auto rho = host_copy(p.points.density);
  for (int i = 0; i < p.count; ++i) {
    const double s = (double(x(i, 2)) - 0.5 * length) / pulse;
    if (std::abs(s) > 0.5) continue;
    const double v_z = -crest * std::cos(pi * s);
    v(i, 2) = Real(v_z);
    store_symmetric(stress, i, {0, 0, Real(E * v_z / speed), 0, 0, 0});
    rho(i) = Real(density * (1 - v_z / speed));
  }
  Kokkos::deep_copy(p.velocity, v), Kokkos::deep_copy(p.points.stress, stress);
  Kokkos::deep_copy(p.points.density, rho);
}

double momentum_of(const Scene& scene) {
  return double(sum_particles(scene.particles, 1).momentum.z + sum_hexes(scene.hexes, 1).momentum.z);
}

struct Outcome {
  std::vector<double> profile; // v_z of the layers of particles in z > 0, m/s, 0 first
  double passed = 0;           // largest |v_z| in z < 0, over the crest
  double momentum_error = 0, energy_error = 0;
};

// Until the crest would be in the middle of the other half.
// One step for all, so that what it disperses is no difference between them.
Outcome run(int ratio, double pulse) {
  Deck deck = bar(ratio);
  Simulation trial(deck);
  trial.start();
  deck.run.courant *= 0.36 * spacing / speed / trial.dt();
  Simulation simulation(deck);
  const Scene& scene = simulation.scene();
  start_pulse(scene, pulse);
  simulation.start();
  const double momentum = momentum_of(scene), kinetic = simulation.initial_kinetic();
  while (simulation.time() < length / speed) {
    simulation.step();
    if (simulation.steps_to_check() <= 0) simulation.check();
  }
  Outcome o;
  o.profile.assign(60, 0);
  const auto x = host_copy(scene.particles.position), v = host_copy(scene.particles.velocity),
             u = host_copy(scene.hexes.velocity);
  for (int i = 0; i < scene.particles.count; ++i) {
    if (x(i, 2) > 0)
      o.profile[std::size_t(std::min(59.0, double(x(i, 2)) / spacing))] += double(v(i, 2)) / 36;
    else
      o.passed = std::max(o.passed, std::abs(double(v(i, 2))) / crest);
  }
  for (int a = 0; a < scene.hexes.nodes; ++a)
    o.passed = std::max(o.passed, std::abs(double(u(a, 2))) / crest);
  o.momentum_error = momentum_of(scene) / momentum - 1;
  // The pulse's elastic energy equals its kinetic one; take_sample() counts from the start.
  o.energy_error = simulation.take_sample().residual / (2 * kinetic);
  return o;
}

// What the best junction of two chains of masses and springs reflects of the pulse's energy: spacing d and
// ratio d, one impedance rho c in the continuum, rho c cos(k d / 2) in the chain. Waves above the cut-off of
// the coarser chain, omega = 2 c / (ratio d), come back whole.
double chain_reflection(double pulse, int ratio) {
  double reflected = 0, all = 0;
  const int n = 20000;
  for (int m = 0; m < n; ++m) {
    const double k = (m + 0.5) / n * pi / spacing, a = 0.5 * k * pulse;
    const double amplitude = std::cos(a) / (pi * pi / 4 - a * a); // spectrum of half a sine
    const double s = std::sin(0.5 * k * spacing), coarse = ratio * s;
    const double Z1 = std::sqrt(1 - s * s), Z2 = coarse < 1 ? std::sqrt(1 - coarse * coarse) : 0;
    const double R = (Z1 - Z2) / (Z1 + Z2);
    all += amplitude * amplitude, reflected += R * R * amplitude * amplitude;
  }
  return reflected / all;
}

struct Bound {
  double amplitude, energy;
};
const Bound bounds[2][3] = {{{0.08, 0.005}, {0.1, 0.015}, {0.22, 0.055}},
                            {{0.045, 0.001}, {0.055, 0.0016}, {0.085, 0.0042}}};

} // namespace

TEST(TiePulse, PassesFromParticlesToHexes) {
  for (const int cells : {10, 20}) {
    const Outcome alone = run(0, cells * spacing);
    for (const int ratio : {1, 2, 3}) {
      const Outcome o = run(ratio, cells * spacing);
      double amplitude = 0, energy = 0; // over crest; over crest^2 times half the pulse's length
      for (std::size_t k = 0; k < 60; ++k) {
        const double v = (o.profile[k] - alone.profile[k]) / crest;
        amplitude = std::max(amplitude, std::abs(v)), energy += v * v / (0.5 * cells);
      }
      const double unavoidable = chain_reflection(cells * spacing, ratio);
      char how[96];
      std::snprintf(how, sizeof how, "pulse of %d spacings, hexes of %d", cells, ratio);
      // The tie may add 1 % of the energy (10 % of the amplitude) to what the two meshes reflect.
      report({"1 bar wave, through the tie", "reflected share of the pulse's energy", how, unavoidable, "",
              "two chains of masses and springs joined: R = (Z1 - Z2)/(Z1 + Z2), Z = rho c cos(k d/2)",
              energy, energy - unavoidable, 0.01, true});
      // Measured 0.32 and 0.06, 1.1 and 0.12, 2.3 and 0.32 % of the energy for pulses of 10 and 20 spacings:
      // no law, kept as bounds so that a change of the tie shows. Three spacings to a hex leave a pulse of
      // ten three hexes, and a mesh that coarse hardly carries it.
      const Bound& bound = bounds[cells / 10 - 1][ratio - 1];
      EXPECT_LT(amplitude, bound.amplitude);
      EXPECT_LT(energy, bound.energy);
      // Measured 0.005 .. 0.08; 0.13 of the crest into three hexes.
      EXPECT_NEAR(o.passed, alone.passed, ratio == 3 && cells == 10 ? 0.15 : 0.1);
      EXPECT_NEAR(o.momentum_error, 0, sizeof(Real) == 8 ? 1e-10 : 1e-4);
      EXPECT_NEAR(o.energy_error, 0, 5e-3);
    }
  }
}
