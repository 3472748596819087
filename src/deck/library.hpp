// The materials that come with the program, from materials.toml: each with its source.
#pragma once
#include "src/deck/deck.hpp"

namespace swarf {

struct LibraryMaterial {
  MaterialDeck material; // its name as a deck gives it: "library:NAME"
  std::string about, source;
};

// In the order of their names.
const std::vector<LibraryMaterial>& material_library();

bool names_library(const std::string& material); // "library:..."

// Adds those that bodies and tool name and the deck does not define itself, in the order of all names.
void add_library_materials(Deck& deck);

// For the user: every material with its law, constants and source.
std::string list_materials();

} // namespace swarf
