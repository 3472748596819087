// Tables of reference values, tests/verification/data/*.csv: a first line with '#' that says the source, a
// line of names, numbers.
#pragma once
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace swarf::test {

struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;

  std::vector<double> column(const std::string& name) const {
    for (std::size_t c = 0; c < names.size(); ++c)
      if (names[c] == name) {
        std::vector<double> values;
        for (const auto& row : rows) values.push_back(row.at(c));
        return values;
      }
    throw std::runtime_error("the table has no column " + name);
  }
};

inline Table read_table(const std::string& name) {
  const std::string path = SWARF_SOURCE_DIR "/tests/verification/data/" + name;
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  Table table;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::stringstream cells(line);
    std::vector<std::string> words;
    for (std::string word; std::getline(cells, word, ',');) words.push_back(word);
    if (table.names.empty()) {
      table.names = words;
      continue;
    }
    table.rows.emplace_back();
    for (const std::string& word : words) table.rows.back().push_back(std::stod(word));
  }
  return table;
}

// Linear between the points of a curve; the last value outside.
inline double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
  for (std::size_t k = 1; k < x.size(); ++k)
    if (at <= x[k]) return y[k - 1] + (y[k] - y[k - 1]) * (at - x[k - 1]) / (x[k] - x[k - 1]);
  return y.back();
}

} // namespace swarf::test
