// `swarf check`: what a deck will cost and whether it is fit, without running it.
#pragma once
#include <string>

namespace swarf {

// Builds the scene, times a few steps of it, prints the findings. Returns the number of warnings.
// Throws DeckError. Kokkos must be initialised.
// `picture`: a PNG of the scene, or empty.
int check_deck(const std::string& file, const std::string& picture);

} // namespace swarf
