#include "src/geometry/mesh_text.hpp"
#include "src/deck/deck.hpp"
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <sstream>

namespace swarf {
namespace {

std::string trim(const std::string& text) {
  const char* blanks = " \t\r";
  const auto begin = text.find_first_not_of(blanks);
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string unquoted(const std::string& text) {
  const bool has = text.size() > 1 && text.front() == '"' && text.back() == '"';
  return has ? text.substr(1, text.size() - 2) : text;
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(trim(field));
  while (!fields.empty() && fields.back().empty()) fields.pop_back();
  return fields;
}

std::string describe(const MeshRow& row, std::size_t field) {
  return field < row.fields.size() ? "\"" + row.fields[field] + "\"" : "nothing";
}

} // namespace

std::string upper(std::string text) {
  for (char& c : text) c = char(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string MeshKeyword::option(const std::string& key) const {
  for (const std::string& one : options)
    if (const auto equals = one.find('=');
        equals != one.npos && upper(trim(one.substr(0, equals))) == upper(key))
      return unquoted(trim(one.substr(equals + 1)));
  return "";
}

bool MeshKeyword::has(const std::string& key) const {
  return std::any_of(options.begin(), options.end(), [&](const std::string& one) {
    return upper(trim(one.substr(0, one.find('=')))) == upper(key);
  });
}

std::vector<MeshKeyword> read_mesh_text(const std::string& text) {
  std::vector<MeshKeyword> all{{}};
  bool goes_on = false;
  std::istringstream stream(text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text); // a byte-order mark
  int line = 0;
  for (std::string raw; std::getline(stream, raw);) {
    ++line;
    const std::string content = trim(raw);
    if (content.empty() || content.starts_with("**") || content.starts_with('#')) continue;
    std::vector<std::string> fields = split(content);
    if (content.starts_with('*')) {
      all.push_back({line, upper(trim(fields.front().substr(1))), {fields.begin() + 1, fields.end()}, {}});
      goes_on = false;
      continue;
    }
    auto& rows = all.back().rows;
    if (goes_on && !rows.empty())
      rows.back().fields.insert(rows.back().fields.end(), fields.begin(), fields.end());
    else
      rows.push_back({line, fields});
    goes_on = content.ends_with(',');
  }
  return all;
}

void refuse_line(const std::string& file, int line, const std::string& what) {
  throw DeckError(fmt::format("{}:{}: {}", file, line, what));
}

double number_in(const MeshRow& row, std::size_t field, const std::string& file) {
  std::string word = field < row.fields.size() ? row.fields[field] : "";
  std::replace(word.begin(), word.end(), 'D', 'e'), std::replace(word.begin(), word.end(), 'd', 'e');
  if (word.starts_with('+')) word.erase(0, 1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
    refuse_line(file, row.line,
                fmt::format("expected a number in column {}, got {}", field + 1, describe(row, field)));
  return value;
}

long label_in(const MeshRow& row, std::size_t field, const std::string& file) {
  const std::string word = field < row.fields.size() ? row.fields[field] : "";
  long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || value < 1)
    refuse_line(
        file, row.line,
        fmt::format("expected the number of a node or an element in column {}, got {}; names of other sets "
                    "are not read",
                    field + 1, describe(row, field)));
  return value;
}

} // namespace swarf
