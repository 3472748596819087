#include "src/output/restart_deck.hpp"
#include "src/files/results.hpp"
#include <fmt/format.h>
#include <map>
#include <sstream>
#include <toml++/toml.h>

namespace swarf {

std::string facets_text(const Scene& scene) {
  if (scene.tool_facets.empty()) return "";
  std::string corners;
  for (const auto& facet : scene.tool_facets)
    for (const Triple& corner : facet)
      corners.append(reinterpret_cast<const char*>(corner.data()), 3 * sizeof(corner[0]));
  return fmt::format("{} with the checksum {}", scene.tool_facets.size(), hash_text(corners));
}

std::string restart_text(const Deck& deck, const Scene& scene) {
  Deck physics = deck;
  physics.title.clear(), physics.picked.reset(), physics.windows.reset();
  physics.mechanistic.reset();
  physics.output = OutputDeck{};
  physics.output.force_scale = deck.output.force_scale; // of rows that are written already
  physics.run.accuracy.reset();
  if (!deck.tool || deck.tool->material.empty()) // else the tool's cells go as far as heat gets by the end
    physics.run.end_time.reset(), physics.run.end_immersion.reset();
  physics.run.threads = 0, physics.run.energy_tolerance = physics.run.energy_limit = 0;
  if (physics.tool) physics.tool->file.clear();
  for (BodyDeck& body : physics.bodies) body.file.clear();
  std::string text = resolved_deck(physics);
  for (std::size_t b = 0; b < deck.bodies.size(); ++b)
    if (deck.bodies[b].has_file())
      text += fmt::format("\n[\"the file of body {}\"]\nholds = \"{}\"\n", b + 1, scene.body_files.at(b));
  if (!deck.tool) return text;
  return text + fmt::format("\n[\"the tool's surface\"]\nfacets = \"{}\"\n", facets_text(scene));
}

namespace {

using Values = std::map<std::string, std::string>; // by "[section] key"

// Tables that have names of their own within a section are called by these: [body "cut zone"].
void flatten(const toml::table& table, const std::string& path, Values& values) {
  for (auto&& [key, node] : table) {
    const std::string name(key.str()), place = path.empty() ? name : path + "." + name;
    if (const toml::table* inner = node.as_table()) {
      flatten(*inner, place, values);
    } else if (node.is_array_of_tables()) {
      for (auto&& entry : *node.as_array()) {
        const toml::table& its = *entry.as_table();
        flatten(its, fmt::format("{} \"{}\"", place, its["name"].value_or(std::string())), values);
      }
    } else {
      std::ostringstream text;
      if (const auto number = node.value_exact<double>())
        text << fmt::format("{:#}", *number); // the shortest text that reads back as it
      else
        node.visit([&](const auto& value) { text << value; });
      values[fmt::format("[{}] {}", path, name)] = text.str();
    }
  }
}

Values values_in(const std::string& text) {
  Values values;
  flatten(toml::parse(text), "", values);
  return values;
}

} // namespace

std::vector<std::string> list_restart_changes(const std::string& before, const std::string& now) {
  const auto old_values = values_in(before), values = values_in(now);
  std::vector<std::string> changes;
  for (const auto& [path, value] : values) {
    const auto old = old_values.find(path);
    if (old == old_values.end())
      changes.push_back(fmt::format("{} = {}", path, value));
    else if (old->second != value)
      changes.push_back(fmt::format("{} = {}, was {}", path, value, old->second));
  }
  for (const auto& [path, value] : old_values)
    if (!values.contains(path)) changes.push_back(path + " left out");
  return changes;
}

} // namespace swarf
