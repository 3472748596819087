// A strip that is pulled: its middle stretches evenly. Motion that no strain sees (zero-energy modes) would
// pass unopposed through a method with one point per particle or hex.
#include "tests/verification/case.hpp"
#include "tests/verification/pulled_strip.hpp"

using namespace swarf;
using namespace swarf::test;
using namespace swarf::test::pulled_strip;

namespace {

constexpr int along = 40, across = 10; // cells, of strip() as it comes

struct Fit {
  double stretch_x, stretch_y, residual; // of the middle third; residual: rms distance from the linear map, m
};

// x against X and y against Y of the middle third, each by a straight line.
Fit fit(const std::vector<Vector3>& X, const VectorField& position, const std::vector<int>& place) {
  const auto x = host_copy(position);
  double n = 0, sum[2]{}, SUM[2]{}, prod[2]{}, SQ[2]{}, sq[2]{};
  for (std::size_t i = 0; i < X.size(); ++i) {
    const int row = place[i];
    const double from[2]{double(X[i].x), double(X[i].y)}, to[2]{double(x(row, 0)), double(x(row, 1))};
    if (std::abs(from[0]) > along * a / 6) continue;
    n += 1;
    for (int d = 0; d < 2; ++d)
      sum[d] += to[d], SUM[d] += from[d], prod[d] += to[d] * from[d], SQ[d] += from[d] * from[d],
          sq[d] += to[d] * to[d];
  }
  double slope[2], residual = 0;
  for (int d = 0; d < 2; ++d) {
    const double c = prod[d] - sum[d] * SUM[d] / n, C = SQ[d] - SUM[d] * SUM[d] / n,
                 s = sq[d] - sum[d] * sum[d] / n;
    slope[d] = c / C, residual += std::max(0.0, s - c * c / C) / n;
  }
  return {slope[0], slope[1], std::sqrt(residual)};
}

// Particles are sorted: where each one is now, by its identity.
std::vector<int> places(const Scene& scene) {
  std::vector<int> place(std::size_t(scene.particles.count > 0 ? scene.particles.count : scene.hexes.nodes));
  if (scene.particles.count > 0) {
    const auto id = host_copy(scene.particles.identity);
    for (int i = 0; i < scene.particles.count; ++i) place[std::size_t(id(i))] = i;
  } else {
    std::iota(place.begin(), place.end(), 0);
  }
  return place;
}

struct Pulled {
  Fit middle;
  double stress = 0, reference = 0; // mean axial stress of the middle third; at the stretch there, Pa
  double drift = 0;                 // of a checkerboard that nothing opposes, m
  int parts = 0;
};

// `seed`: amplitude of a checkerboard in the velocity at the start, m/s.
Pulled pull(const std::string& fill, double strain, double seed, const Stabiliser& stabiliser,
            const std::string& frame = "current") {
  const double speed = 0.005 * wave;
  Deck deck = strip(fill, strain > 0 ? speed : 0);
  stabiliser.apply(deck), deck.particles.kernel_frame = value_of_word<KernelFrame>(frame);
  Simulation simulation(deck);
  const Scene& scene = simulation.scene();
  const double rate = strain > 0 ? speed / (along * a / 2) : 0;
  const double shift = scene.particles.count > 0 ? 0.5 : 0;
  set_velocity(scene, [&](const Triple& x) {
    const long odd = std::lround(x[0] / a - shift) + std::lround(x[1] / a - shift);
    const double checker = odd % 2 == 0 ? seed : -seed;
    return Triple{rate * x[0] + checker, -nu / (1 - nu) * rate * x[1] + checker, 0};
  });
  std::vector<Vector3> X;
  const auto x0 = host_copy(scene.particles.count > 0 ? scene.particles.position : scene.hexes.position);
  for (int i = 0; i < std::max(scene.particles.count, scene.hexes.nodes); ++i)
    X.push_back(load_vector(x0, i));
  simulation.start();
  advance(simulation, strain > 0 ? strain / rate : 0.2 / (speed / (along * a / 2)));
  Pulled p;
  p.middle =
      fit(X, scene.particles.count > 0 ? scene.particles.position : scene.hexes.position, places(scene));
  double n = 0;
  if (scene.particles.count > 0) {
    const auto s = host_copy(scene.particles.points.stress);
    const auto place = places(scene);
    for (std::size_t i = 0; i < X.size(); ++i)
      if (std::abs(double(X[i].x)) < along * a / 6) p.stress += double(s(place[i], 0)), n += 1;
  } else {
    const auto s = host_copy(scene.hexes.points.stress);
    const auto node = host_copy(scene.hexes.connectivity);
    for (int e = 0; e < scene.hexes.points.count; ++e)
      if (std::abs(double(X[std::size_t(node(e, 0))].x) + a / 2) < along * a / 6)
        p.stress += double(s(e, 0)), n += 1;
  }
  p.stress /= n;
  p.parts = scene.particles.count > 0 ? count_parts(scene.particles, 1.6 * a * std::max(1.0, 1 + strain)) : 0;
  p.reference = E / (1 - nu * nu) * std::log(p.middle.stretch_x);
  p.drift = seed * simulation.time();
  return p;
}

} // namespace

TEST(Strip, StretchesEvenly) {
  const char* const pairing =
      "layers across the pull move together in pairs: the velocity gradient does not see it and tension "
      "drives it; a stiffness holds it where it exceeds the tension";
  const std::string source = "exact: logarithmic strain, plane strain: E / (1 - nu^2) ln(stretch)";
  for (const std::string fill : {"hexes", "particles"}) {
    const std::string name = "4 pulled strip, " + fill;
    const bool particles = fill == "particles";
    for (const Stabiliser& with : {Stabiliser{0}, Stabiliser{0.3}, Stabiliser{2}})
      for (const double strain : {0.02, 0.2}) {
        if (!particles && with.stiffness > 0) continue;
        const Pulled p = pull(fill, strain, 0, with);
        const bool far = strain > 0.1; // at 2 % it has not begun
        const std::string fault = particles && far && with.stiffness < 1 ? pairing : "";
        const std::string begun = particles && far ? pairing : ""; // a little even with a stiffness of 2
        const std::string parameters = "40 x 10 cells, pulled by " +
                                       std::to_string(int(std::lround(100 * strain))) + " %" +
                                       (particles ? with.text() : "");
        report({name, "axial stress in the middle", parameters, p.reference, "Pa", source, p.stress,
                relative_error(p.stress, p.reference), 0.02, false, fault});
        // Elastic waves of the start bend it by less than a hundredth of a spacing.
        report({name, "distance from an even stretch / spacing", parameters, 0, "", "exact: 0",
                p.middle.residual / a, p.middle.residual / a, 0.01, true, begun});
        if (particles)
          report({name, "parts", parameters, 1, "", "an elastic strip stays whole", double(p.parts),
                  std::abs(p.parts - 1.0), 0, true, fault});
      }
    const Pulled p = pull(fill, 0, 1e-3 * wave, Stabiliser{0.3});
    report({name, "checkerboard left / drift that nothing opposes",
            "40 x 10 cells, velocity of 1e-3 wave speeds", 0, "", "exact: 0", p.middle.residual / p.drift,
            p.middle.residual / p.drift, 0.01, true});
  }
}

TEST(Strip, StretchesEvenlyInTheInitialFrame) {
  const std::string source = "exact: logarithmic strain, plane strain: E / (1 - nu^2) ln(stretch)";
  const std::string name = "4 pulled strip, particles, total Lagrangian";
  const char* const alternates =
      "from the held ends layers across the pull alternate, a zero-energy mode: no "
      "gradient sees it, and nothing but viscosity holds it";
  for (const double stiffness : {0.0, 1.0}) {
    const std::string how = stiffness > 0 ? ", hourglass stiffness 1" : "";
    for (const double strain : {0.02, 0.2}) {
      const Pulled p = pull("particles", strain, 0, Stabiliser{stiffness}, "initial");
      const std::string parameters =
          "40 x 10 cells, pulled by " + std::to_string(int(std::lround(100 * strain))) + " %" + how;
      report({name, "axial stress in the middle", parameters, p.reference, "Pa", source, p.stress,
              relative_error(p.stress, p.reference), 0.02});
      report({name, "distance from an even stretch / spacing", parameters, 0, "", "exact: 0",
              p.middle.residual / a, p.middle.residual / a, 0.01, true,
              strain > 0.1 && stiffness == 0 ? alternates : ""});
      report({name, "parts", parameters, 1, "", "an elastic strip stays whole", double(p.parts),
              std::abs(p.parts - 1.0), 0, true});
    }
    const Pulled p = pull("particles", 0, 1e-3 * wave, Stabiliser{stiffness}, "initial");
    report({name, "checkerboard left / drift that nothing opposes",
            "40 x 10 cells, velocity of 1e-3 wave speeds" + how, 0, "", "exact: 0",
            p.middle.residual / p.drift, p.middle.residual / p.drift, 0.01, true});
  }
}
