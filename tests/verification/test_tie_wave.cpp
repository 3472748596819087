// A plane longitudinal pulse runs from particles through the tie into hexes of one to three times the
// spacing. In the continuum nothing is reflected: both sides have the same impedance. No viscosity, no other
// damping.
#include "src/simulation.hpp"
#include "tests/src/scene_decks.hpp"
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double spacing = 10 * um;
constexpr double length = 60 * spacing; // of each side
constexpr double speed = 1;             // m/s, of the pulse's crest

Deck bar(int ratio) {
  Deck deck = empty_deck();
  const double wide = 6 * spacing;
  deck.bodies = {block("zone", "particles", {0, 0, 0}, {wide, wide, length}, spacing),
                 block("bulk", "hexes", {0, 0, -length}, {wide, wide, length}, ratio * spacing)};
  deck.bodies[0].tie = "bulk";
  for (BodyDeck& b : deck.bodies)
    for (const char* face : {"x_min", "x_max", "y_min", "y_max"}) b.faces.push_back({face, "periodic", {}});
  deck.particles.viscosity_form = "reconstructed";
  deck.hexes.hourglass_coefficient = 0.05;
  deck.run.courant = 0.3;
  return deck;
}

// u = f(z + c t), v = c f': strain v / c, stress (lambda + 2 mu) v / c = rho c v, across it lambda / (lambda
// + 2 mu) of that. A Gaussian of half width `width` in the middle of the particles.
void start_pulse(const Scene& scene, double width) {
  const Particles& p = scene.particles;
  const auto table = host_copy(scene.materials);
  const Material m = table(0);
  const double c = double(longitudinal_wave_speed(m)), modulus = double(m.density) * c * c;
  const double lateral = (modulus - 2 * double(m.shear_modulus)) / modulus;
  const auto x = host_copy(p.position), v = host_copy(p.velocity);
  const auto stress = host_copy(p.points.stress);
  const auto density = host_copy(p.points.density);
  for (int i = 0; i < p.count; ++i) {
    const double far = (double(x(i, 2)) - 0.5 * length) / width, crest = -speed * std::exp(-far * far);
    const double axial = double(m.density) * c * crest;
    v(i, 2) = Real(crest);
    store_symmetric(stress, i, {Real(lateral * axial), Real(lateral * axial), Real(axial), 0, 0, 0});
    density(i) = Real(double(m.density) * (1 - crest / c));
  }
  Kokkos::deep_copy(p.velocity, v), Kokkos::deep_copy(p.points.stress, stress);
  Kokkos::deep_copy(p.points.density, density);
}

struct Outcome {
  double reflected_speed = 0;  // largest |v_z| left in the particles, over the crest
  double reflected_energy = 0; // kinetic, over that of the pulse
  double passed_speed = 0;     // largest |v_z| in the hexes, over the crest
  double momentum_error = 0, energy_error = 0;
};

double momentum_of(const Scene& scene) {
  return double(sum_particles(scene.particles, 1).momentum.z + sum_hexes(scene.hexes, 1).momentum.z);
}

Outcome run(int ratio, double width) {
  Simulation simulation(bar(ratio));
  const Scene& scene = simulation.scene();
  start_pulse(scene, width);
  simulation.start();
  const double momentum = momentum_of(scene), kinetic = double(sum_particles(scene.particles, 1).kinetic);
  const double c = double(longitudinal_wave_speed(host_copy(scene.materials)(0)));
  while (simulation.time() < length / c) { // the crest stops in the middle of the hexes
    simulation.step();
    if (simulation.steps_to_check() <= 0) simulation.check();
  }
  Outcome o;
  const auto v = host_copy(scene.particles.velocity), u = host_copy(scene.hexes.velocity);
  for (int i = 0; i < scene.particles.count; ++i)
    o.reflected_speed = std::max(o.reflected_speed, std::abs(double(v(i, 2))) / speed);
  for (int a = 0; a < scene.hexes.nodes; ++a)
    o.passed_speed = std::max(o.passed_speed, std::abs(double(u(a, 2))) / speed);
  o.reflected_energy = double(sum_particles(scene.particles, 1).kinetic) / kinetic;
  o.momentum_error = momentum_of(scene) / momentum - 1;
  // The pulse's elastic energy equals its kinetic one; sample() counts from the start.
  o.energy_error = simulation.sample().residual / (2 * kinetic);
  return o;
}

} // namespace

// Undamped and for long: the pulse crosses the tie ten times, and what energy the tie gave or took would
// show.
TEST(TieWave, EnergyIsKeptForLong) {
  for (const int ratio : {1, 2, 3}) {
    Simulation simulation(bar(ratio));
    start_pulse(simulation.scene(), 6 * spacing);
    const double kinetic = double(sum_particles(simulation.scene().particles, 1).kinetic);
    simulation.start();
    const double c = double(longitudinal_wave_speed(host_copy(simulation.scene().materials)(0)));
    while (simulation.time() < 6 * length / c) {
      simulation.step();
      if (simulation.steps_to_check() <= 0) simulation.check();
    }
    EXPECT_NEAR(simulation.sample().residual / (2 * kinetic), 0, 1e-3) << ratio;
  }
}

TEST(TieWave, PulsePassesFromParticlesToHexes) {
  std::printf("half width / spacing, hex / spacing: reflected speed, reflected energy, passed speed, "
              "momentum, energy\n");
  for (const double width : {6.0, 12.0})
    for (const int ratio : {1, 2, 3}) {
      const Outcome o = run(ratio, width * spacing);
      std::printf("%4.0f %4d: %.4f %.2e %.4f %.1e %.1e\n", width, ratio, o.reflected_speed,
                  o.reflected_energy, o.passed_speed, o.momentum_error, o.energy_error);
      EXPECT_LT(o.reflected_energy, width == 6 ? 0.01 : 0.001);
      EXPECT_NEAR(o.passed_speed, 1, width == 6 ? 0.1 : 0.01); // the mesh disperses short pulses
      EXPECT_NEAR(o.momentum_error, 0, 1e-12);
      EXPECT_NEAR(o.energy_error, 0, 1e-4);
    }
}
