// First bending mode of a plate in plane strain and of a square cantilever: period of a small oscillation.
// Bending shows hourglass stiffness, zero-energy modes and what the stabilisers cost.
#include "tests/verification/case.hpp"
#include "tests/verification/clamped_beam.hpp"

using namespace swarf;
using namespace swarf::test;
using namespace swarf::test::clamped_beam;

namespace {

struct Oscillation {
  double period = 0;
  Series tip; // s, m
};

// Twice the time until the tip is back where it started.
Oscillation oscillate(const Beam& beam, const Deck& deck, double expected_period) {
  Simulation simulation(deck);
  const Scene& scene = simulation.scene();
  const auto X = snapshot(scene);
  set_velocity(scene, [&](const Triple& x) {
    return Triple{0, x[0] > 0 ? beam.tip_speed * mode_shape(x[0] / beam.length) : 0, 0};
  });
  simulation.start();
  std::vector<std::size_t> tip; // the last layer
  double end = 0;
  for (const PointState& p : X) end = std::max(end, p.x[0]);
  for (std::size_t i = 0; i < X.size(); ++i)
    if (X[i].x[0] > end - 1e-6 * beam.length) tip.push_back(i);
  Oscillation o;
  double before = 0, time_before = 0;
  run_until(simulation, 0.75 * expected_period, [&] {
    double u = 0;
    const auto now = snapshot(scene);
    for (const std::size_t i : tip) u += (now[i].x[1] - X[i].x[1]) / double(tip.size());
    if (o.period == 0 && before > 0 && u <= 0)
      o.period = 2 * (time_before + (simulation.time() - time_before) * before / (before - u));
    before = u, time_before = simulation.time();
    if (simulation.step_count() % 20 == 0) o.tip.x.push_back(time_before), o.tip.y.push_back(u);
  });
  return o;
}

Oscillation run(const Beam& beam, const Deck& method, const std::string& fill, int across, double period) {
  Oscillation o = oscillate(beam, clamped(method, beam, fill, across), period);
  for (double& t : o.tip.x) t /= period;
  for (double& u : o.tip.y) u *= 2 * pi / period / beam.tip_speed;
  o.tip.label = fill + ", " + std::to_string(across) + " across";
  return o;
}

Series sine(double periods) {
  Series s{"sin(2 pi t / T)", {}, {}, true};
  for (int k = 0; k <= 200; ++k)
    s.x.push_back(periods * k / 200), s.y.push_back(std::sin(2 * pi * periods * k / 200));
  return s;
}

Curve tip_curve(const std::string& file, const std::string& title) {
  return {file, title, "time / reference period", "tip displacement / (v / omega)", {}};
}

// The plate of Landau & Lifshitz (Theory of Elasticity) has 0.25406 s if it is thin; with shear and rotary
// inertia, in plane strain, the clamp not yielding, quadratic finite elements converge to 0.2551 s (10 to 80
// elements along give 0.2526, 0.2543, 0.2549, 0.2551).
constexpr double plate_period = 0.2551;
const std::string plate_source =
    "plane strain eigenvalue, nine-node elements, to 0.05 % (thin plate, Landau & Lifshitz: 0.25406 s)";

void report_plate(const std::string& fill, const std::string& run, double period, double allowed) {
  report({plate().name + ", " + fill, "period", run, plate_period, "s", plate_source, period,
          relative_error(period, plate_period), allowed});
}

} // namespace

// One integration point makes a layer of n hexes too soft by 1/n^2 of the bending stiffness: second order.
TEST(Bending, PlateOfHexes) {
  Curve curve = tip_curve("oscillating_plate_hexes", "Oscillating plate, hexes");
  const std::array<int, 3> across{4, 8, 16};
  std::array<double, 3> size{}, error{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Oscillation o = run(plate(), shipped_defaults(), "hexes", across[k], plate_period);
    size[k] = 1.0 / across[k], error[k] = relative_error(o.period, plate_period);
    report_plate("hexes", std::to_string(across[k]) + " across, shipped defaults", o.period,
                 0.5 / (across[k] * across[k]) + 5e-4);
    curve.series.push_back(o.tip);
  }
  report_order(plate().name + ", hexes", "period", "4, 8, 16 across, shipped defaults", size, error, 2, 0.3,
               plate_source);
  curve.series.push_back(sine(0.75));
  write_curve(curve);
}

// From four across on. The clamp of particles is known to a part of the spacing: T ~ L^2 makes an error of
// the first order of it.
constexpr double of_particles = 0.03;
TEST(BendingLong, PlateOfParticles) {
  Curve curve = tip_curve("oscillating_plate_particles", "Oscillating plate, particles");
  const std::array<int, 3> across{4, 6, 8};
  std::array<double, 3> size{}, error{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Oscillation o = run(plate(), shipped_defaults(), "particles", across[k], plate_period);
    size[k] = 1.0 / across[k], error[k] = relative_error(o.period, plate_period);
    report_plate("particles", std::to_string(across[k]) + " across, shipped defaults", o.period,
                 of_particles);
    curve.series.push_back(o.tip);
  }
  report_order(plate().name + ", particles", "period", "4, 6, 8 across, shipped defaults", size, error, 1,
               0.3, plate_source);
  curve.series.push_back(sine(0.75));
  write_curve(curve);
}

// The same plate with kernels of the initial positions, whose rows are allowed what those of the current ones
// are. A stiffness of 1: a zero-energy mode is held by the shear modulus itself.
TEST(BendingLong, PlateOfParticlesInTheInitialFrame) {
  Curve curve =
      tip_curve("oscillating_plate_total_lagrangian", "Oscillating plate, particles, total Lagrangian");
  const std::string name = "particles, total Lagrangian";
  for (const double stiffness : {0.0, 1.0}) {
    Deck method = shipped_defaults();
    method.particles.kernel_frame = KernelFrame::initial, method.particles.hourglass_stiffness = stiffness;
    const std::string how = stiffness > 0 ? "hourglass stiffness 1" : "shipped defaults";
    const std::array<int, 3> across{4, 6, 8};
    std::array<double, 3> size{}, error{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Oscillation o = run(plate(), method, "particles", across[k], plate_period);
      size[k] = 1.0 / across[k], error[k] = relative_error(o.period, plate_period);
      report_plate(name, std::to_string(across[k]) + " across, " + how, o.period, of_particles);
      curve.series.push_back(o.tip), curve.series.back().label += ", " + how;
    }
    report_order(plate().name + ", " + name, "period", "4, 6, 8 across, " + how, size, error, 1, 0.3,
                 plate_source);
  }
  curve.series.push_back(sine(0.75));
  write_curve(curve);
}

// Euler & Bernoulli leave out shear and rotary inertia: Timoshenko's beam of this shape is 0.8 % lower. Hexes
// are allowed that, and what the layers cost as above.
void bend_cantilever(const std::string& fill, int across, const Deck& method, const std::string& how,
                     Curve& curve) {
  const double frequency = 80496;
  const Oscillation o = run(cantilever(), method, fill, across, 1 / frequency);
  const double allowed = fill == "particles" ? of_particles : 0.008 + 0.5 / (across * across);
  report({cantilever().name + ", " + fill, "first frequency", std::to_string(across) + " across, " + how,
          frequency, "Hz",
          "Euler & Bernoulli, 1.8751^2 / (2 pi L^2) sqrt(E I / (rho A)); Timoshenko: 0.8 % less",
          1 / o.period, relative_error(1 / o.period, frequency), allowed});
  curve.series.push_back(o.tip);
}

TEST(Bending, CantileverOfHexes) {
  Curve curve = tip_curve("cantilever_hexes", "Cantilever of Ti-6Al-4V, 1 x 0.1 x 0.1 mm, hexes");
  for (const int across : {4, 8})
    bend_cantilever("hexes", across, shipped_defaults(), "shipped defaults", curve);
  curve.series.push_back(sine(0.75));
  write_curve(curve);
}

TEST(Bending, CantileverOfParticles) {
  Curve curve = tip_curve("cantilever_particles", "Cantilever of Ti-6Al-4V, 1 x 0.1 x 0.1 mm, particles");
  for (const int across : {4, 6})
    bend_cantilever("particles", across, shipped_defaults(), "shipped defaults", curve);
  curve.series.push_back(sine(0.75));
  write_curve(curve);
}
