// Just enough JSON to write: text, numbers, lists, objects.
#pragma once
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace swarf::test {

inline std::string json(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out + '"';
}

inline std::string json(double value) {
  if (!std::isfinite(value)) return "null"; // JSON has no NaN
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

inline std::string json_array(const std::vector<std::string>& items) {
  std::string out = "[";
  for (const std::string& item : items) out += (out.size() > 1 ? ", " : "") + item;
  return out + ']';
}

inline std::string json(const std::vector<double>& values) {
  std::vector<std::string> items;
  for (const double v : values) items.push_back(json(v));
  return json_array(items);
}

inline std::string json_object(const std::vector<std::pair<std::string, std::string>>& members) {
  std::string out = "{";
  for (const auto& [key, value] : members) {
    if (out.size() > 1) out += ", ";
    out += json(key);
    out += ": ";
    out += value;
  }
  return out + '}';
}

} // namespace swarf::test
