#include "src/deck/values.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>
#include <sstream>

namespace swarf {
namespace {

// Short text of a node, as the user wrote it.
std::string show(const toml::node& node) {
  std::ostringstream out;
  node.visit([&](const auto& n) { out << n; });
  std::string text = node.is_floating_point() ? fmt::format("{}", *node.value<double>()) : out.str();
  if (node.is_string()) text = fmt::format("\"{}\"", **node.as_string()); // not as an escaped literal
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.size() > 60) text.replace(57, std::string::npos, "...");
  return text;
}

double from_display(double bound, Dimension dimension) {
  return dimension == Dimension::angle ? bound * std::numbers::pi / 180 : bound; // as parse_quantity does
}

std::string show_bound(double bound, Dimension dimension) {
  const std::string unit = dimension == Dimension::angle ? "deg" : describe(dimension).si;
  return unit.empty() ? fmt::format("{}", bound) : fmt::format("{} {}", bound, unit);
}

bool is_within(double x, const Bounds& range, Dimension dimension) {
  const double low = from_display(range.low, dimension), high = from_display(range.high, dimension);
  return (range.low_open ? x > low : x >= low) && (range.high_open ? x < high : x <= high);
}

std::string quote(const std::string& text) {
  std::ostringstream out;
  const toml::value<std::string> value(text);
  const auto flags = toml::toml_formatter::default_flags & ~toml::format_flags::allow_literal_strings;
  out << toml::toml_formatter(value, flags);
  return out.str();
}

// The unit that a number without one most likely has; nothing where the value would then be refused.
std::string advise_unit(const toml::node& node, const ValueRule& rule, const std::string& as) {
  const std::string unit = rule.dimension == Dimension::angle              ? "deg"
                           : rule.dimension == Dimension::angular_velocity ? "rpm"
                                                                           : describe(rule.dimension).si;
  const std::string quantity = show(node) + " " + unit;
  const auto parsed = parse_quantity(quantity, rule.dimension);
  const auto* range = std::get_if<Bounds>(&rule.allowed);
  const double* x = std::get_if<double>(&parsed);
  if (!x || (range && !is_within(*x, *range, rule.dimension))) return "";
  const bool is_si = unit == describe(rule.dimension).si && rule.dimension != Dimension::percentage;
  return fmt::format(". {} {}\"{}\"", is_si ? "In SI units, write" : "Write", as, quantity);
}

constexpr std::size_t most_table_points = 16; // TemperatureTable::most

// What lies beyond is a slip, and overflows where lengths are multiplied: it would be found as something
// else.
std::string describe_slip(double x, const ValueRule& rule) {
  const auto beyond = [&](double most, const char* as) {
    return std::abs(x) > most
               ? fmt::format("{} {} is {}. Look at the unit", x, describe(rule.dimension).si, as)
               : "";
  };
  if (rule.dimension == Dimension::length) {
    const auto* range = std::get_if<Bounds>(&rule.allowed);
    if (range && range->low == 0 && range->low_open && x < 1e-15)
      return fmt::format("{} m is less than the size of an atom's core. Look at the unit", x);
    return beyond(1e12, "farther than the planets");
  }
  if (rule.dimension == Dimension::velocity) return beyond(3e8, "faster than light");
  return "";
}

// One number of a value or of an array. `as` is what to write it as: "spacing = " or nothing in an array.
std::string read_number(const toml::node& node, const ValueRule& rule, const std::string& as, double& x) {
  const DimensionText& text = describe(rule.dimension);
  if (rule.dimension == Dimension::none) {
    if (!node.is_number())
      return fmt::format("expected {} such as {}, got {}", text.name, text.example, show(node));
    x = *node.value<double>();
    if (!std::isfinite(x)) return fmt::format("expected a finite number, got {}", show(node));
  } else if (node.is_number()) {
    return fmt::format("expected {} with a unit such as \"{}\", got {}{}", text.name, text.example,
                       show(node), advise_unit(node, rule, as));
  } else if (node.is_string()) {
    const auto parsed = parse_quantity(**node.as_string(), rule.dimension);
    if (const auto* error = std::get_if<UnitError>(&parsed)) return error->message;
    x = std::get<double>(parsed);
  } else {
    return fmt::format("expected {} with a unit such as \"{}\", got {}", text.name, text.example, show(node));
  }
  const auto* range = std::get_if<Bounds>(&rule.allowed);
  if (range && !is_within(x, *range, rule.dimension))
    return fmt::format("expected {}, {}, got {}", text.name, describe_bounds(*range, rule.dimension),
                       show(node));
  return describe_slip(x, rule);
}

std::string read_numbers(const toml::node& node, const ValueRule& rule, std::size_t count, double* x) {
  const toml::array* array = node.as_array();
  if (!array || array->size() != count)
    return fmt::format("expected an array of {} entries, each {}, got {}", count,
                       describe(rule.dimension).name, show(node));
  for (std::size_t i = 0; i < count; ++i) {
    const std::string error = read_number(*array->get(i), rule, "", x[i]);
    if (!error.empty()) return fmt::format("entry {}: {}", i + 1, error);
  }
  return "";
}

std::string read_count(const toml::node& node, double low, double high, int& value) {
  const toml::value<int64_t>* integer = node.as_integer();
  if (!integer) return fmt::format("expected a whole number, got {}", show(node));
  const double top = std::min(high, double(std::numeric_limits<int>::max()));
  if (double(**integer) < low || double(**integer) > top)
    return fmt::format("expected a whole number, {} to {}, got {}", low, top, show(node));
  value = int(**integer);
  return "";
}

template <class Numbers>
std::string write_numbers(const Numbers& numbers, const ValueRule& rule) {
  std::vector<std::string> entries;
  for (double x : numbers) entries.push_back(write_value(x, {"", rule.dimension, Bounds{}, rule.digits}));
  return fmt::format("[{}]", fmt::join(entries, ", "));
}

std::size_t edit_distance(const std::string& a, const std::string& b) { // Levenshtein
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j - 1] + 1, above + 1, diagonal + (a[i - 1] != b[j - 1])});
      diagonal = above;
    }
  }
  return row[b.size()];
}

} // namespace

void DeckReport::add(int line, const std::string& key, const std::string& message) {
  const std::string place = line > 0 ? fmt::format("{}:{}", file, line) : file;
  const bool ends = message.ends_with('.') || message.ends_with('?');
  lines.emplace_back(line, fmt::format("{}: {}: {}{}", place, key, message, ends ? "" : "."));
}

void DeckReport::add(const toml::node& at, const std::string& key, const std::string& message) {
  add(int(at.source().begin.line), key, message);
}

void DeckReport::throw_if_any() const {
  if (lines.empty()) return;
  auto sorted = lines;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> messages;
  for (const auto& line : sorted) messages.push_back(line.second);
  throw DeckError(fmt::format("{}", fmt::join(messages, "\n")));
}

std::string suggest(const std::string& word, const std::vector<std::string>& candidates) {
  std::size_t best = std::min(std::max<std::size_t>(word.size() / 3, 2) + 1, word.size());
  std::string nearest;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best) best = distance, nearest = candidate;
  }
  return nearest.empty() ? "" : fmt::format(" Did you mean \"{}\"?", nearest);
}

std::string describe_bounds(const Bounds& range, Dimension dimension) {
  const std::string low = show_bound(range.low, dimension), high = show_bound(range.high, dimension);
  const bool has_low = std::isfinite(range.low), has_high = std::isfinite(range.high);
  const std::string from = fmt::format("{} {}", range.low_open ? "more than" : "at least", low);
  const std::string to = fmt::format("{} {}", range.high_open ? "less than" : "at most", high);
  if (has_low && has_high) return from + " and " + to;
  return has_low ? from : has_high ? to : "";
}

std::string describe_expected(Dimension dimension, const Allowed& allowed) {
  if (const auto* choices = std::get_if<Choices>(&allowed)) {
    std::vector<std::string> quoted;
    for (const auto& choice : *choices) quoted.push_back(fmt::format("\"{}\"", choice));
    return fmt::format("{}", fmt::join(quoted, " or "));
  }
  if (std::holds_alternative<Direction>(allowed)) return "three numbers, not all zero";
  if (std::holds_alternative<Text>(allowed)) return "text in quotes";
  if (const auto* counts = std::get_if<Counts>(&allowed))
    return fmt::format("{} whole numbers", counts->entries);
  return describe(dimension).name;
}

std::string read_value(const toml::node& node, const ValueRule& rule, std::string& value) {
  const std::string expected = describe_expected(rule.dimension, rule.allowed);
  if (!node.is_string()) return fmt::format("expected {}, got {}", expected, show(node));
  value = **node.as_string();
  if (const auto* choices = std::get_if<Choices>(&rule.allowed)) {
    if (std::find(choices->begin(), choices->end(), value) == choices->end())
      return fmt::format("expected {}, got {}.{}", expected, show(node), suggest(value, *choices));
  } else if (value.find_first_not_of(" \t\n") == std::string::npos) {
    return "expected a text that is not empty";
  }
  return "";
}

std::string read_value(const toml::node& node, const ValueRule&, bool& value) {
  if (!node.is_boolean()) return fmt::format("expected true or false, got {}", show(node));
  value = **node.as_boolean();
  return "";
}

std::string read_value(const toml::node& node, const ValueRule& rule, int& value) {
  const Bounds& range = std::get<Bounds>(rule.allowed);
  return read_count(node, range.low, range.high, value);
}

std::string read_value(const toml::node& node, const ValueRule& rule, double& value) {
  return read_number(node, rule, rule.name + " = ", value);
}

// [["300 K", "6.6 W/m/K"], ["900 K", "13 W/m/K"], ...], or a value.
std::string read_value(const toml::node& node, const ValueRule& rule, OverTemperature& value) {
  const toml::array* rows = node.as_array();
  value.points.clear();
  if (!rows) return read_value(node, rule, value.value);
  const DimensionText& text = describe(rule.dimension);
  if (rows->size() < 2 || rows->size() > most_table_points)
    return fmt::format("expected {}, or a table over temperature of 2 to {} points such as [[\"300 K\", "
                       "\"{}\"], [\"900 K\", \"{}\"]], got {}",
                       text.name, most_table_points, text.example, text.example, show(node));
  for (std::size_t i = 0; i < rows->size(); ++i) {
    const toml::array* row = rows->get(i)->as_array();
    if (!row || row->size() != 2)
      return fmt::format("entry {}: expected a pair such as [\"300 K\", \"{}\"], got {}", i + 1, text.example,
                         show(*rows->get(i)));
    std::array<double, 2> point{};
    std::string error =
        read_number(*row->get(0), {"", Dimension::temperature, Bounds{0, 1e5, true}}, "", point[0]);
    if (error.empty()) error = read_number(*row->get(1), rule, "", point[1]);
    if (error.empty() && !(point[1] > 0))
      error = fmt::format("expected more than 0 {} in a table, got {}", text.si, show(*row->get(1)));
    if (error.empty() && i > 0 && !(point[0] > value.points.back()[0]))
      error = fmt::format("expected a temperature above the one before, {} K, got {}", value.points.back()[0],
                          show(*row->get(0)));
    if (!error.empty()) return fmt::format("entry {}: {}", i + 1, error);
    value.points.push_back(point);
  }
  return "";
}

std::string read_value(const toml::node& node, const ValueRule& rule, std::optional<double>& value) {
  double x = 0;
  const std::string error = read_value(node, rule, x);
  if (error.empty()) value = x;
  return error;
}

std::string read_value(const toml::node& node, const ValueRule& rule, Triple& value) {
  const std::string error = read_numbers(node, rule, 3, value.data());
  if (!error.empty() || !std::holds_alternative<Direction>(rule.allowed)) return error;
  if (value == Triple{}) return "expected a direction: three numbers, not all zero";
  return "";
}

std::string read_value(const toml::node& node, const ValueRule& rule, std::vector<double>& value) {
  const toml::array* array = node.as_array();
  if (!array)
    return fmt::format("expected an array, each entry {}, got {}", describe(rule.dimension).name, show(node));
  value.resize(array->size());
  return read_numbers(node, rule, value.size(), value.data());
}

std::string read_value(const toml::node& node, const ValueRule& rule,
                       std::optional<std::array<int, 3>>& value) {
  const auto entries = std::size_t(std::get<Counts>(rule.allowed).entries);
  const toml::array* array = node.as_array();
  if (!array || array->size() != entries)
    return fmt::format("expected an array of {} whole numbers, got {}", entries, show(node));
  std::array<int, 3> counts{};
  for (std::size_t i = 0; i < entries; ++i) {
    const std::string error = read_count(*array->get(i), 1, 1e6, counts[i]);
    if (!error.empty()) return fmt::format("entry {}: {}", i + 1, error);
  }
  if (entries == 2) counts = {counts[0], counts[0], counts[1]};
  value = counts;
  return "";
}

std::string read_value(const toml::node& node, const ValueRule& rule,
                       std::optional<std::array<double, 5>>& value) {
  std::array<double, 5> x{};
  const std::string error = read_numbers(node, rule, x.size(), x.data());
  if (error.empty()) value = x;
  return error;
}

std::string write_value(const std::string& value, const ValueRule&) {
  return value.empty() ? "" : quote(value);
}
std::string write_value(bool value, const ValueRule&) { return value ? "true" : "false"; }
std::string write_value(int value, const ValueRule&) { return std::to_string(value); }
std::string write_value(double value, const ValueRule& rule) {
  const std::string text = format_quantity(value, rule.dimension, rule.digits);
  return rule.dimension == Dimension::none ? text : quote(text);
}
std::string write_value(const OverTemperature& value, const ValueRule& rule) {
  if (value.points.empty()) return write_value(value.value, rule);
  std::vector<std::string> rows;
  for (const auto& [T, x] : value.points)
    rows.push_back(fmt::format("[{}, {}]",
                               write_value(T, {"", Dimension::temperature, Bounds{}, rule.digits}),
                               write_value(x, rule)));
  return fmt::format("[{}]", fmt::join(rows, ", "));
}
std::string write_value(const std::optional<double>& value, const ValueRule& rule) {
  return value ? write_value(*value, rule) : "";
}
std::string write_value(const Triple& value, const ValueRule& rule) { return write_numbers(value, rule); }
std::string write_value(const std::vector<double>& value, const ValueRule& rule) {
  return write_numbers(value, rule);
}
std::string write_value(const std::optional<std::array<int, 3>>& value, const ValueRule& rule) {
  if (!value) return "";
  const auto& [x, y, z] = *value;
  return std::get<Counts>(rule.allowed).entries == 2 ? fmt::format("[{}, {}]", x, z)
                                                     : fmt::format("[{}, {}, {}]", x, y, z);
}
std::string write_value(const std::optional<std::array<double, 5>>& value, const ValueRule& rule) {
  return value ? write_numbers(*value, rule) : "";
}

} // namespace swarf
