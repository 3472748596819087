#include "src/deck/lines.hpp"
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

namespace swarf {
namespace {

std::string trim(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == text.npos ? "" : text.substr(first);
}

} // namespace

std::string line_of(const std::string& file, const std::string& heading, const std::string& key) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return file;
  std::ifstream deck(file);
  std::string text;
  int section = 0;
  for (int line = 1; std::getline(deck, text); ++line) {
    const std::string words = trim(text);
    if (section > 0 && words.starts_with('[')) break;
    if (words.starts_with(heading)) section = line;
    if (section == 0 || key.empty() || !words.starts_with(key)) continue;
    if (trim(words.substr(key.size())).starts_with('=')) return fmt::format("{}:{}", file, line);
  }
  return section > 0 ? fmt::format("{}:{}", file, section) : file;
}

} // namespace swarf
