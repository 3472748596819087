// Rules between keys. They run on sections whose own keys were read without an error.
#pragma once
#include "src/deck/values.hpp"

namespace swarf {

void check_material(const MaterialDeck& material, const toml::table& table, DeckReport& report);
// Where files that the deck names are: relative to it, or, if missing, in the results folder that keeps them.
struct FilePlace {
  std::string deck, kept; // the deck's file, and that folder, or empty
};
// Both also make the names of files absolute, so that the resolved deck can be read from any folder.
// `row`: of the deck's bodies.
struct BodyPlace {
  FilePlace files;
  int row = 0;
};
void check_body(BodyDeck& body, const toml::table& table, const BodyPlace& place, DeckReport& report);
void check_tool(ToolDeck& tool, const toml::table& table, const FilePlace& place, DeckReport& report);
// Makes the name absolute: beside the deck or, where it is missing there, the copy that was kept. False:
// neither.
bool find_file(std::string& name, const std::string& deck, const std::string& kept);
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
