// Whole runs in which hexes become particles: a body under stress that rests, a wave, and a cut against the
// one with a band of particles.
#include "src/scene/hex_conversion.hpp"
#include "src/simulation/simulation.hpp"
#include "tests/support/run_program.hpp"
#include "tests/verification/drive.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;

namespace {

// Before start(): the hexes for which is_in(place of their first particle) holds are strained enough.
template <class Function>
void strain_hexes(const Scene& scene, Function&& is_in) {
  const auto strain = host_copy(scene.hexes.points.equivalent_plastic_strain);
  for (int e = 0; e < scene.hexes.points.count; ++e) strain(e) = is_in(scene.conversion->place(e, 0)) ? 1 : 0;
  Kokkos::deep_copy(scene.hexes.points.equivalent_plastic_strain, strain);
}

double largest_speed(const Scene& scene) {
  return double(std::max(sum_particles(scene.particles, 1).max_speed, sum_hexes(scene.hexes, 1).max_speed));
}

} // namespace

// Between mirrors a uniform stress is in balance, in hexes to round-off. A tie in the way leaves forces
// (TieScene.ConstantStressLeavesAMeasuredResidual: 0.08 of stress times area at most, with the motion that
// they start below 0.08 of stress / (rho c)), whether a deck builds it or a conversion does; three faces meet
// in a corner: sqrt(3) of it.
TEST(ConversionInMotion, AStressedBlockStaysAtRestButForTheTie) {
  constexpr double edge = 10 * um;
  const double c = std::sqrt(110e9 * (1 - 0.33) / (1 + 0.33) / (1 - 2 * 0.33) / 4430),
               scale = 6e8 / (4430 * c);
  for (const int converted : {0, 1, 2}) { // none, half of the block, a cube in its middle
    Deck deck = undamped();
    deck.materials = {elastic_material(4430, 110e9, 0.33)};
    deck.bodies = {block("work", "hexes", {0, 0, 0}, {10 * edge, 10 * edge, 10 * edge}, edge)};
    deck.bodies[0].convert_strain = 0.5;
    hold(deck.bodies[0], "symmetric", {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"});
    deck.run.end_time = 1, deck.run.courant = 0.3;
    Simulation simulation(deck);
    const Scene& scene = simulation.scene();
    strain_hexes(scene, [&](const Point& x) {
      if (converted < 2) return converted == 1 && x.x() < 5 * edge;
      return x.minCoeff() > 3 * edge && x.maxCoeff() < 7 * edge;
    });
    const auto stress = host_copy(scene.hexes.points.stress);
    for (int e = 0; e < scene.hexes.points.count; ++e)
      store_symmetric(stress, e, {Real(-4e8), Real(-5e8), Real(-6e8), 0, 0, 0});
    Kokkos::deep_copy(scene.hexes.points.stress, stress);
    simulation.start();
    EXPECT_EQ(scene.particles.count, converted == 0 ? 0 : converted == 1 ? 4000 : 512);
    double largest = 0;
    run_until(simulation, 20 * edge / c, [&] { largest = std::max(largest, largest_speed(scene)); });
    std::printf("%d particles: fastest %.3g of stress / (rho c)\n", scene.particles.count, largest / scale);
    EXPECT_LT(largest / scale, converted == 0 ? 1e-10 : 0.08 * std::sqrt(3.0));
    EXPECT_NEAR(simulation.take_sample().residual, 0, 1e-2 * 0.5 * 6e8 * 6e8 / 110e9 * 1e-12);
  }
}

namespace {

constexpr double side = 2e-3, spacing = side / 6, half_length = 60 * spacing, pulse = 20 * spacing;
constexpr double E = 3e11, density = 7800;
const double speed = std::sqrt(E / density); // nu = 0

// Hexes of two spacings; a pulse in the middle of z > 0 that runs to -z. As in verify_tie_pulse.cpp.
Simulation make_bar() {
  Deck deck = undamped();
  deck.materials = {elastic_material(density, E, 0)};
  deck.bodies = {block("bar", "hexes", {0, 0, -half_length}, {side, side, 2 * half_length}, 2 * spacing)};
  deck.bodies[0].convert_strain = 0.5;
  hold(deck.bodies[0], "periodic", {"x_min", "x_max", "y_min", "y_max"});
  deck.hexes.hourglass_coefficient = 0.05;
  deck.particles.hourglass_stiffness = 0;
  deck.run.end_time = 1, deck.run.courant = 0.4 / 1.2;
  return Simulation(deck);
}

double velocity_at(double z) {
  const double s = (z - 0.5 * half_length) / pulse;
  return std::abs(s) > 0.5 ? 0 : -std::cos(pi * s);
}

void start_pulse(const Scene& scene) {
  const HexMesh& m = scene.hexes;
  const auto x = host_copy(m.position), v = host_copy(m.velocity);
  for (int a = 0; a < m.nodes; ++a) v(a, 2) = Real(velocity_at(double(x(a, 2))));
  Kokkos::deep_copy(m.velocity, v);
  const auto stress = host_copy(m.points.stress);
  for (int e = 0; e < m.points.count; ++e) {
    double mean = 0;
    for (int a = 0; a < 8; ++a)
      mean += velocity_at(
                  scene.conversion->node[std::size_t(scene.conversion->hex[std::size_t(e)][std::size_t(a)])]
                      .z()) /
              8;
    store_symmetric(stress, e, {0, 0, Real(E * mean / speed), 0, 0, 0});
  }
  Kokkos::deep_copy(m.points.stress, stress);
}

// The same in particles; the density too.
void set_pulse(const Particles& p) {
  const auto x = host_copy(p.position), v = host_copy(p.velocity);
  const auto stress = host_copy(p.points.stress);
  const auto rho = host_copy(p.points.density);
  for (int i = 0; i < p.count; ++i) {
    const double v_z = velocity_at(double(x(i, 2)));
    v(i, 2) = Real(v_z), rho(i) = Real(density * (1 - v_z / speed));
    store_symmetric(stress, i, {0, 0, Real(E * v_z / speed), 0, 0, 0});
  }
  Kokkos::deep_copy(p.velocity, v), Kokkos::deep_copy(p.points.stress, stress);
  Kokkos::deep_copy(p.points.density, rho);
}

struct Outcome {
  std::vector<double> profile; // mean v_z of the layers of particles in z > 0, m/s
  double momentum_error = 0, energy_error = 0, kinetic_share = 0;
};

// The hexes above `border` become particles at the start; then the pulse runs into the other half. In flight:
// it is in the hexes as they convert; else it begins in the particles.
Outcome run_pulse(double border, bool in_flight) {
  Simulation simulation = make_bar();
  const Scene& scene = simulation.scene();
  strain_hexes(scene, [&](const Point& x) { return x.z() > border; });
  if (in_flight)
    start_pulse(scene);
  else
    simulation.start(), set_pulse(scene.particles);
  const auto momentum_of = [&] {
    return double(sum_particles(scene.particles, 1).momentum.z + sum_hexes(scene.hexes, 1).momentum.z);
  };
  const double momentum = momentum_of(), kinetic = double(sum_hexes(scene.hexes, 1).kinetic +
                                                          sum_particles(scene.particles, 1).kinetic);
  simulation.start();
  Outcome o;
  o.kinetic_share = simulation.initial_kinetic() / kinetic;
  EXPECT_NEAR(momentum_of() / momentum, 1, 1e-12);
  run_until(simulation, half_length / speed, [] {});
  o.momentum_error = momentum_of() / momentum - 1;
  o.energy_error = simulation.take_sample().residual / (2 * kinetic);
  o.profile.assign(60, 0);
  const auto x = host_copy(scene.particles.position), v = host_copy(scene.particles.velocity);
  for (int i = 0; i < scene.particles.count; ++i)
    if (x(i, 2) > 0)
      o.profile[std::size_t(std::min(59.0, double(x(i, 2)) / spacing))] += double(v(i, 2)) / 36;
  return o;
}

} // namespace

// What comes back from the border, against a bar of which all has become particles. Bounds: those of the tie
// that a deck builds, for hexes of two spacings and this pulse (verify_tie_pulse.cpp).
TEST(ConversionInMotion, AWavePassesFromNewParticlesIntoHexes) {
  for (const bool in_flight : {false, true}) {
    const Outcome all = run_pulse(-1, in_flight), half = run_pulse(0, in_flight);
    double amplitude = 0, energy = 0;
    for (std::size_t k = 0; k < 60; ++k) {
      const double v = half.profile[k] - all.profile[k];
      amplitude = std::max(amplitude, std::abs(v)), energy += v * v / 10;
    }
    std::printf(
        "%s: returned %.4f of the crest, %.5f of the energy; kinetic energy kept %.5f, momentum off by "
        "%.1e, energy by %.1e\n",
        in_flight ? "converted in flight" : "begun in particles", amplitude, energy, half.kinetic_share,
        half.momentum_error, half.energy_error);
    EXPECT_NEAR(half.momentum_error, 0, sizeof(Real) == 8 ? 1e-10 : 1e-4);
    EXPECT_NEAR(half.energy_error, 0, 5e-3);
    // A wave of k per hex of edge a: particles a quarter into it move with 3/4 and 1/4 of its nodes'
    // velocities, whose mean square is 5/8 + 3/8 cos(k a) of theirs. The pulse is half a wave, ten hexes
    // long.
    EXPECT_NEAR(half.kinetic_share, in_flight ? 0.625 + 0.375 * std::cos(pi / 10) : 1, 1e-3);
    if (in_flight) continue; // stresses that are even in each hex are short waves in the particles
    EXPECT_LT(amplitude, 0.055);
    EXPECT_LT(energy, 0.0016);
  }
}

namespace {

// The shipped orthogonal cut, coarse and short: with its band of particles 80 um high, or one body of hexes
// of which those within 70 um of the tool become particles.
Deck make_cut(bool converts) {
  constexpr double um = 1e-6, dx = 10 * um;
  Deck deck = read_deck(std::string(SWARF_SOURCE_DIR) + "/inputs/orthogonal_cutting.toml");
  BodyDeck &zone = deck.bodies[0], &bulk = deck.bodies[1];
  zone.size = {320 * um, 80 * um, 4 * dx}, bulk.size = {320 * um, 160 * um, 4 * dx};
  zone.spacing = dx, bulk.spacing = 2 * dx;
  deck.tool->width = 12 * dx, deck.tool->position[2] = 2 * dx;
  deck.run.end_time = 0.1e-3;
  if (converts) {
    bulk.size[1] += zone.size[1], bulk.convert_distance = 70 * um;
    deck.bodies = {BodyDeck(bulk)};
  }
  return deck;
}

struct Cut {
  double force = 0;    // N, mean planar one of the second half
  double residual = 0; // over the external work
  double particle_steps = 0;
};

Cut run_cut(const Deck& deck) {
  Simulation simulation(deck);
  simulation.start();
  std::array<double, 2> sum{};
  int samples = 0;
  double external = 0, worst = 0;
  while (simulation.time() < *deck.run.end_time) {
    simulation.step();
    if (simulation.steps_to_check() > 0) continue;
    simulation.check();
    const HistorySample s = simulation.take_sample();
    external = s.external, worst = std::max(worst, std::abs(s.residual));
    if (s.time > 0.5 * *deck.run.end_time) sum[0] += s.force[0], sum[1] += s.force[1], ++samples;
  }
  return {std::hypot(sum[0], sum[1]) / samples, worst / external, simulation.particle_steps()};
}

} // namespace

// 3 % of the planar force is what a saving may cost; 1 % of the work is what the deck allows its residual.
TEST(ConversionInMotion, ACutTakesTheForceOfOneThroughABandOfParticles) {
  const Cut band = run_cut(make_cut(false)), converts = run_cut(make_cut(true));
  std::printf("planar force %.2f N, with conversion %.2f N (%+.1f %%); residual %.2g and %.2g of the work; "
              "%.2f of the particle-steps\n",
              band.force, converts.force, 100 * (converts.force / band.force - 1), band.residual,
              converts.residual, converts.particle_steps / band.particle_steps);
  EXPECT_NEAR(converts.force / band.force, 1, 0.03);
  EXPECT_LT(converts.residual, 0.01);
  EXPECT_LT(converts.particle_steps, 0.6 * band.particle_steps);
}

// The particles' step is shorter than that of the hexes which they come from: before anything has asked for
// their mode they must not run at the other. Also where the run is stopped at that moment and goes on.
TEST(ConversionInMotion, TheFirstParticlesOfASceneBeginAtTheirOwnStep) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(folder, R"([material.steel]
law = "elastic"
density = "7800 kg/m3"
youngs_modulus = "200 GPa"
poissons_ratio = 0.3
[[body]]
name = "work"
shape = "block"
fill = "hexes"
material = "steel"
size = ["100 um", "60 um", "60 um"]
spacing = "20 um"
convert_distance = "25 um"
convert_particles = 3
[body.faces]
x_min = { velocity = ["20 m/s", "0 m/s", "0 m/s"] }
[tool]
kind = "wall"
normal = [-1.0, 0.0, 0.0]
size = "200 um"
position = ["130 um", "30 um", "30 um"]
velocity = ["-50 m/s", "0 m/s", "0 m/s"]
[contact]
friction = 0.0
[run]
end_time = "0.3 us"
)");
  const Ended whole = run_program(run_arguments(deck, folder / "whole"));
  EXPECT_EQ(whole.status, 0) << whole.output;
  std::vector<std::string> part = run_arguments(deck, folder / "part");
  part.insert(part.end(), {"--stop-after", "125"});
  EXPECT_EQ(run_program(part).status, 0);
  const Ended rest = run_program(run_arguments(deck, folder / "part", true));
  EXPECT_EQ(rest.status, 0) << rest.output;
  EXPECT_EQ(read_bytes(folder / "part/history.csv"), read_bytes(folder / "whole/history.csv"));
}
