// A cylinder against a rigid wall at z = 0: its length and the radius of its foot over time.
#pragma once
#include "tests/verification/case.hpp"
#include "tests/verification/drive.hpp"
#include <map>

namespace swarf::test {

struct BarShape {
  std::vector<double> time, length, radius; // s, m, m
  double largest_residual = 0;              // of energy over the initial kinetic energy
  double artificial = 0;                    // work of hourglass control and viscosity over it, at the end
};

// Follows the material surface: the outermost points of each layer, and the top layer. Centres of particles
// lie half a particle inside the surface: sideways they move with it as their layer stretches.
class BarRuler {
 public:
  BarRuler(const Scene& scene, double radius, double length) : X(snapshot(scene)) {
    double outermost = 0, top = 0;
    for (const PointState& p : X)
      outermost = std::max(outermost, std::hypot(p.x[0], p.x[1])), top = std::max(top, p.x[2]);
    for (std::size_t i = 0; i < X.size(); ++i) {
      if (X[i].x[2] > top - 1e-3 * length) upper.push_back(i);
      if (std::hypot(X[i].x[0], X[i].x[1]) > outermost * (1 - 1e-6))
        layers[std::lround(1e6 * X[i].x[2] / length)].push_back(i);
    }
    stretch = radius / outermost, above = length - top;
  }
  void measure(const Scene& scene, double time, BarShape& shape) const {
    const auto now = snapshot(scene);
    std::vector<double> radius; // of the layers, from the foot upwards
    double top = 0;
    for (const auto& [z, points] : layers) {
      radius.push_back(0);
      for (const std::size_t i : points)
        radius.back() += std::hypot(now[i].x[0], now[i].x[1]) / double(points.size());
    }
    for (const std::size_t i : upper) top += now[i].x[2] / double(upper.size());
    // The foot is half a spacing below the centres of its layer.
    double foot = above > 1e-6 * top ? 1.5 * radius[0] - 0.5 * radius[1] : 0;
    for (const double r : radius) foot = std::max(foot, r);
    shape.time.push_back(time), shape.radius.push_back(stretch * foot), shape.length.push_back(top + above);
  }

 private:
  std::vector<PointState> X;
  std::vector<std::size_t> upper;
  std::map<long, std::vector<std::size_t>> layers;
  double stretch = 1, above = 0;
};

inline BarShape run_taylor_bar(const Deck& deck, double end) {
  Simulation simulation(deck);
  const BodyDeck& bar = deck.bodies[0];
  const BarRuler ruler(simulation.scene(), bar.radius, bar.height);
  simulation.start();
  BarShape shape;
  ruler.measure(simulation.scene(), 0, shape);
  double next = 0;
  run_until(simulation, end, [&] {
    if (simulation.time() < next && simulation.time() < end) return;
    next += end / 400;
    ruler.measure(simulation.scene(), simulation.time(), shape);
    const HistorySample now = simulation.take_sample();
    shape.largest_residual =
        std::max(shape.largest_residual, std::abs(now.residual) / simulation.initial_kinetic());
    shape.artificial = (now.hourglass + now.viscous) / simulation.initial_kinetic();
  });
  return shape;
}

inline void report_energy(const std::string& name, const std::string& run, const BarShape& shape) {
  report({name, "largest energy residual over the initial kinetic energy", run, 0, "",
          "conservation of energy", shape.largest_residual, shape.largest_residual, 0.01, true});
  std::printf("%s (%s): hourglass control and viscosity took %.2f %% of the initial kinetic energy\n",
              name.c_str(), run.c_str(), 100 * shape.artificial);
}

} // namespace swarf::test
