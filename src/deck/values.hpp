// One value of a deck: from TOML to SI with its check, and back.
#pragma once
#include "src/deck/keys.hpp"
#include <toml++/toml.h>

namespace swarf {

// All that is wrong with a deck, one line each: "file:line: key: what was expected. What to do."
class DeckReport {
 public:
  explicit DeckReport(std::string deck_file) : file(std::move(deck_file)) {}
  void add(int line, const std::string& key, const std::string& message);
  void add(const toml::node& at, const std::string& key, const std::string& message);
  std::size_t count() const { return lines.size(); }
  void throw_if_any() const; // DeckError, in the order of the deck

 private:
  std::string file;
  std::vector<std::pair<int, std::string>> lines;
};

// ` Did you mean "spacing"?` or nothing, if no candidate is near.
std::string suggest(const std::string& word, const std::vector<std::string>& candidates);

// "more than 0 m", "0 to 1 (ends included)", or "" without bounds.
std::string describe_bounds(const Bounds& range, Dimension dimension);

// What a value must be, for the message of an error and for the reference page.
std::string describe_expected(Dimension dimension, const Allowed& allowed);

// Each reads a node into `value` and returns what is wrong with it, "" if nothing. `name` is the key's.
struct ValueRule {
  std::string name;
  Dimension dimension;
  Allowed allowed;
  int digits = 0; // of what is written; 0: as many as give the number back
};
std::string read_value(const toml::node& node, const ValueRule& rule, std::string& value);
std::string read_value(const toml::node& node, const ValueRule& rule, bool& value);
std::string read_value(const toml::node& node, const ValueRule& rule, int& value);
std::string read_value(const toml::node& node, const ValueRule& rule, double& value);
std::string read_value(const toml::node& node, const ValueRule& rule, OverTemperature& value);
std::string read_value(const toml::node& node, const ValueRule& rule, std::optional<double>& value);
std::string read_value(const toml::node& node, const ValueRule& rule, Triple& value);
std::string read_value(const toml::node& node, const ValueRule& rule, std::vector<double>& value);
std::string read_value(const toml::node& node, const ValueRule& rule,
                       std::optional<std::array<int, 3>>& value);
std::string read_value(const toml::node& node, const ValueRule& rule,
                       std::optional<std::array<double, 5>>& value);

// TOML that read_value turns into the same value; "" for an optional one that is not set.
std::string write_value(const std::string& value, const ValueRule& rule);
std::string write_value(bool value, const ValueRule& rule);
std::string write_value(int value, const ValueRule& rule);
std::string write_value(double value, const ValueRule& rule);
std::string write_value(const OverTemperature& value, const ValueRule& rule);
std::string write_value(const std::optional<double>& value, const ValueRule& rule);
std::string write_value(const Triple& value, const ValueRule& rule);
std::string write_value(const std::vector<double>& value, const ValueRule& rule);
std::string write_value(const std::optional<std::array<int, 3>>& value, const ValueRule& rule);
std::string write_value(const std::optional<std::array<double, 5>>& value, const ValueRule& rule);

} // namespace swarf
