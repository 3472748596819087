// What was changed in a deck, from the resolved texts, so that no key can be forgotten.
#include "src/accuracy/chart_settings.hpp"
#include "src/output/restart_deck.hpp"
#include <fmt/format.h>
#include <map>
#include <regex>
#include <sstream>

namespace swarf {
namespace {

using Section = std::vector<std::pair<std::string, std::string>>; // keys and values in order

// 17 digits as 6: for reading.
std::string shorten(const std::string& text) {
  static const std::regex number(R"([-+]?[0-9]+\.?[0-9]*(e[-+]?[0-9]+)?)");
  std::string result;
  auto at = text.cbegin();
  for (std::sregex_iterator found(text.begin(), text.end(), number), end; found != end; ++found) {
    result.append(at, text.cbegin() + found->position());
    const std::string digits = found->str();
    result += digits.size() > 7 ? fmt::format("{:.6g}", std::stod(digits)) : digits;
    at = text.cbegin() + found->position() + found->length();
  }
  return result.append(at, text.cend());
}

// Sections by name; bodies and their faces by the body's.
std::vector<std::pair<std::string, Section>> split(const std::string& resolved) {
  std::vector<std::pair<std::string, Section>> sections{{"", {}}};
  std::istringstream in(resolved);
  std::string line, body;
  while (std::getline(in, line)) {
    const auto equals = line.find(" = ");
    if (line == "[[output.published]]") break; // lines in a picture: no settings
    if (line.starts_with('[')) {
      sections.push_back({line == "[body.faces]" ? "[body " + body + " faces]" : line, {}});
    } else if (equals != line.npos && !line.starts_with('#')) {
      const std::string key = line.substr(0, equals), value = line.substr(equals + 3);
      auto& [name, section] = sections.back();
      if (name == "[[body]]" && key == "name") body = value, name = "[body " + value + "]";
      section.emplace_back(key, value);
    }
  }
  return sections;
}

} // namespace

std::vector<std::string> list_text_changes(const std::string& before, const std::string& after,
                                           bool exactly) {
  std::map<std::string, std::map<std::string, std::string>> old, now;
  const auto old_sections = split(before), sections = split(after);
  for (const auto& [name, section] : old_sections) old[name].insert(section.begin(), section.end());
  for (const auto& [name, section] : sections) now[name].insert(section.begin(), section.end());
  std::vector<std::string> changes;
  for (const auto& [name, section] : old_sections)
    if (!now.contains(name)) changes.push_back(name + " left out");
  for (const auto& [name, section] : sections) {
    for (const auto& [key, value] : section) {
      const auto was = old[name].find(key);
      std::string new_text = shorten(value);
      if (was == old[name].end()) {
        changes.push_back(fmt::format("{} {} = {}", name, key, new_text));
        continue;
      }
      std::string old_text = shorten(was->second);
      if (exactly && old_text == new_text) old_text = was->second, new_text = value;
      if (old_text != new_text)
        changes.push_back(fmt::format("{} {} = {}, was {}", name, key, new_text, old_text));
    }
    for (const auto& [key, value] : old[name])
      if (!now[name].contains(key) && key != "accuracy")
        changes.push_back(fmt::format("{} {} left out", name, key));
  }
  return changes;
}

std::vector<std::string> list_changes(const Deck& before, const Deck& after) {
  return list_text_changes(resolved_deck(before), resolved_deck(after), false);
}

} // namespace swarf
