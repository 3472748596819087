// The rows. Each changes the shipped defaults, whatever the scene's deck says.
#include "tests/stability/cell.hpp"
#include "tests/verification/drive.hpp"

namespace swarf::stability {
namespace {

using test::shipped_defaults;

// Updated Lagrangian with plain sums and a viscosity, nothing else.
void plain(Deck& deck) {
  deck.particles = shipped_defaults().particles;
  deck.particles.correction = deck.particles.correct_forces = false;
  deck.particles.hourglass_stiffness = 0;
  deck.particles.shifting = false;
}

void corrected(Deck& deck) {
  plain(deck);
  deck.particles.correction = deck.particles.correct_forces = true;
}

void hexes(Deck& deck, const std::string& hourglass, bool deletes) {
  deck.hexes = shipped_defaults().hexes;
  deck.hexes.hourglass = value_of_word<HourglassMethod>(hourglass);
  deck.hexes.delete_failed = deletes;
  if (deletes) deck.hexes.delete_at_strain = 1;
}

// The shipped defaults or another base, and one change.
using Change = std::function<void(ParticlesDeck&)>;
Formulation changed(const std::string& name, const std::string& text, void (*base)(Deck&),
                    const Change& change) {
  return {name, text, "particles", false, true, [=](Deck& d) { base(d), change(d.particles); }};
}

void defaults(Deck& deck) { deck.particles = shipped_defaults().particles; }

void cutting(Deck& deck) {
  static const Deck cut = read_deck(std::string(SWARF_SOURCE_DIR) + "/inputs/orthogonal_cutting.toml");
  deck.particles = cut.particles;
}

Formulation total_lagrangian(const std::string& name, const std::string& text, double viscosity,
                             double hourglass_stiffness) {
  return {name, text, "particles", false, false, [=](Deck& d) {
            defaults(d);
            d.particles.kernel_frame = KernelFrame::initial, d.particles.viscosity_linear = viscosity;
            d.particles.hourglass_stiffness = hourglass_stiffness;
          }};
}

std::vector<Formulation> make() {
  const Change none = [](ParticlesDeck&) {};
  const Change pressure_diffusion = [](ParticlesDeck& p) { p.pressure_diffusion = 0.003; };
  const auto hourglass_stiffness = [](double share) {
    return [=](ParticlesDeck& p) { p.hourglass_stiffness = share; };
  };
  const std::string stiffness = "hexes, stiffness hourglass control",
                    viscous = "hexes, viscous hourglass control";
  return {
      changed("plain", "plain sums", plain, none),
      changed("corrected", "corrected gradient, forces its adjoint", corrected, none),
      changed("pressure_diffusion", "corrected + pressure diffusion 0.003", corrected, pressure_diffusion),
      changed("hourglass_stiffness", "corrected + hourglass stiffness 0.3", corrected,
              hourglass_stiffness(0.3)),
      changed("shifting", "corrected + shifting", corrected, [](ParticlesDeck& p) { p.shifting = true; }),
      changed("defaults", "shipped defaults", defaults, none),
      changed("defaults_pressure_diffusion", "defaults + pressure diffusion 0.003", defaults,
              pressure_diffusion),
      changed("defaults_soft", "defaults without hourglass stiffness", defaults, hourglass_stiffness(0)),
      changed("defaults_stiffer", "defaults, hourglass stiffness 2", defaults, hourglass_stiffness(2)),
      changed("cutting", "as the cutting decks", cutting, none),
      changed("cutting_unshifted", "as the cutting decks, without shifting", cutting,
              [](ParticlesDeck& p) { p.shifting = false; }),
      total_lagrangian("total_lagrangian", "total Lagrangian without viscosity", 0, 0),
      total_lagrangian("total_lagrangian_viscous", "total Lagrangian + viscosity 0.3", 0.3, 0),
      total_lagrangian("total_lagrangian_stiff", "total Lagrangian + viscosity, stiffness 0.3", 0.3, 0.3),
      {"hexes_stiffness", stiffness + " (shipped)", "hexes", false, true,
       [](Deck& d) { hexes(d, "stiffness", false); }},
      {"hexes_viscous", viscous, "hexes", false, true, [](Deck& d) { hexes(d, "viscous", false); }},
      {"hexes_stiffness_deleted", stiffness + ", deleted at strain 1", "hexes", true, true,
       [](Deck& d) { hexes(d, "stiffness", true); }},
      {"hexes_viscous_deleted", viscous + ", deleted at strain 1", "hexes", true, true,
       [](Deck& d) { hexes(d, "viscous", true); }},
  };
}

} // namespace

const std::vector<Formulation>& formulations() {
  static const std::vector<Formulation> all = make();
  return all;
}

} // namespace swarf::stability
