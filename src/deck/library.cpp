#include "src/deck/library.hpp"
#include "src/deck/section.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace swarf {

std::string materials_text(); // made by CMake

namespace {

constexpr const char* prefix = "library:";

LibraryMaterial read_entry(const std::string& name, toml::table table) {
  LibraryMaterial entry;
  entry.about = table["about"].value_or(std::string()),
  entry.source = table["source"].value_or(std::string());
  if (entry.about.empty() || entry.source.empty())
    throw std::logic_error("library of materials: " + name + " has no source");
  table.erase("about"), table.erase("source");
  DeckReport report("library of materials");
  read_keys(table, name, material_keys(), entry.material, report);
  report.throw_if_any();
  entry.material.name = prefix + name;
  return entry;
}

} // namespace

const std::vector<LibraryMaterial>& material_library() {
  static const std::vector<LibraryMaterial> library = [] {
    std::vector<LibraryMaterial> all;
    const toml::table root = toml::parse(materials_text());
    for (auto&& [name, node] : root) all.push_back(read_entry(std::string(name.str()), *node.as_table()));
    return all;
  }();
  return library;
}

bool names_library(const std::string& material) { return material.starts_with(prefix); }

void add_library_materials(Deck& deck) {
  std::vector<std::string> wanted;
  for (const BodyDeck& body : deck.bodies) wanted.push_back(body.material);
  if (deck.tool) wanted.push_back(deck.tool->material);
  for (const std::string& name : wanted) {
    if (!names_library(name) || find_material(deck, name)) continue;
    for (const LibraryMaterial& entry : material_library())
      if (entry.material.name == name) deck.materials.push_back(entry.material);
  }
  std::sort(deck.materials.begin(), deck.materials.end(),
            [](const MaterialDeck& a, const MaterialDeck& b) { return a.name < b.name; }); // as TOML has them
}

std::string list_materials() {
  std::string text =
      "Materials of the library. A deck names them as material = \"library:NAME\", of a body or, "
      "where the law is rigid, of a tool.\n";
  for (const LibraryMaterial& entry : material_library()) {
    text += fmt::format("\n{}\n  {}\n", entry.material.name, entry.about);
    for (const auto& key : material_keys()) {
      if (!applies(material_keys(), key, entry.material)) continue;
      const std::string value = write_field(key, entry.material);
      if (!value.empty()) text += fmt::format("  {:<22} {}\n", key.name, value);
    }
    text += fmt::format("  source: {}\n", entry.source);
  }
  return text;
}

} // namespace swarf
