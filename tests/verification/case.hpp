// What a verification case reports. scripts/verify names a folder in SWARF_VERIFICATION and makes the table
// and the plots of docs/reports/verification.md from what lands there; without it a case is a plain test.
#pragma once
#include "tests/verification/json.hpp"
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace swarf::test {

// One row of the table. `allowed` follows from the reference's own uncertainty, or from what the method
// promises at this resolution, and is set before the run.
struct Row {
  std::string name;       // "1 bar wave, particles": the number of the case sorts the table
  std::string what;       // is tested: a quantity
  std::string parameters; // of this run: resolution, formulation
  double reference = 0;
  std::string unit;   // of reference and ours; "" for a plain number
  std::string source; // of the reference: paper, table, or the formula
  double ours = 0;
  double error = 0; // relative_error(), unless `absolute`
  double allowed = 0;
  bool absolute = false; // error and allowed have the unit of ours and are no fractions
  // Why the row fails today, if it does: the test then asserts that it fails, so that a mended cause is seen.
  std::string known_fault{};
};

inline double relative_error(double ours, double reference) { return std::abs(ours / reference - 1); }

inline void append_line(const char* file, const std::string& line) {
  const char* folder = std::getenv("SWARF_VERIFICATION");
  if (!folder) return;
  std::filesystem::create_directories(folder);
  std::ofstream out(std::filesystem::path(folder) / file, std::ios::app);
  out << line << '\n';
  if (!out) throw std::runtime_error("cannot write into " + std::string(folder));
}

// A row that fails fails the test, and stays in the table. A NaN fails.
inline void report(const Row& r) {
  const bool pass = r.error <= r.allowed;
  EXPECT_EQ(pass, r.known_fault.empty())
      << r.name << ": " << r.what << " (" << r.parameters << ") = " << r.ours << ' ' << r.unit
      << ", reference " << r.reference << (pass ? ": mended, delete known_fault" : "");
  std::printf("%s: %s %.6g %s, reference %.6g, error %.3g, allowed %.3g\n", r.name.c_str(), r.what.c_str(),
              r.ours, r.unit.c_str(), r.reference, r.error, r.allowed);
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  append_line("rows.jsonl",
              json_object({{"test", json(std::string(info->test_suite_name()) + '.' + info->name())},
                           {"name", json(r.name)},
                           {"what", json(r.what)},
                           {"parameters", json(r.parameters)},
                           {"reference", json(r.reference)},
                           {"unit", json(r.unit)},
                           {"source", json(r.source)},
                           {"ours", json(r.ours)},
                           {"error", json(r.error)},
                           {"allowed", json(r.allowed)},
                           {"absolute", r.absolute ? "true" : "false"},
                           {"known_fault", json(r.known_fault)}}));
}

// Observed order of convergence: the slope of log error over log size, least squares over all resolutions.
template <std::size_t n>
double observed_order(const std::array<double, n>& size, const std::array<double, n>& error) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = std::log(size[k]), y = std::log(error[k]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (double(n) * sxy - sx * sy) / (double(n) * sxx - sx * sx);
}

// Asserts the order: `expected` by theory, at most `shortfall` below. More than expected is no error.
inline void report_order(const std::string& name, const std::string& what, const std::string& parameters,
                         const std::array<double, 3>& size, const std::array<double, 3>& error,
                         double expected, double shortfall, const std::string& source,
                         const std::string& known_fault = "") {
  const double order = observed_order(size, error);
  char errors[128];
  std::snprintf(errors, sizeof errors, "; errors %.2g, %.2g, %.2g", error[0], error[1], error[2]);
  report({name, "order of convergence, " + what, parameters + errors, expected, "", source, order,
          order >= expected ? 0 : expected - order, shortfall, true, known_fault}); // of a NaN: a NaN
}

struct Series {
  std::string label;
  std::vector<double> x, y;
  bool reference = false; // drawn black
  bool points = false;    // markers instead of a line
};

struct Curve {
  std::string file, title; // docs/reports/verification/<file>.png
  std::string x_label, y_label;
  std::vector<Series> series;
  bool log_log = false;
};

inline void write_curve(const Curve& c) {
  std::vector<std::string> series;
  for (const Series& s : c.series)
    series.push_back(json_object({{"label", json(s.label)},
                                  {"x", json(s.x)},
                                  {"y", json(s.y)},
                                  {"reference", s.reference ? "true" : "false"},
                                  {"points", s.points ? "true" : "false"}}));
  append_line("curves.jsonl", json_object({{"file", json(c.file)},
                                           {"title", json(c.title)},
                                           {"x_label", json(c.x_label)},
                                           {"y_label", json(c.y_label)},
                                           {"log_log", c.log_log ? "true" : "false"},
                                           {"series", json_array(series)}}));
}

} // namespace swarf::test
