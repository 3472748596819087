// A square plate that spins freely (Lee, Gil, Greto, Khayyer & Bonet 2016, there at 105 rad/s): the load is
// its own inertia. Angular momentum and energy are kept, and the corners breathe alike in every
// discretisation.
#include "tests/verification/case.hpp"
#include "tests/verification/spinning_plate.hpp"

using namespace swarf;
using namespace swarf::test;
using namespace swarf::test::spinning_plate;

namespace {

struct Spin {
  Series extent; // root mean square distance from the axis, over that at the start, over time
  double angular = 0, residual = 0; // changes: of the angular momentum; of the energy, over the kinetic one
  double widening = 0, largest = 0; // maximum of extent - 1: the first; over the whole turn
  int parts = 0;
};

Spin spin(const Deck& deck, double end) {
  Simulation simulation(deck);
  const Scene& scene = simulation.scene();
  set_velocity(scene, [](const Triple& x) { return Triple{-omega * x[1], omega * x[0], 0}; });
  simulation.start();
  const double first = double(angular_momentum(scene).z);
  const auto inertia = [&] {
    double total = 0;
    for (const PointMass& p : point_masses(scene)) total += p.mass * double(p.x.x * p.x.x + p.x.y * p.x.y);
    return total;
  };
  const double first_inertia = inertia();
  Spin s;
  advance(simulation, end, [&] {
    s.extent.x.push_back(simulation.time()), s.extent.y.push_back(std::sqrt(inertia() / first_inertia));
  });
  s.angular = double(angular_momentum(scene).z) / first - 1;
  s.residual = simulation.take_sample().residual / simulation.initial_kinetic();
  if (scene.particles.count > 0) s.parts = count_parts(scene.particles, 1.6 * *deck.bodies[0].spacing);
  for (std::size_t k = 0; k < s.extent.x.size(); ++k) {
    s.largest = std::max(s.largest, s.extent.y[k] - 1);
    if (s.extent.x[k] < turn / 20) s.widening = s.largest;
  }
  return s;
}

} // namespace

TEST(SpinningPlate, KeepsItsAngularMomentumAndBreathes) {
  const Spin reference = spin(plate("hexes", 40), turn);
  Curve curve{"spinning_plate",
              "Spinning plate, 50 rad/s",
              "time, s",
              "root mean square distance from the axis / start",
              {reference.extent}};
  curve.series[0].label = "hexes, 40 across", curve.series[0].reference = true;
  for (const std::string fill : {"hexes", "particles", "hybrid"}) {
    const Spin s = spin(plate(fill, 20), turn);
    const std::string name = "2 spinning plate, " + fill;
    const std::string parameters = "20 cells across, one turn";
    report({name, "change of angular momentum, relative", parameters, 0, "", "exact: none; round-off",
            s.angular, std::abs(s.angular), 1e-12, true,
            fill != "hexes"
                ? "the correction is made with the volumes of the step before, the forces with those "
                  "of this step"
                : ""});
    report({name, "energy residual / kinetic energy", parameters, 0, "",
            "exact: 0; central differences: within 0.1 %", s.residual, std::abs(s.residual), 1e-3, true});
    report({name, "first widening", parameters, reference.widening, "",
            "hexes, 40 cells across; 20 and 40 differ by 1 %", s.widening,
            relative_error(s.widening, reference.widening), 0.05});
    // The modes of the square beat: late maxima depend on their phases.
    report({name, "largest widening of the turn", parameters, reference.largest, "", "hexes, 40 cells across",
            s.largest, relative_error(s.largest, reference.largest), 0.1, false});
    if (fill != "hexes")
      report({name, "parts", parameters, 1, "", "the plate stays whole", double(s.parts),
              std::abs(s.parts - 1.0), 0, true});
    curve.series.push_back(s.extent);
    curve.series.back().label = fill + ", 20 across";
  }
  write_curve(curve);
}
