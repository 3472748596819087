// 10. Orthogonal cutting of Ti-6Al-4V at three speeds and three depths, against the measured forces and chip
// thickness ratios. The shipped deck at a spacing that divides all depths; the inertia of all speeds is
// alike.
#include "tests/verification/case.hpp"
#include "tests/verification/orthogonal_cut.hpp"
#include "tests/verification/read_table.hpp"
#include <cmath>

using namespace swarf;
using namespace swarf::test;
using namespace swarf::test::orthogonal_cut;

namespace {

constexpr double dx = 20.0 / 3 * um;

struct Cut {
  double cutting = 0, feed = 0, ratio = 0, residual = 0; // N; chip thickness / depth; of the external work
};

// The chip above the old surface runs along the rake at speed / ratio.
double chip_ratio(const Scene& scene, double speed, double depth) {
  double sum = 0;
  int found = 0;
  const auto x = host_copy(scene.particles.position), v = host_copy(scene.particles.velocity);
  for (int i = 0; i < scene.particles.count; ++i) {
    if (x(i, 1) < depth + dx || x(i, 1) > 2 * depth) continue;
    sum += (v(i, 0) - speed) * -std::sin(rake) + v(i, 1) * std::cos(rake), ++found;
  }
  return found > 0 ? speed / (sum / found) : 0;
}

Cut run(double speed, double depth, double friction) {
  Simulation simulation(orthogonal(speed, depth, friction, dx));
  simulation.start();
  simulation.sample();
  Cut mean;
  double weight = 0, last = 0, external = 0;
  const double end = cut / speed;
  while (simulation.time() < end) {
    simulation.step();
    if (simulation.steps_to_check() > 0) continue;
    simulation.check();
    const HistorySample s = simulation.sample();
    mean.residual = std::max(mean.residual, std::abs(s.residual));
    external = s.external;
    if (s.time > 0.5 * end) {
      const double dt = s.time - last;
      mean.cutting -= s.force[0] * dt, mean.feed += s.force[1] * dt;
      mean.ratio += chip_ratio(simulation.scene(), speed, depth) * dt, weight += dt;
    }
    last = s.time;
  }
  mean.cutting /= weight, mean.feed /= weight, mean.ratio /= weight;
  mean.residual /= external;
  return mean;
}

double friction_at(double m_per_min) { return m_per_min < 7 ? 0.24 : m_per_min < 20 ? 0.21 : 0.18; }

// At 6.67 um, with a tool of WC-Co that takes heat from the chip.
const std::string force =
    "which row of particles passes below the edge decides for 5 %; finer particles give less at 30 m/min";
const std::string edge =
    "low, as in the paper's CEL model: the friction of its law gives no more along the rake; and the "
    "clearance face, where the surface springs back, scatters from run to run";
const std::string chip =
    "at 30 m/min, as in the paper's CEL model, thicker than the measured one, which is segmented";

// F_c is allowed 10 %; F_f and the ratio the experiment's own scatter (2 sigma).
void compare(double m_per_min, double micrometres) {
  const Table table = read_table("ti64_orthogonal_cutting.csv");
  const auto column = [&](const std::string& name) {
    for (std::size_t r = 0; r < table.rows.size(); ++r)
      if (table.rows[r][0] == m_per_min && table.rows[r][1] == micrometres) return table.column(name)[r];
    throw std::runtime_error("no such row");
  };
  const Cut ours = run(m_per_min / 60, micrometres * um, friction_at(m_per_min));
  char name[96], text[160];
  std::snprintf(name, sizeof name, "10 orthogonal cutting, %g m/min, %g um", m_per_min, micrometres);
  const auto row = [&](const std::string& what, const std::string& key, const std::string& unit, double value,
                       double allowed, const std::string& fault) {
    std::snprintf(text, sizeof text, "spacing 6.67 um; measured +- %.0f %%, the paper's CEL model %+.0f %%",
                  100 * column(key + "_lam0_2s") / column(key + "_lam0_exp"),
                  100 * (column(key + "_lam0_fem") / column(key + "_lam0_exp") - 1));
    const double error = relative_error(value, column(key + "_lam0_exp"));
    // All scatter from run to run across what is allowed: none is asserted to fail.
    report({name, what, text, column(key + "_lam0_exp"), unit, "Ducobu et al. 2024, dry", value, error,
            allowed, false, !(error <= allowed) ? fault : ""});
  };
  row("cutting force", "Fc", "N", ours.cutting, 0.10, force);
  EXPECT_LT(relative_error(ours.cutting, column("Fc_lam0_exp")), 0.25);
  row("feed force", "Ff", "N", ours.feed, column("Ff_lam0_2s") / column("Ff_lam0_exp"), edge);
  row("chip thickness ratio", "ratio", "", ours.ratio, column("ratio_lam0_2s") / column("ratio_lam0_exp"),
      chip);
  report({name, "worst energy residual / external work", "spacing 6.67 um", 0, "", "energy balance",
          ours.residual, ours.residual, 0.01, true});
}

} // namespace

TEST(OrthogonalCuttingLong, Speed30Depth40) { compare(30, 40); }
TEST(OrthogonalCuttingLong, Speed30Depth60) { compare(30, 60); }
TEST(OrthogonalCuttingLong, Speed30Depth80) { compare(30, 80); }
TEST(OrthogonalCuttingLong, Speed10Depth40) { compare(10, 40); }
TEST(OrthogonalCuttingLong, Speed10Depth60) { compare(10, 60); }
TEST(OrthogonalCuttingLong, Speed10Depth80) { compare(10, 80); }
TEST(OrthogonalCuttingLong, Speed5Depth40) { compare(5, 40); }
TEST(OrthogonalCuttingLong, Speed5Depth60) { compare(5, 60); }
TEST(OrthogonalCuttingLong, Speed5Depth80) { compare(5, 80); }
