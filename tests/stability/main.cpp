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

namespace swarf::stability {

const std::vector<Test>& tests() {
  static const std::vector<Test> all = {
      {"rings", "tension: ring", "a rubber ring meets a wall at 0.059 c0, 4 cells thick", Kind::elastic,
       false, collide_ring},
      {"strip", "tension: strip", "an elastic strip pulled by 20 %, 24 x 8 cells", Kind::elastic, false,
       pull_strip},
      {"plate", "bending: plate", "a clamped plate, 40 x 4 cells, its tip started at 0.05 c0, one period",
       Kind::elastic, false, bend_plate},
      {"zero_energy", "zero-energy mode",
       "a checkerboard in an endless block, without shock viscosity: of velocities, 1e-3 c; and driven to a "
       "twentieth of the spacing and let go",
       Kind::elastic, false, shake_block},
      {"rotation", "large rotation", "a free plate, 16 x 16 cells, spins by 360 deg", Kind::elastic, false,
       spin_plate},
      {"disorder", "disorder", "a plate of 12 x 12 points a fifth of a spacing off their lattice vibrates",
       Kind::elastic, false, disturb_lattice},
      {"contact", "contact, fast",
       "a block meets a wall obliquely at 60 m/s, ten times the verification's speed, friction 0.5",
       Kind::elastic, false, hit_wall},
      {"lone", "lone particle", "one particle leaves the others at half the speed of waves", Kind::elastic,
       true, lose_particle},
      {"scale", "scale", "a block meets a wall, plastic, with friction; cells of 1 mm, 1 um, 60 nm, 1 nm",
       Kind::elastic, false, scale_scene},
      {"courant", "time step", "a cube shaken at random, Courant number 0.3 to 1.2", Kind::elastic, false,
       raise_courant},
      {"mass", "mass factor", "a block of the cut squeezed by 10 % at 0.5 m/s, mass factor 1 to 1e6",
       Kind::plastic, false, raise_mass},
      {"viscosity", "viscosity",
       "the same under mass factor 1e4, linear viscosity 0 to 2, the quadratic one twice that; and the time "
       "step at 2",
       Kind::plastic, false, raise_viscosity},
      {"cut", "large shear: cut", "orthogonal cutting, 30 m/min, 40 um deep, cells of 10 um, 150 um of cut",
       Kind::cut, false, stability::cut},
      {"cut_fast", "cut, ten times as fast", "the same at 300 m/min, under the same mass factor", Kind::cut,
       false, cut_fast},
  };
  return all;
}

} // namespace swarf::stability

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
    columns.push_back(
        json_object({{"name", json(t.name)}, {"title", json(t.title)}, {"text", json(t.text)}}));
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
