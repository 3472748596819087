// A scene built in C++ and stepped by another program: a bar flies onto a wall, and its stress is read back.
// Behind the wave that runs up the bar it is rho c v, c = sqrt(E / rho) (e.g. Graff, Wave Motion in Elastic
// Solids, 1975, 2.4).
#include "src/output/frame.hpp"
#include "src/simulation/simulation.hpp"
#include "swarf/config.hpp"
#include <cmath>
#include <cstdio>

namespace {

swarf::Deck struck_bar(const char* method, double length, double speed) {
  swarf::Deck deck = swarf::read_deck(method);
  swarf::BodyDeck& bar = deck.bodies[0];
  bar.size = {length, 2e-3, 2e-3};
  bar.velocity = {-speed, 0, 0};
  bar.faces = {{"x_min", swarf::FaceKind::fixed, {}}};
  return deck;
}

int run(const char* method) {
  constexpr double length = 0.1, speed = 1; // m, m/s
  const swarf::Deck deck = struck_bar(method, length, speed);
  const swarf::MaterialDeck& steel = deck.materials[0];
  const double c = std::sqrt(steel.youngs_modulus.value / steel.density);
  const double expected = -steel.density * c * speed;

  swarf::Simulation simulation(deck);
  simulation.start();
  while (simulation.time() < swarf::end_time_of(deck)) {
    simulation.step();
    if (simulation.steps_to_check() <= 0) simulation.check();
  }

  // Of all fields, on the host: one row a hex. The front has come to c t; we look well behind it.
  const swarf::Scene& scene = simulation.scene();
  const swarf::FrameHexes hexes =
      swarf::copy_frame(scene.particles, scene.hexes, scene.tool, simulation.pose()).hexes;
  double sum = 0;
  int count = 0;
  for (std::size_t e = 0; 8 * e < hexes.connectivity.size(); ++e) {
    const double x = double(hexes.position[3 * std::size_t(hexes.connectivity[8 * e])]);
    if (x > 0.2 * c * simulation.time() && x < 0.7 * c * simulation.time())
      sum += double(hexes.state.stress[6 * e]), ++count;
  }
  const double stress = sum / count;
  std::printf("swarf %s, %d-bit reals: %ld steps, %d hexes, stress %.4g MPa, theory %.4g MPa\n",
              SWARF_CONFIG_VERSION, SWARF_CONFIG_REAL_BITS, simulation.step_count(), count, stress / 1e6,
              expected / 1e6);
  return std::abs(stress / expected - 1) < 0.02 ? 0 : 1; // false also if nothing was found
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: struck_bar METHOD.toml\n"), 2;
  const Kokkos::ScopeGuard kokkos;
  try {
    return run(argv[1]);
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 1;
  }
}
