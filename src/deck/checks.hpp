// Rules between keys. They run on sections whose own keys were read without an error.
#pragma once
#include "src/deck/values.hpp"

namespace swarf {

void check_material(const MaterialDeck& material, const toml::table& table, DeckReport& report);
void check_body(const BodyDeck& body, const toml::table& table, DeckReport& report);
// Also makes the STL file's name absolute, so that the resolved deck can be read from any folder.
struct StlPlace {
  std::string deck, instead; // the deck's file, and the STL to take where the one it names is missing
};
void check_tool(ToolDeck& tool, const toml::table& table, const StlPlace& place, DeckReport& report);
void check_output(const OutputDeck& output, const toml::table& table, DeckReport& report);

// Between sections; `root` is the whole deck.
void check_deck(const Deck& deck, const toml::table& root, DeckReport& report);

// What is wrong with the name of a material that is neither in the deck nor in the library.
std::string describe_missing(const std::string& material, const std::vector<std::string>& known);

// Does this body have the face? Reads shape, radii and angles.
std::vector<std::string> list_faces(const BodyDeck& body);
// "" if the face has no opposite.
std::string find_opposite(const std::string& face);

// Methods that need others, or do not go together.
void check_methods(const Deck& deck, const toml::table& root, DeckReport& report);

// The line of the key if the deck has it, else that of its table.
inline const toml::node& find_place(const toml::table& table, const std::string& key) {
  const toml::node* node = table.get(key);
  return node ? *node : table;
}

} // namespace swarf
