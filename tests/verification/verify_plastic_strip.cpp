// A metal strip pulled by half its length: it flows, and stretches evenly until the force is largest.
#include "tests/verification/case.hpp"
#include "tests/verification/plastic_strip.hpp"

using namespace swarf;
using namespace swarf::test;
using namespace swarf::test::plastic_strip;

namespace {

struct Pulled {
  double early = 0, late = 0;             // force / first section, Pa, pulled by 20 to 25 % and 45 to 50 %
  double exact_early = 0, exact_late = 0; // of an even strip
  double residual = 0, shifting = 0;      // over the external work
  int parts = 0;
  EvenOrder order;
};

Pulled run(const Pull& pull, const std::string& fill, bool shifting) {
  Deck deck = strip(pull, fill);
  deck.particles.shifting = shifting;
  Simulation simulation(deck);
  const Scene& scene = simulation.scene();
  start_evenly(scene, pull);
  ForceBetween early(0.2, 0.25, pull), late(0.45, 0.5, pull);
  simulation.start();
  Pulled p;
  advance(simulation, *deck.run.end_time, [&] {
    const HistorySample s = simulation.take_sample();
    p.residual = std::max(p.residual, std::abs(s.residual));
    early.look(s.time, s.external), late.look(s.time, s.external);
  });
  const HistorySample s = simulation.take_sample();
  p.early = early.stress(), p.exact_early = early.exact(deck.materials[0], fill);
  p.late = late.stress(), p.exact_late = late.exact(deck.materials[0], fill);
  p.residual /= s.external, p.shifting = s.shifting / s.external;
  if (fill == "particles") p.parts = count_parts(scene.particles, reach), p.order = order(scene);
  return p;
}

// Reasons why rows fail; empty where they pass.
struct Faults {
  std::string late, parts, nearest, early{};
};

// `late`: what the force of the last twentieth is compared with, its source and what it may err.
struct Late {
  double reference;
  std::string source;
  double allowed;
};

const std::string pairs = "layers across the pull move together in pairs, and it parts: tension drives them, "
                          "only a stiffness holds them, and where it flows slowly they form sooner than they "
                          "can be shifted apart";
const std::string notch =
    "a notch opens at the free surface of the neck, where particles have drawn apart along it, and "
    "it parts; why is not known";
const std::string law = "exact: J2, plane strain, logarithmic strain";

void report_strip(const Pull& pull, const std::string& fill, bool shifting, const Pulled& p, const Late& late,
                  const Faults& fault) {
  char text[128];
  std::snprintf(text, sizeof text,
                "linear hardening, 1 GPa + %.1f GPa e_p, %d x %d x %d cells, ends at %g m/s",
                pull.hardening / 1e9, pull.along, pull.across, deep, pull.speed);
  const std::string name = "4 strip pulled plastically, " + fill + (shifting ? "" : ", without shifting");
  const std::string run = text, end = run + ", pulled by 50 %";
  report({name, "worst energy residual / external work", end, 0, "", "energy balance", p.residual, p.residual,
          0.01, true});
  if (shifting) // without it some pairs have parted by then, and some not
    report({name, "force / first section, pulled by 20 to 25 %", run, p.exact_early, "Pa", law, p.early,
            relative_error(p.early, p.exact_early), 0.03, false, fault.early});
  if (fill == "hexes") return;
  report({name, "force / first section, pulled by 45 to 50 %", run, late.reference, "Pa", late.source, p.late,
          relative_error(p.late, late.reference), late.allowed, false, fault.late});
  report({name, "parts", end, 1, "", "a metal that hardens does not part here", double(p.parts),
          std::abs(p.parts - 1.0), 0, true, fault.parts});
  report({name, "nearest neighbour, 5th percentile / spacing", end, 1, "", "cubic lattice", p.order.nearest,
          std::max(0.0, 1 - p.order.nearest), 0.25, true, fault.nearest});
  if (!shifting) return;
  report({name, "share of the inside farther than 1.1 spacings from every particle", end, 0, "",
          "no point of a cubic lattice is farther than 0.87", p.order.holes, p.order.holes, 0.01, true});
  report({name, "work lost by shifting / external work", end, 0, "", "even fields have nothing to lose",
          p.shifting, std::abs(p.shifting), 0.01, true});
}

void stretch_evenly(double speed, bool shifting, const Faults& fault) {
  const Pull pull{48, 12, 0.5, stays_even, speed};
  const Pulled p = run(pull, "particles", shifting);
  report_strip(pull, "particles", shifting, p, {p.exact_late, law, 0.03}, fault);
}

} // namespace

TEST(PlasticStrip, StretchesEvenly) { stretch_evenly(0.3, true, {pairs, pairs, ""}); }
TEST(PlasticStrip, StretchesEvenlySlowly) { stretch_evenly(0.15, true, {pairs, pairs, "", pairs}); }
TEST(PlasticStrip, StretchesEvenlyWithoutShifting) { stretch_evenly(0.3, false, {pairs, pairs, pairs}); }

// Necks of two lattices may differ by a cell of their width, 12 %, of which the force has half.
TEST(PlasticStrip, Necks) {
  const Pull pull{48, 12, 0.5, necks, 0.3};
  const Pulled hexes = run(pull, "hexes", true);
  const Late late{hexes.late, "hexes of the same size, this program", 0.06};
  report_strip(pull, "hexes", true, hexes, late, {});
  report_strip(pull, "particles", true, run(pull, "particles", true), late, {notch, notch, ""});
  report_strip(pull, "particles", false, run(pull, "particles", false), late, {pairs, pairs, pairs});
}
