// 10. Orthogonal cutting of Ti-6Al-4V at three speeds and three depths, against the measured forces and chip
// thickness ratios. The shipped deck at a spacing that divides all depths; the inertia of all speeds is
// alike. Which row of particles passes below the edge moves a force by some per cent, so each is the mean of
// three cuts, as deep and a third of a spacing more and less.
#include "tests/verification/case.hpp"
#include "tests/verification/orthogonal_cut.hpp"
#include "tests/verification/read_table.hpp"
#include <algorithm>
#include <array>
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

// Offset: by how much deeper it cuts; forces are in proportion to the depth.
Cut run(double speed, double nominal, double friction, double offset) {
  const double depth = nominal + offset;
  Deck deck = orthogonal(speed, nominal, friction, dx);
  deck.tool->position[1] -= offset;
  Simulation simulation(deck);
  simulation.start();
  simulation.take_sample();
  Cut mean;
  double weight = 0, last = 0, external = 0;
  const double end = cut / speed;
  while (simulation.time() < end) {
    simulation.step();
    if (simulation.steps_to_check() > 0) continue;
    simulation.check();
    const HistorySample s = simulation.take_sample();
    mean.residual = std::max(mean.residual, std::abs(s.residual));
    external = s.external;
    if (s.time > 0.5 * end) {
      const double dt = s.time - last;
      mean.cutting -= s.force[0] * dt, mean.feed += s.force[1] * dt;
      mean.ratio += chip_ratio(simulation.scene(), speed, depth) * dt, weight += dt;
    }
    last = s.time;
  }
  const double share = nominal / depth;
  mean.cutting *= share / weight, mean.feed *= share / weight, mean.ratio /= weight;
  mean.residual /= external;
  return mean;
}

struct Mean {
  double value = 0, error = 0; // its standard error
};

Mean mean_of(const std::array<Cut, 3>& cuts, double Cut::*of) {
  Mean m;
  for (const Cut& c : cuts) m.value += c.*of / 3;
  for (const Cut& c : cuts) m.error += std::pow(c.*of - m.value, 2) / 6; // (n - 1) n
  m.error = std::sqrt(m.error);
  return m;
}

double friction_at(double m_per_min) { return m_per_min < 7 ? 0.24 : m_per_min < 20 ? 0.21 : 0.18; }

// At 6.67 um, with a tool of WC-Co that takes heat from the chip.
const std::string force = "the force of the slow cuts is high, within what the experiment scatters";
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
  std::array<Cut, 3> ours;
  for (int k = 0; k < 3; ++k)
    ours[std::size_t(k)] =
        run(m_per_min / 60, micrometres * um, friction_at(m_per_min), (k == 2 ? -1 : k) * dx / 3);
  char name[96], text[160];
  std::snprintf(name, sizeof name, "10 orthogonal cutting, %g m/min, %g um", m_per_min, micrometres);
  const auto row = [&](const std::string& what, const std::string& key, const std::string& unit,
                       double Cut::*of, double allowed, const std::string& fault) {
    const Mean mean = mean_of(ours, of);
    std::snprintf(text, sizeof text,
                  "spacing 6.67 um, three cuts, +- %.2g; measured +- %.0f %%, the paper's CEL model %+.0f %%",
                  mean.error, 100 * column(key + "_lam0_2s") / column(key + "_lam0_exp"),
                  100 * (column(key + "_lam0_fem") / column(key + "_lam0_exp") - 1));
    const double error = relative_error(mean.value, column(key + "_lam0_exp"));
    // All scatter from run to run across what is allowed: none is asserted to fail.
    report({name, what, text, column(key + "_lam0_exp"), unit, "Ducobu et al. 2024, dry", mean.value, error,
            allowed, false, !(error <= allowed) ? fault : ""});
  };
  row("cutting force", "Fc", "N", &Cut::cutting, 0.10, force);
  EXPECT_LT(relative_error(mean_of(ours, &Cut::cutting).value, column("Fc_lam0_exp")), 0.25);
  row("feed force", "Ff", "N", &Cut::feed, column("Ff_lam0_2s") / column("Ff_lam0_exp"), edge);
  row("chip thickness ratio", "ratio", "", &Cut::ratio, column("ratio_lam0_2s") / column("ratio_lam0_exp"),
      chip);
  const double residual = std::max({ours[0].residual, ours[1].residual, ours[2].residual});
  report({name, "worst energy residual / external work", "spacing 6.67 um", 0, "", "energy balance", residual,
          residual, 0.01, true});
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
