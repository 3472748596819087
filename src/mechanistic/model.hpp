// Forces on an end mill from coefficients: each element of the edges feels (K_c chip + K_e) of its depth,
// tangential, radial and axial (Y. Altintas, Manufacturing Automation, 2nd ed., ch. 2). A chip too thin to be
// cut leaves K_e.
#pragma once
#include "src/mechanistic/mill_edge.hpp"
#include "src/output/history.hpp"

namespace swarf {

// In the order of the keys: K_tc K_rc K_ac K_te K_re K_ae.
using Coefficients = std::array<double, 6>;
Coefficients coefficients_of(const MechanisticDeck& model);
void set_coefficients(const Coefficients& values, MechanisticDeck& model);
inline constexpr std::array<const char*, 6> coefficient_names{"K_tc", "K_rc", "K_ac", "K_te", "K_re", "K_ae"};

struct MillLoad {
  Triple force{};    // N, on the tool
  double torque = 0; // N m, about the spindle's axis
};
// What each coefficient, were it 1, gives for one tooth: the load is their sum.
std::array<MillLoad, 6> find_shares(const MillEdge& edge, const MillCut& cut, int tooth, double immersion);

// Columns of a run's history, as far as the model knows them (time immersion force_x _y _z _planar torque
// tooth1_...), and uncut_chip and without_chip of tooth 0 at the end face; every half degree over one turn
// and over what the deck runs through.
HistoryTable run_model(const Deck& deck, const MechanisticDeck& model);

} // namespace swarf
