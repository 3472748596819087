// Where the classes end, and which formulation meets which test.
#include "tests/stability/cell.hpp"
#include <cmath>
#include <limits>

namespace swarf::stability {

constexpr double never = std::numeric_limits<double>::infinity();

const std::vector<Limit>& limits() {
  static const std::vector<Limit> all = {
      {"energy_residual", "energy %", "energy made or lost / (kinetic energy at the start + work done)", 0.01,
       0.1,
       "central differences at the shipped Courant number keep 1 %, what the verification allows; 10 % is "
       "what "
       "a force may err"},
      {"sawtooth", "sawtooth", "amplitude of an alternating displacement of neighbours / spacing", 0.05, 0.25,
       "neighbours' distances then alternate by 10 %; and by half, when they are pairs"},
      {"mode_left", "mode left %", "amplitude of a seeded zero-energy mode / drift that nothing opposes",
       0.05, 0.5, "five per cent of the free drift; half of it is opposed by nothing worth the name"},
      {"mode_stays", "stays %", "mean displacement of a seeded zero-energy mode later / at the start", 0.5,
       1.5, "what is held swings about zero; beyond 1 it grows"},
      {"noise", "noise %", "share of the velocity that alternates between neighbours", 0.1, 0.32,
       "1 % and 10 % of the kinetic energy"},
      {"torn", "torn %", "neighbours that an elastic body should keep, 1.6 times as far apart / all", 0, 0.05,
       "none tears; one in twenty is a crack through the ring at several places"},
      {"fragments", "fragments", "parts that have come off an elastic body", 0, 0, "it stays whole"},
      {"angular_momentum", "ang. mom. %", "change of the angular momentum / itself", 1e-3, 0.1,
       "a thousandth in a turn turns a stress by less than its own error; ten per cent is another motion"},
      {"leaked", "leaked %", "particles inside the tool / all", 0, 0.01, "contact lets none through"},
      {"stray", "stray %", "particles of the chip that have lost their neighbours / all", 0.01, 0.1,
       "a continuous chip at this speed; crumbs at the surface are no failure"},
      {"force_error", "force %", "cutting force against the measured one", 0.186, 0.5,
       "two standard deviations of the experiment; half the force is no prediction"},
      {"pressure_noise", "p noise", "pressure less the mean of the neighbours, rms / yield stress", 0.5,
       never, "half the yield stress decides what damage sees; forces need not notice"},
      {"holes", "holes %", "share of the inside farther than 1.1 spacings from every particle", 0.01, 0.1,
       "a cubic lattice has none, the middle of its cell is 0.87 away; a tenth less section is 10 % less "
       "force"},
      {"nearest", "nearest", "distance of the nearest neighbour / spacing, 5th percentile", 0.75, 0.5,
       "a lattice stretched by a third; pairs", true},
      {"pieces", "pieces", "parts of a metal that have come off where it should stretch evenly", 0, 0,
       "the force still rises"},
      {"pull_error", "force %", "force of the pull against the exact one, at 40 to 50 %", 0.03, 0.1,
       "half a row of the width; 10 % is what a force may err"},
      {"strain_missing", "strain %", "mean plastic strain against that of the shear that velocities make",
       0.02, 0.1, "2 % in a mean; 10 % of the work is missing"},
      {"strain_spread", "spread %", "standard deviation of the plastic strain / its mean, evenly sheared",
       0.05, 0.25, "a twentieth; a quarter is bands"},
      {"shear_error", "stress %", "shear stress against the law at that shear", 0.03, 0.1,
       "10 % is what a force may err"},
      {"stabilisers", "stabilisers %", "work of viscosity and hourglass forces / external work", 0.01, 0.1,
       "an even flow has no part that gradients do not see; 10 % is what a force may err"},
      {"shear_kept", "shear kept", "mean plastic strain of the chip / that of its shear plane", 0.9, 0.7,
       "friction adds to it; a tenth is what the speed of the chip is not sure of", true},
      {"mass_change", "work at 1e4 %", "change of the work under the mass factor of the cutting decks, 1e4",
       0.1, 0.5, "10 % is what a force may err"},
      {"mass_factor", "factor", "largest mass factor, of powers of ten to 1e6, with the work within 10 %",
       1e4, 1e3, "the cutting decks use 1e4; below 1e3 a run of the mill takes days", true},
      {"viscosity_change", "work %", "change of the work with viscosity 0 to 2, under mass factor 1e4", 0.1,
       0.5, "10 % is what a force may err"},
      {"viscosity_shipped", "work at 0.5 %", "the same with viscosity 0 to 0.5, as shipped", 0.1, 0.5,
       "the same"},
      {"courant", "Courant", "largest Courant number, 0.3 to 1.2, that keeps a shaken block bounded", 0.6,
       0.3, "the decks use up to 0.5; 0.3 is the shipped default", true},
      {"courant_viscous", "Courant", "the same with viscosity 2", 0.6, 0.3, "the same", true},
      {"gain", "gain %", "speed that a particle gains as it leaves all others / its speed", 0.01, 0.1,
       "it can only be slowed"},
      {"scale_error", "off", "difference of the scene scaled down to 1 nm, rescaled / spacing", 1e-9, 0.01,
       "scaled by powers of two every rounding is the same"},
  };
  return all;
}

bool applies(const Formulation& f, const Test& t) {
  if (t.particles_only && f.fill != "particles") return false;
  if (t.kind == Kind::cut && !f.follows) return false;
  return !f.deletes || t.kind == Kind::cut;
}

// Of the worst class, the measure that is farthest beyond its limit, or nearest to it.
Verdict judge(const Outcome& o) {
  Verdict worst{"stable"};
  double worst_rank = -1;
  for (const auto& [name, value] : o.measures)
    for (const Limit& l : limits()) {
      if (l.measure != name) continue;
      const double sign = l.more_is_better ? -1 : 1;
      const bool stable = sign * value <= sign * l.stable, failed = !(sign * value <= sign * l.failed);
      const double ratio = l.more_is_better ? l.stable / value : l.stable > 0 ? value / l.stable : value;
      const double rank = (failed ? 2 : stable ? 0 : 1) + (std::isfinite(ratio) ? ratio / (1 + ratio) : 1);
      if (rank <= worst_rank) continue;
      worst_rank = rank;
      worst = {failed ? "failed" : stable ? "stable" : "degraded", &l, value};
    }
  if (!o.fault.empty()) worst = {"failed", nullptr, 0};
  return worst;
}

} // namespace swarf::stability
