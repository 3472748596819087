// 14. Heat through faces: a half space that is cooled by convection, and one whose face is held. References:
// Carslaw & Jaeger, Conduction of Heat in Solids (1959), sec. 2.5 and 2.7:
//   (T - T0) / (Ta - T0) = erfc(x / 2 sqrt(a t)) - exp(h x / k + h^2 a t / k^2) erfc(x / 2 sqrt(a t) + h
//   sqrt(a t) / k),
// of which a held face is the limit of large h; heat that has crossed, by integration over time.
#include "tests/verification/case.hpp"
#include "tests/verification/drive.hpp"

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double k = 7.2, rho = 4430, c = 526.3, alpha = k / (rho * c); // Ti-6Al-4V
const double effusivity = std::sqrt(k * rho * c);
constexpr double end = 10e-6, reach = 60 * um, depth = 6 * um, hot = 400, ambient = 300;
const std::string source = "Carslaw & Jaeger 1959, sec. 2.5, 2.7";

struct Cooling {
  std::string fill;
  double spacing;
  double film; // W/m2/K; 0: held
};

// Of the hybrid the face is of particles, and hexes begin 20 um below.
Deck deck_of(const Cooling& cooling) {
  Deck deck = empty_deck();
  deck.materials[0].conductivity = k;
  const double side = 4 * cooling.spacing, part = cooling.fill == "hybrid" ? 20 * um : reach;
  const std::string top = cooling.fill == "hybrid" ? "particles" : cooling.fill;
  deck.bodies = {block("work", top, {0, 0, 0}, {part, side, side}, cooling.spacing)};
  if (cooling.fill == "hybrid") {
    deck.bodies.push_back(block("rest", "hexes", {part, 0, 0}, {reach - part, side, side}, cooling.spacing));
    deck.bodies[0].tie = "rest";
  }
  for (BodyDeck& body : deck.bodies) {
    body.temperature = hot;
    for (const char* face : {"y_min", "y_max", "z_min", "z_max"})
      body.faces.push_back({face, FaceKind::periodic, {}});
  }
  FaceDeck face{"x_min", FaceKind::free, {}};
  face.temperature = ambient;
  if (cooling.film > 0) face.film = cooling.film;
  deck.bodies[0].faces.push_back(face);
  deck.run.courant = 0.3, deck.run.mass_factor = 1e5;
  return deck;
}

double profile(double film, double x, double t) {
  const double s = 2 * std::sqrt(alpha * t), b = film * std::sqrt(alpha * t) / k;
  const double held = std::erfc(x / s);
  return film > 0 ? held - std::exp(film * x / k + b * b) * std::erfc(x / s + b) : held;
}

// J/m2 that have left
double crossed(double film, double t) {
  if (film == 0) return (hot - ambient) * effusivity * 2 * std::sqrt(t / pi);
  const double b = film / effusivity;
  return film * (hot - ambient) *
         ((std::exp(b * b * t) * std::erfc(b * std::sqrt(t)) - 1) / (b * b) + 2 * std::sqrt(t / pi) / b);
}

struct Outcome {
  double time, heat, at_depth, residual; // s, J/m2, share of the step, of the heat
};

Outcome run(const Cooling& cooling) {
  Simulation simulation(deck_of(cooling));
  simulation.start();
  run_until(simulation, end, [] {});
  simulation.check();
  const HistorySample s = simulation.take_sample();
  const Scene& scene = simulation.scene();
  std::vector<std::pair<double, double>> points;
  const auto add = [&](const VectorField& position, const ScalarField& temperature, int rows) {
    const auto x = host_copy(position);
    const auto T = host_copy(temperature);
    for (int i = 0; i < rows; ++i) points.emplace_back(double(x(i, 0)), double(T(i)));
  };
  add(scene.particles.position, scene.particles.points.temperature, scene.particles.count);
  if (scene.hexes.nodes > 0) add(scene.hexes.position, scene.hexes.nodal_temperature, scene.hexes.nodes);
  std::pair<double, double> low{-1, 0}, high{1, 0};
  for (const auto& p : points) {
    if (p.first <= depth && p.first > low.first) low = p;
    if (p.first > depth && p.first < high.first) high = p;
  }
  const double T = low.second + (high.second - low.second) * (depth - low.first) / (high.first - low.first);
  const double area = 16 * cooling.spacing * cooling.spacing;
  return {s.time, s.heat_out / area, (hot - T) / (hot - ambient),
          std::abs(s.heat_residual) / std::abs(s.heat_out)};
}

void cool(const std::string& fill, double film) {
  const std::string name = "14 " + std::string(film > 0 ? "convection" : "held face") + ", " + fill;
  const std::string how =
      std::string(film > 0 ? "film 1e6 W/m2/K" : "face at 300 K") + ", spacing 1 um, 10 us";
  std::array<double, 3> size{4 * um, 2 * um, 1 * um}, heat{}, inside{};
  Outcome o{};
  for (std::size_t r = 0; r < 3; ++r) {
    o = run({fill, size[r], film});
    heat[r] = relative_error(o.heat, crossed(film, o.time));
    inside[r] = relative_error(o.at_depth, profile(film, depth, o.time));
  }
  const std::string chord = "at 4 um the depth lies between two nodes, and the chord hides part of the error",
                    ramp =
                        "at 4 um the ramp of the tie lies within what has cooled, and errs to the other side";
  report({name, "heat that has left", how, crossed(film, o.time), "J/m2", source, o.heat, heat[2], 0.05});
  report({name, "fall of the temperature 6 um below, over the step", how, profile(film, depth, o.time), "",
          source, o.at_depth, inside[2], 0.02});
  report({name, "heat stored and gone, less made", how, 0, "", "conservation", o.residual, o.residual, 1e-9,
          true});
  report_order(name, "heat that has left", "spacing 4, 2, 1 um", size, heat, 1, 0.3, "first order");
  report_order(name, "temperature 6 um below", "spacing 4, 2, 1 um", size, inside, 1, 0.3, "first order",
               fill == "hybrid"              ? ramp
               : fill == "hexes" && film > 0 ? chord
                                             : "");
}

} // namespace

TEST(VerifyHeatedFaces, ConvectionFromHexes) { cool("hexes", 1e6); }
TEST(VerifyHeatedFaces, ConvectionFromParticles) { cool("particles", 1e6); }
TEST(VerifyHeatedFaces, ConvectionThroughTheTie) { cool("hybrid", 1e6); }
TEST(VerifyHeatedFaces, HeldHexes) { cool("hexes", 0); }
TEST(VerifyHeatedFaces, HeldParticles) { cool("particles", 0); }
TEST(VerifyHeatedFaces, HeldThroughTheTie) { cool("hybrid", 0); }
