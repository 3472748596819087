// Fills one section of a deck from its table, as the rows of its keys say.
#pragma once
#include "src/deck/values.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace swarf {

template <class Section>
ValueRule rule_of(const Key<Section>& key, int digits = 0) {
  return {key.name, key.dimension, key.allowed, digits};
}

// Reads one value into the field of the key. Returns what is wrong.
template <class Section>
std::string fill_field(const toml::node& node, const Key<Section>& key, Section& section) {
  return std::visit(
      [&](auto field) -> std::string {
        if constexpr (std::is_same_v<decltype(field), std::monostate>) {
          return ""; // read by its own code
        } else if constexpr (std::is_same_v<decltype(field), WordField<Section>>) {
          std::string word;
          const std::string error = read_value(node, rule_of(key), word);
          if (error.empty())
            field.set(section,
                      int(std::find(field.known->begin(), field.known->end(), word) - field.known->begin()));
          return error;
        } else {
          return read_value(node, rule_of(key), section.*field);
        }
      },
      key.field);
}

// As TOML; "" for what is not given, or written by code of its own.
template <class Section>
std::string write_field(const Key<Section>& key, const Section& section, int digits = 0) {
  return std::visit(
      [&](auto field) -> std::string {
        if constexpr (std::is_same_v<decltype(field), std::monostate>)
          return "";
        else if constexpr (std::is_same_v<decltype(field), WordField<Section>>)
          return write_value((*field.known)[std::size_t(field.get(section))], rule_of(key));
        else
          return write_value(section.*field, rule_of(key, digits));
      },
      key.field);
}

template <class Section>
bool has_default(const Key<Section>& key) {
  return key.value != "required" && key.value != "optional";
}

// Throws std::logic_error for a row whose default is not allowed by the row itself.
template <class Section>
void fill_default(const Key<Section>& key, Section& section) {
  const toml::table text = toml::parse("value = " + key.value);
  const std::string error = fill_field(*text.get("value"), key, section);
  if (!error.empty()) throw std::logic_error("default of " + key.name + ": " + error);
}

// 0, empty or not given, whatever the default.
template <class Section>
void clear_fields(const Keys<Section>& keys, Section& section) {
  for (const auto& key : keys)
    std::visit(
        [&](auto field) {
          if constexpr (std::is_same_v<decltype(field), WordField<Section>>)
            field.set(section, 0);
          else if constexpr (!std::is_same_v<decltype(field), std::monostate>)
            section.*field = {};
        },
        key.field);
}

// Those of the keys that apply, to the law, shape or kind that the section has.
template <class Section>
void fill_defaults(const Keys<Section>& keys, Section& section) {
  for (const auto& key : keys)
    if (has_default(key) && applies(keys, key, section)) fill_default(key, section);
}

// Does it depend on this key whether others apply?
template <class Section>
bool decides(const Keys<Section>& keys, const std::string& name) {
  for (const auto& key : keys)
    for (const Condition& condition : key.when)
      if (condition.key == name) return true;
  return false;
}

template <class Section>
std::string describe_mismatch(const Keys<Section>& keys, const std::string& name, const Section& section) {
  for (const auto& key : keys) {
    if (key.name != name) continue;
    for (const Condition& condition : key.when) {
      const std::string* text = text_of(keys, condition.key, section);
      const auto& wanted = condition.values;
      if (text && std::find(wanted.begin(), wanted.end(), *text) == wanted.end())
        return fmt::format("does not apply to {} = \"{}\". Remove it", condition.key, *text);
    }
  }
  return "does not apply here. Remove it";
}

// Keys of the table that have no row at all, or none that applies to this shape, law or kind.
template <class Section>
void report_strangers(const toml::table& table, const std::string& path, const Keys<Section>& keys,
                      const Section& section, bool is_decided, DeckReport& report) {
  std::vector<std::string> names;
  for (const auto& key : keys) names.push_back(key.name);
  for (auto&& [key_text, node] : table) {
    const std::string name(key_text.str()), place = path + "." + name;
    const auto is_named = [&](const auto& key) { return key.name == name; };
    const auto is_used = [&](const auto& key) { return key.name == name && applies(keys, key, section); };
    if (std::none_of(keys.begin(), keys.end(), is_named))
      report.add(int(key_text.source().begin.line), place, "is not a known key." + suggest(name, names));
    else if (is_decided && std::none_of(keys.begin(), keys.end(), is_used))
      report.add(node, place, describe_mismatch(keys, name, section));
  }
}

// Keys that others depend on (shape, law, kind) stand before them in their rows, so one pass suffices.
template <class Section>
void read_keys(const toml::table& table, const std::string& path, const Keys<Section>& keys, Section& section,
               DeckReport& report) {
  clear_fields(keys, section);
  bool is_decided = true;
  for (const auto& key : keys) {
    if (!is_decided) break;
    if (!applies(keys, key, section)) continue;
    const std::string place = path + "." + key.name;
    if (const toml::node* node = table.get(key.name)) {
      const std::string error = fill_field(*node, key, section);
      if (error.empty()) continue;
      report.add(*node, place, error);
      is_decided = !decides(keys, key.name);
    } else if (key.value == "required") {
      const std::string expected = describe_expected(key.dimension, key.allowed);
      report.add(table, place, fmt::format("is missing. Expected {}: {}", expected, key.help));
      is_decided = !decides(keys, key.name);
    } else if (has_default(key)) {
      fill_default(key, section);
    }
  }
  report_strangers(table, path, keys, section, is_decided, report);
}

} // namespace swarf
