#include "src/units/units.hpp"
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

namespace swarf {
namespace {

using Powers = std::array<int, 5>; // of m, kg, s, K, rad

// value in SI = number * 10^exponent * numerator / denominator: exact as long as both factors are 1
struct Unit {
  Powers powers{};
  int exponent = 0;
  double numerator = 1, denominator = 1;
};

struct Symbol {
  const char* name;
  Unit unit;
  bool takes_prefix;
};

const std::vector<Symbol>& symbols() {
  constexpr double pi = std::numbers::pi;
  static const std::vector<Symbol> table = {
      {"m", {{1, 0, 0, 0, 0}}, true},
      {"g", {{0, 1, 0, 0, 0}, -3}, true},
      {"s", {{0, 0, 1, 0, 0}}, true},
      {"K", {{0, 0, 0, 1, 0}}, true},
      {"rad", {{0, 0, 0, 0, 1}}, true},
      {"N", {{1, 1, -2, 0, 0}}, true},
      {"Pa", {{-1, 1, -2, 0, 0}}, true},
      {"J", {{2, 1, -2, 0, 0}}, true},
      {"W", {{2, 1, -3, 0, 0}}, true},
      {"Hz", {{0, 0, -1, 0, 0}}, true},
      {"deg", {{0, 0, 0, 0, 1}, 0, pi, 180}, false},
      {"rev", {{0, 0, 0, 0, 1}, 0, 2 * pi, 1}, false},
      {"rpm", {{0, 0, -1, 0, 1}, 0, 2 * pi, 60}, false},
      {"min", {{0, 0, 1, 0, 0}, 0, 60, 1}, false},
      {"h", {{0, 0, 1, 0, 0}, 0, 3600, 1}, false},
  };
  return table;
}

std::optional<Unit> find_symbol(const std::string& name) {
  for (const Symbol& s : symbols())
    if (name == s.name) return s.unit;
  static const std::vector<std::pair<std::string, int>> prefixes = {
      {"n", -9}, {"u", -6}, {"µ", -6}, {"μ", -6}, {"m", -3}, {"c", -2}, {"k", 3}, {"M", 6}, {"G", 9}};
  for (const auto& [prefix, exponent] : prefixes) {
    if (!name.starts_with(prefix)) continue;
    for (const Symbol& s : symbols()) {
      if (!s.takes_prefix || name.substr(prefix.size()) != s.name) continue;
      Unit unit = s.unit;
      unit.exponent += exponent;
      return unit;
    }
  }
  return std::nullopt;
}

struct DimensionRow {
  Dimension dimension;
  Powers powers;
  DimensionText text;
};

const std::vector<DimensionRow>& dimensions() {
  static const std::vector<DimensionRow> table = {
      {Dimension::none, {}, {"a number without a unit", "", "0.5"}},
      {Dimension::length, {1, 0, 0, 0, 0}, {"a length", "m", "2.5 um"}},
      {Dimension::time, {0, 0, 1, 0, 0}, {"a time", "s", "80 us"}},
      {Dimension::angle, {0, 0, 0, 0, 1}, {"an angle", "rad", "25.2 deg"}},
      {Dimension::velocity, {1, 0, -1, 0, 0}, {"a velocity", "m/s", "30 m/min"}},
      {Dimension::acceleration, {1, 0, -2, 0, 0}, {"an acceleration", "m/s2", "9.81 m/s2"}},
      {Dimension::angular_velocity, {0, 0, -1, 0, 1}, {"a speed of rotation", "rad/s", "10000 rpm"}},
      {Dimension::rate, {0, 0, -1, 0, 0}, {"a rate or frequency", "1/s", "1 1/s"}},
      {Dimension::density, {-3, 1, 0, 0, 0}, {"a density", "kg/m3", "4430 kg/m3"}},
      {Dimension::pressure, {-1, 1, -2, 0, 0}, {"a stress or modulus", "Pa", "110 GPa"}},
      {Dimension::temperature, {0, 0, 0, 1, 0}, {"a temperature", "K", "25 degC"}},
      {Dimension::specific_heat, {2, 0, -2, -1, 0}, {"a specific heat", "J/kg/K", "526.3 J/kg/K"}},
      {Dimension::conductivity, {1, 1, -3, -1, 0}, {"a thermal conductivity", "W/m/K", "6.3 W/m/K"}},
      {Dimension::conductance, {0, 1, -3, -1, 0}, {"a thermal conductance per area", "W/m2/K", "1e6 W/m2/K"}},
      {Dimension::per_kelvin, {0, 0, 0, -1, 0}, {"a coefficient per kelvin", "1/K", "2.4e-3 1/K"}},
      {Dimension::per_pressure, {1, -1, 2, 0, 0}, {"a coefficient per stress", "1/Pa", "1e-14 1/Pa"}},
      {Dimension::force, {1, 1, -2, 0, 0}, {"a force", "N", "10.1 N"}},
      {Dimension::line_force, {0, 1, -2, 0, 0}, {"a force per length", "N/m", "22.2 N/mm"}},
      {Dimension::percentage, {}, {"a percentage", "%", "5 %"}},
  };
  return table;
}

const DimensionRow& row_of(Dimension dimension) {
  const auto& table = dimensions();
  return *std::find_if(table.begin(), table.end(),
                       [&](const auto& row) { return row.dimension == dimension; });
}

void multiply(Unit& product, const Unit& factor, int power) {
  for (std::size_t i = 0; i < product.powers.size(); ++i) product.powers[i] += power * factor.powers[i];
  product.exponent += power * factor.exponent;
  for (int k = 0; k < std::abs(power); ++k) {
    product.numerator *= power > 0 ? factor.numerator : factor.denominator;
    product.denominator *= power > 0 ? factor.denominator : factor.numerator;
  }
}

// Symbols joined by / and *, each with an optional power: "J/kg/K", "N/mm2", "1/s", "m/s^2". Empty if
// unknown.
std::optional<Unit> parse_unit(const std::string& text) {
  Unit product;
  int sign = 1;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find_first_of("/*", at), text.size());
    std::string name = text.substr(at, end - at);
    int power = 1;
    if (const auto digit = name.find_last_not_of("0123456789");
        digit != std::string::npos && digit + 2 == name.size()) {
      power = name.back() - '0';
      name.pop_back();
      if (name.ends_with('^')) name.pop_back();
    }
    const bool is_leading_one = name == "1" && at == 0 && end < text.size();
    if (!is_leading_one) {
      const auto unit = find_symbol(name);
      if (!unit || power == 0) return std::nullopt;
      multiply(product, *unit, sign * power);
    }
    if (end == text.size()) return product;
    sign = text[end] == '/' ? -1 : 1;
    at = end + 1;
  }
  return std::nullopt; // ends with / or *
}

std::string trim(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// number * 10^exponent rounded once: the exponent is added to that of the text.
std::optional<double> scale_decimal(const std::string& number, int exponent) {
  const auto e = number.find_first_of("eE");
  const std::string mantissa = number.substr(0, e);
  int written = 0;
  if (e != std::string::npos) {
    const std::size_t skip = number[e + 1] == '+' ? 2 : 1;
    const auto r = std::from_chars(number.data() + e + skip, number.data() + number.size(), written);
    if (r.ec != std::errc() || std::abs(written) > 100000) return std::nullopt;
  }
  const std::string scaled = fmt::format("{}e{}", mantissa, written + exponent);
  double value = 0;
  const auto r = std::from_chars(scaled.data(), scaled.data() + scaled.size(), value);
  if (r.ec != std::errc()) return std::nullopt;
  return value;
}

} // namespace

const DimensionText& describe(Dimension dimension) { return row_of(dimension).text; }

std::variant<double, UnitError> parse_quantity(const std::string& text, Dimension dimension) {
  const DimensionRow& wanted = row_of(dimension);
  const std::string expected =
      fmt::format("expected {} such as \"{}\"", wanted.text.name, wanted.text.example);
  std::string rest = trim(text);
  if (rest.starts_with('+')) rest.erase(0, 1);
  double number = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error == std::errc::invalid_argument)
    return UnitError{fmt::format("{}, got \"{}\", which does not begin with a number", expected, text)};
  const auto out_of_range =
      UnitError{fmt::format("{}, got \"{}\", which is out of the range of numbers", expected, text)};
  if (error != std::errc()) return out_of_range;
  if (!std::isfinite(number))
    return UnitError{fmt::format("{}, got \"{}\", which is not a finite number", expected, text)};
  const std::string written(rest.data(), std::size_t(end - rest.data()));
  const std::string symbol = trim(rest.substr(written.size()));
  if (symbol.empty())
    return UnitError{fmt::format("{}, got \"{}\", which has no unit. In SI units, write \"{} {}\"", expected,
                                 text, written, wanted.text.si)};

  if (symbol == "degC" && dimension == Dimension::temperature) return number + 273.15;
  if (dimension == Dimension::percentage && symbol == "%") return number;
  if (dimension == Dimension::percentage || symbol == "%")
    return UnitError{fmt::format("{}, got \"{}\": \"{}\" is not a unit of this", expected, text, symbol)};
  const bool is_celsius = symbol == "degC" || symbol == "C" || symbol == "°C";
  const auto unit = is_celsius ? Unit{{0, 0, 0, 1, 0}} : parse_unit(symbol);
  if (!unit) return UnitError{fmt::format("{}, got \"{}\": there is no unit \"{}\"", expected, text, symbol)};
  if (unit->powers != wanted.powers) {
    for (const DimensionRow& row : dimensions())
      if (row.powers == unit->powers)
        return UnitError{fmt::format("{}, got \"{}\", which is {}", expected, text, row.text.name)};
    return UnitError{fmt::format("{}, got \"{}\": \"{}\" is not a unit of this", expected, text, symbol)};
  }
  if (is_celsius) return UnitError{fmt::format("{}, got \"{}\": write degC", expected, text)};
  const auto scaled = scale_decimal(written, unit->exponent);
  const double value = scaled ? *scaled * unit->numerator / unit->denominator : HUGE_VAL;
  if (!std::isfinite(value)) return out_of_range;
  return value;
}

std::string format_quantity(double value, Dimension dimension, int digits) {
  std::string number = fmt::format("{}", value);
  if (digits > 0 && int(number.size()) > digits + 1) number = fmt::format("{:.{}g}", value, digits);
  const std::string& unit = describe(dimension).si;
  if (!unit.empty()) return fmt::format("{} {}", number, unit);
  if (number.find_first_of(".en") == std::string::npos) number += ".0"; // else TOML reads -0 as 0
  return number;
}

} // namespace swarf
