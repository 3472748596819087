// The stability matrix: runs one cell and prints one line of JSON, or lists rows, columns and limits.
//   stability --formulation NAME --test NAME [--expect stable|degraded|failed]
//   stability --list
#include "tests/stability/cell.hpp"
#include "tests/verification/json.hpp"
#include <CLI/CLI.hpp>
#include <Kokkos_Core.hpp>
#include <chrono>
#include <tuple>

using namespace swarf;
using namespace swarf::stability;
using test::json, test::json_array, test::json_object;

namespace {

std::string boolean(bool b) { return b ? "true" : "false"; }

void list() {
  std::vector<std::string> rows, columns, measures;
  for (const Formulation& f : formulations()) {
    std::vector<std::string> meets;
    for (const Test& t : tests())
      if (applies(f, t)) meets.push_back(json(t.name));
    rows.push_back(json_object({{"name", json(f.name)},
                                {"text", json(f.text)},
                                {"fill", json(f.fill)},
                                {"tests", json_array(meets)}}));
  }
  for (const Test& t : tests())
    columns.push_back(json_object(
        {{"name", json(t.name)}, {"title", json(t.title)}, {"text", json(t.text)}, {"why", json(t.why)}}));
  for (const Limit& l : limits())
    measures.push_back(json_object({{"name", json(l.measure)},
                                    {"shown", json(l.shown)},
                                    {"text", json(l.text)},
                                    {"stable", json(l.stable)},
                                    {"failed", json(l.failed)},
                                    {"more_is_better", boolean(l.more_is_better)},
                                    {"reason", json(l.reason)}}));
  std::printf("%s\n", json_object({{"formulations", json_array(rows)},
                                   {"tests", json_array(columns)},
                                   {"limits", json_array(measures)}})
                          .c_str());
}

template <class T>
const T& named(const std::vector<T>& all, const std::string& name) {
  for (const T& one : all)
    if (one.name == name) return one;
  throw std::runtime_error("there is no " + name + "; see --list");
}

int run(const Formulation& f, const Test& t, const std::string& expected) {
  if (!applies(f, t)) throw std::runtime_error(f.name + " does not take " + t.name);
  const auto begin = std::chrono::steady_clock::now();
  const Outcome o = t.run(f);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const Verdict verdict = judge(o);
  std::vector<std::pair<std::string, std::string>> measures;
  for (const auto& [name, value] : o.measures) measures.push_back({name, json(value)});
  std::printf("%s\n", json_object({{"formulation", json(f.name)},
                                   {"test", json(t.name)},
                                   {"class", json(verdict.name)},
                                   {"decisive", json(verdict.decisive ? verdict.decisive->measure : "")},
                                   {"fault", json(o.fault)},
                                   {"reached", json(o.when)},
                                   {"measures", json_object(measures)},
                                   {"steps", json(double(o.steps))},
                                   {"seconds", json(seconds)}})
                          .c_str());
  if (expected.empty() || expected == verdict.name) return 0;
  std::fprintf(stderr, "expected %s\n", expected.c_str());
  return 1;
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app("one cell of the stability matrix");
  std::string formulation, test, expected;
  bool lists = false;
  app.add_option("--formulation", formulation, "row");
  app.add_option("--test", test, "column");
  app.add_option("--expect", expected, "class that the cell must have")
      ->check(CLI::IsMember({"stable", "degraded", "failed"}));
  app.add_flag("--list", lists, "rows, columns and limits, as JSON");
  CLI11_PARSE(app, argc, argv);
  if (lists) return list(), 0;
  try {
    Kokkos::InitializationSettings settings;
    settings.set_disable_warnings(true);
    const Kokkos::ScopeGuard kokkos(settings);
    return run(named(formulations(), formulation), named(tests(), test), expected);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stability: %s\n", error.what());
    return 2;
  }
}
