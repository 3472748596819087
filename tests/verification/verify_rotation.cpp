// Rotation. A block under stress is carried round through 360 deg about a skew axis: what its constitutive
// update and its forces make of a motion that strains nothing. A plate spins freely: what the whole step
// keeps.
#include "tests/verification/case.hpp"
#include "tests/verification/point_masses.hpp"

using namespace swarf;
using namespace swarf::test;

namespace {

enum class Filling { particles, hexes, hybrid };
const char* name_of(Filling fill) {
  return fill == Filling::particles ? "particles" : fill == Filling::hexes ? "hexes" : "hybrid";
}

// Rodrigues' formula; axis a unit vector.
Tensor3 rotation_about(const Vector3& axis, double angle) {
  const Real c = Real(std::cos(angle)), s = Real(std::sin(angle)), k = 1 - c;
  const auto [x, y, z] = axis;
  return {c + k * x * x,     k * x * y - s * z, k * x * z + s * y, k * x * y + s * z, c + k * y * y,
          k * y * z - s * x, k * x * z - s * y, k * y * z + s * x, c + k * z * z};
}

// --- carried round

constexpr int turn_steps = 360;
const Symmetric3 stress_at_start{9e8, -4e8, 2e8, 3e8, -5e8, 6e8};

Deck block_under_stress(Filling fill) {
  Deck deck = default_deck();
  const double a = 8 * um; // eight spacings
  deck.bodies.clear();
  if (fill == Filling::particles)
    deck.bodies = {block("zone", "particles", {-a / 2, -a / 2, -a / 2}, {a, a, a}, um)};
  if (fill == Filling::hexes) deck.bodies = {block("bulk", "hexes", {-a / 2, -a / 2, -a / 2}, {a, a, a}, um)};
  if (fill == Filling::hybrid) {
    deck.bodies = {block("zone", "particles", {-a / 2, -a / 2, 0}, {a, a, a / 2}, um),
                   block("bulk", "hexes", {-a / 2, -a / 2, -a / 2}, {a, a, a / 2}, 2 * um)};
    deck.bodies[0].tie = "bulk";
  }
  return deck;
}

void set_stress(const MaterialPoints& points, const Symmetric3& sigma) {
  const auto stress = host_copy(points.stress);
  for (int i = 0; i < points.count; ++i) store_symmetric(stress, i, sigma);
  Kokkos::deep_copy(points.stress, stress);
}

struct Invariants {
  double mean, von_mises_stress, third; // Pa, Pa, Pa3
};
Invariants invariants_of(const Symmetric3& s) {
  return {double(trace(s)) / 3, double(von_mises(s)), double(determinant(to_tensor(s)))};
}

struct Carried {
  double stress = 0, invariants = 0; // largest errors on the way, relative
  double force = 0, moment = 0;      // of all internal forces, over their sums of magnitudes
};

void look_at_stress(const MaterialPoints& points, const Symmetric3& exact, Carried& c) {
  const auto stress = host_copy(points.stress);
  const Invariants wanted = invariants_of(exact);
  const double size = std::sqrt(double(contract(exact, exact)));
  for (int i = 0; i < points.count; ++i) {
    const Symmetric3 s = load_symmetric(stress, i), off = s + Real(-1) * exact;
    const Invariants got = invariants_of(s);
    c.stress = std::max(c.stress, std::sqrt(double(contract(off, off))) / size);
    c.invariants = std::max({c.invariants, std::abs(got.mean - wanted.mean) / size,
                             std::abs(got.von_mises_stress - wanted.von_mises_stress) / size,
                             std::abs(got.third - wanted.third) / (size * size * size)});
  }
}

void look_at_forces(const Scene& scene, Carried& c) {
  Vector3 force{0, 0, 0}, moment{0, 0, 0};
  Real forces = 0, moments = 0;
  for (const PointMass& p : point_masses(scene)) {
    force = force + p.force, moment = moment + cross(p.x, p.force);
    forces += norm(p.force), moments += norm(p.x) * norm(p.force);
  }
  c.force = std::max(c.force, double(norm(force) / forces));
  c.moment = std::max(c.moment, double(norm(moment) / moments));
}

// Every point gets the chord of its circle as velocity, and no force: the step then turns the block exactly.
Carried carry_round(const Deck& deck) {
  Simulation simulation(deck);
  const Scene& scene = simulation.scene();
  set_stress(scene.particles.points, stress_at_start), set_stress(scene.hexes.points, stress_at_start);
  simulation.start();
  const Real third = Real(1) / Kokkos::sqrt(Real(14));
  const Vector3 axis{third, 2 * third, 3 * third};
  const Tensor3 step = rotation_about(axis, 2 * pi / turn_steps);
  Carried c;
  for (int k = 1; k <= turn_steps; ++k) {
    const auto turn = [&] {
      const Real rate = Real(1 / simulation.dt());
      set_velocity(scene, [&](const Triple& t) {
        const Vector3 x{Real(t[0]), Real(t[1]), Real(t[2])}, v = rate * (multiply(step, x) - x);
        return Triple{double(v.x), double(v.y), double(v.z)};
      });
    };
    turn();
    simulation.check(); // sees how fast the points will move, and may choose another step
    turn();
    Kokkos::deep_copy(scene.particles.force, Real(0)), Kokkos::deep_copy(scene.hexes.force, Real(0));
    simulation.step();
    const Symmetric3 exact = rotate(rotation_about(axis, 2 * pi * k / turn_steps), stress_at_start);
    look_at_stress(scene.particles.points, exact, c), look_at_stress(scene.hexes.points, exact, c);
    look_at_forces(scene, c);
  }
  return c;
}

// Round-off of 360 steps, each a few rounded operations on numbers up to a hundred times what they leave.
constexpr double round_off = 360 * 100 * (sizeof(Real) == 8 ? 2.2e-16 : 1.2e-7);

} // namespace

TEST(Rotation, CarriesStressRound) {
  for (const std::string method : {"", "total Lagrangian"})
    for (const Filling fill : {Filling::particles, Filling::hexes, Filling::hybrid}) {
      const bool initial = method == "total Lagrangian";
      if (initial && fill == Filling::hexes) continue;
      Deck deck = block_under_stress(fill);
      if (initial) deck.particles.kernel_frame = KernelFrame::initial;
      const std::string name = std::string("2 stressed block turned 360 deg, ") + name_of(fill);
      const std::string parameters =
          "8 x 8 x 8 cells, 1 deg steps about (1, 2, 3)" + (method.empty() ? "" : ", " + method);
      const Carried c = carry_round(deck);
      const auto row = [&](const std::string& what, double value, const std::string& source,
                           const std::string& fault = "") {
        report({name, what, parameters, 0, "", source, value, value, round_off, true, fault});
      };
      row("largest error of the stress on the way / stress", c.stress, "exact: Q sigma Q^T");
      row("largest change of mean, von Mises stress and determinant / stress", c.invariants, "exact: none");
      row("sum of internal forces / sum of magnitudes", c.force, "exact: 0");
      row("sum of moments of internal forces / sum of magnitudes", c.moment, "exact: 0");
    }
}
