// 13. Properties that depend on temperature. References: steady conduction with k(T), of which the integral
// over T (Kirchhoff, 1894) is linear across a slab (Carslaw & Jaeger 1959, 1.6); heating by plastic work with
// c(T), where the integral of c is the work per mass; and the ledger of heat.
#include "tests/verification/case.hpp"
#include "tests/verification/drive.hpp"

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double cold = 300, hot = 900, k_cold = 6.6, k_hot = 13.2, length = 40 * um;
const std::string source = "Carslaw & Jaeger 1959, sec. 1.6";

// k0 (T + b T^2 / 2) linear in x: the temperature a share s of the way from the cold face.
double kirchhoff(double s) {
  const double b = (k_hot / k_cold - 1) / (hot - cold), whole = (hot - cold) * (1 + 0.5 * b * (hot - cold));
  return cold + (std::sqrt(1 + 2 * b * s * whole) - 1) / b;
}

// Largest error over the rise of the temperatures across the slab, when nothing changes any more.
double steady_error(const std::string& fill, double spacing) {
  Deck deck = shipped_defaults();
  deck.materials = {elastic_material(4430, 110e9, 0.33)};
  deck.materials[0].conductivity.points = {{cold, k_cold}, {hot, k_hot}};
  deck.materials[0].specific_heat = 526.3;
  const bool hybrid = fill == "hybrid";
  const double side = 4 * spacing, part = hybrid ? 0.5 * length : length;
  deck.bodies = {block("slab", hybrid ? "particles" : fill, {0, 0, 0}, {part, side, side}, spacing)};
  if (hybrid) {
    deck.bodies.push_back(block("rest", "hexes", {part, 0, 0}, {part, side, side}, spacing));
    deck.bodies[0].tie = "rest";
  }
  for (BodyDeck& body : deck.bodies)
    hold(body, "periodic", {"y_min", "y_max", "z_min", "z_max"}), body.temperature = 600;
  deck.bodies.front().faces.emplace_back("x_min").temperature = cold;
  deck.bodies.back().faces.emplace_back("x_max").temperature = hot;
  deck.run.mass_factor = 1e9;
  Simulation simulation(deck);
  simulation.start();
  run_until(simulation, 1e-3, [] {}); // the slowest mode falls below 1e-8
  const Scene& scene = simulation.scene();
  double worst = 0;
  const auto look = [&](const VectorField& position, const ScalarField& temperature, int rows) {
    const auto x = host_copy(position);
    const auto T = host_copy(temperature);
    for (int i = 0; i < rows; ++i)
      worst = std::max(worst, std::abs(double(T(i)) - kirchhoff(double(x(i, 0)) / length)) / (hot - cold));
  };
  look(scene.particles.position, scene.particles.points.temperature, scene.particles.count);
  if (scene.hexes.nodes > 0) look(scene.hexes.position, scene.hexes.nodal_temperature, scene.hexes.nodes);
  return worst;
}

// The flow between two nodes of one hex is the mean of k over a straight line times their difference: exact.
TEST(VerifyHeatTables, KirchhoffInHexes) {
  const double error = steady_error("hexes", 4 * um);
  report({"13 conductivity over temperature, hexes", "largest error of T over the rise, at rest",
          "k 6.6 to 13.2 W/m/K over 300 to 900 K, 10 cells", 0, "", source, error, error, 1e-6, true});
}

void kirchhoff_at_three(const std::string& fill) {
  std::array<double, 3> size{5 * um, 2.5 * um, 1.25 * um}, error{};
  for (std::size_t r = 0; r < 3; ++r) error[r] = steady_error(fill, size[r]);
  const std::string name = "13 conductivity over temperature, " + fill;
  report({name, "largest error of T over the rise, at rest",
          "k 6.6 to 13.2 W/m/K over 300 to 900 K, spacing 1.25 um", 0, "", source, error[2], error[2], 0.01,
          true});
  report_order(name, "temperature across the slab", "spacing 5, 2.5, 1.25 um", size, error, 1, 0.3,
               "first order at the faces");
}

} // namespace

TEST(VerifyHeatTables, KirchhoffInParticles) { kirchhoff_at_three("particles"); }
TEST(VerifyHeatTables, KirchhoffThroughTheTie) { kirchhoff_at_three("hybrid"); }

namespace {

constexpr double c_cold = 500, c_hot = 900, c_from = 300, c_to = 600;

// J/kg from 300 K to T
double enthalpy(double T) {
  const double slope = (c_hot - c_cold) / (c_to - c_from), d = std::min(T, c_to) - c_from;
  return c_cold * d + 0.5 * slope * d * d + (T > c_to ? c_hot * (T - c_to) : 0);
}

// A strip stretched to 8 % flows at 2.5 GPa: 200 MJ/m3, 45 kJ/kg, about 83 K.
void stretch(const std::string& fill) {
  Deck deck = shipped_defaults();
  MaterialDeck m = elastic_material(4430, 110e9, 0.33);
  m.law = Law::linear_hardening, m.yield_stress = 2.5e9, m.hardening_modulus = 1e9, m.taylor_quinney = 0.9;
  m.specific_heat.points = {{c_from, c_cold}, {c_to, c_hot}};
  deck.materials = {m};
  deck.bodies = {block("strip", fill, {0, 0, 0}, {16 * um, 16 * um, 16 * um}, 4 * um)};
  deck.bodies[0].temperature = c_from;
  deck.bodies[0].faces = {{"x_min", FaceKind::fixed, {}}, {"x_max", FaceKind::velocity, {20, 0, 0}}};
  Simulation simulation(deck);
  simulation.start();
  run_until(simulation, 0.08 * 16 * um / 20, [] {});
  simulation.check();
  const HistorySample s = simulation.take_sample();
  const MaterialPoints& p =
      fill == "hexes" ? simulation.scene().hexes.points : simulation.scene().particles.points;
  const auto T = host_copy(p.temperature), mass = host_copy(p.mass);
  double heat = 0, hottest = 0;
  for (int i = 0; i < p.count; ++i)
    heat += double(mass(i)) * enthalpy(double(T(i))), hottest = std::max(hottest, double(T(i)));
  EXPECT_GT(hottest, c_from + 50);
  const double made = 0.9 * s.plastic;
  report({"13 specific heat over temperature, " + fill, "integral of c over T, over the heat of plastic work",
          "c 500 to 900 J/kg/K over 300 to 600 K, adiabatic, 8 % stretch", 1, "", "conservation", heat / made,
          relative_error(heat, made), 1e-10});
  report({"13 specific heat over temperature, " + fill, "residual of the ledger over the heat made",
          "the same", 0, "", "conservation", s.heat_residual / made, std::abs(s.heat_residual) / made, 1e-10,
          true});
}

} // namespace

TEST(VerifyHeatTables, PlasticWorkInHexes) { stretch("hexes"); }
TEST(VerifyHeatTables, PlasticWorkInParticles) { stretch("particles"); }
