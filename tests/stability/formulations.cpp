// The rows. Each changes the shipped defaults, whatever the scene's deck says.
#include "tests/stability/cell.hpp"
#include "tests/verification/drive.hpp"

namespace swarf::stability {
namespace {

using test::shipped_defaults;

// Textbook updated Lagrangian: plain sums, viscosity on the whole difference of velocity, nothing else.
void plain(Deck& deck) {
  deck.particles = shipped_defaults().particles;
  deck.particles.correction = deck.particles.correct_forces = false;
  deck.particles.viscosity_form = "monaghan";
  deck.particles.hourglass_viscosity = 0;
}

void corrected(Deck& deck) {
  plain(deck);
  deck.particles.correction = deck.particles.correct_forces = true;
}

void hexes(Deck& deck, const std::string& hourglass, bool deletes) {
  deck.hexes = shipped_defaults().hexes;
  deck.hexes.hourglass = hourglass;
  deck.hexes.delete_failed = deletes;
  if (deletes) deck.hexes.delete_at_strain = 1;
}

std::vector<Formulation> make() {
  const std::string p = "particles", h = "hexes";
  const auto defaults = [](Deck& d) { d.particles = shipped_defaults().particles; };
  return {
      {"plain", "updated Lagrangian: plain sums, Monaghan viscosity", p, false, true, plain},
      {"corrected", "+ gradient correction, forces its adjoint", p, false, true, corrected},
      {"reconstructed", "+ correction, reconstructed viscosity", p, false, true,
       [](Deck& d) { corrected(d), d.particles.viscosity_form = "reconstructed"; }},
      {"hourglass_viscosity", "+ correction, hourglass viscosity 0.3", p, false, true,
       [](Deck& d) { corrected(d), d.particles.hourglass_viscosity = 0.3; }},
      {"artificial_stress", "+ correction, artificial stress 0.3", p, false, true,
       [](Deck& d) { corrected(d), d.particles.artificial_stress = 0.3; }},
      {"pressure_diffusion", "+ correction, pressure diffusion 0.003", p, false, true,
       [](Deck& d) { corrected(d), d.particles.pressure_diffusion = 0.003; }},
      {"defaults", "shipped defaults", p, false, true, defaults},
      {"cutting", "the cutting decks", p, false, true,
       [](Deck& d) {
         static const Deck deck =
             read_deck(std::string(SWARF_SOURCE_DIR) + "/inputs/orthogonal_cutting.toml");
         d.particles = deck.particles;
       }},
      {"hexes_stiffness", "hexes, stiffness hourglass control (shipped)", h, false, true,
       [](Deck& d) { hexes(d, "stiffness", false); }},
      {"hexes_viscous", "hexes, viscous hourglass control", h, false, true,
       [](Deck& d) { hexes(d, "viscous", false); }},
      {"hexes_stiffness_deleted", "hexes, stiffness, deleted at strain 1", h, true, true,
       [](Deck& d) { hexes(d, "stiffness", true); }},
      {"hexes_viscous_deleted", "hexes, viscous, deleted at strain 1", h, true, true,
       [](Deck& d) { hexes(d, "viscous", true); }},
  };
}

} // namespace

const std::vector<Formulation>& formulations() {
  static const std::vector<Formulation> all = make();
  return all;
}

} // namespace swarf::stability
