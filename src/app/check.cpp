#include "src/app/check.hpp"
#include "src/accuracy/accuracy.hpp"
#include "src/check/cost.hpp"
#include "src/check/scene.hpp"
#include "src/geometry/shape.hpp"
#include "src/pictures/draw_scene.hpp"
#include "src/run/run.hpp"
#include "src/scene/hex_conversion.hpp"
#include "src/simulation/simulation.hpp"
#include "src/windows/windows.hpp"
#include <chrono>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <numbers>
#include <sys/resource.h>

namespace swarf {
namespace {

constexpr double most_cells_to_try = 6e5;
constexpr double round_off = 1 - 1e-9; // what is as large as asked must not be found too small

class Findings {
 public:
  template <class... T>
  void line(const char* name, fmt::format_string<T...> text, T&&... values) {
    fmt::print("  {:<34} {}\n", name, fmt::format(text, std::forward<T>(values)...));
  }
  void warn(const std::string& text) {
    fmt::print("  WARNING: {}\n", text);
    ++warnings;
  }
  int warnings = 0;
};

double mass_of(const Scene& scene) {
  const auto of_particles = host_copy(scene.particles.points.mass), of_nodes = host_copy(scene.hexes.mass);
  double sum = 0;
  for (int i : particle_rows(scene.particles)) sum += double(of_particles(i));
  for (int a = 0; a < scene.hexes.nodes; ++a) sum += double(of_nodes(a));
  return sum;
}

// Uncut chip: the feed per tooth of a mill; a wedge cuts what lies above its edge.
double uncut_chip(const Deck& deck, const Scene& scene) {
  if (deck.tool->kind == ToolKind::end_mill) return deck.tool->feed_per_tooth;
  const auto x = host_copy(scene.particles.position);
  const auto node = host_copy(scene.hexes.position);
  double top = -1e300;
  for (int i : particle_rows(scene.particles)) top = std::max(top, double(x(i, 1)) + 0.5 * scene.spacing);
  for (int a = 0; scene.conversion && a < scene.hexes.nodes; ++a) top = std::max(top, double(node(a, 1)));
  return top - deck.tool->position[1];
}

void check_cutting(const Deck& deck, const Scene& scene, Findings& found) {
  if (!deck.tool || (scene.particles.count == 0 && !scene.conversion)) return;
  const ToolDeck& tool = *deck.tool;
  const bool cuts = tool.kind == ToolKind::end_mill || tool.kind == ToolKind::wedge;
  if (!cuts) return;
  const double chip = uncut_chip(deck, scene) / scene.spacing, edge = tool.edge_radius / scene.spacing;
  found.line("particles per uncut chip", "{:.1f}", chip);
  if (chip <= 0)
    found.warn("the tool cuts nothing off: it goes above the particles");
  else if (chip < 4 * round_off && !deck.picked) // else the chart knows better
    found.warn(fmt::format("{:.2f} particles across the uncut chip: take body.spacing <= {:.4g} um for 4",
                           chip, 1e6 * uncut_chip(deck, scene) / 4));
  found.line("particles per edge radius", "{:.1f}", edge);
  if (tool.edge_radius > 0 && edge < 2 * round_off)
    found.warn(fmt::format("{:.1f} particles along the edge radius: the edge is not resolved", edge));
}

void check_inertia(const Deck& deck, Findings& found) {
  if (!deck.tool) return;
  const ToolDeck& tool = *deck.tool;
  const double speed = std::max(std::hypot(tool.velocity[0], tool.velocity[1], tool.velocity[2]),
                                tool.spindle_speed * tool.diameter / 2);
  if (speed == 0) return;
  for (const MaterialDeck& m : deck.materials) {
    if (m.law == Law::rigid) continue;
    const double E = m.youngs_modulus.greatest();
    const double K = E / 3 / (1 - 2 * m.poissons_ratio), G = E / 2 / (1 + m.poissons_ratio);
    const double c = std::sqrt((K + 4 * G / 3) / m.density / deck.run.mass_factor);
    found.line("mass-scaled wave speed / tool speed", "{:.0f} ({})", c / speed, m.name);
    if (c < 50 * speed * round_off)
      found.warn("inertia of the scaled mass will show in the force: lower run.mass_factor");
  }
}

// Frames and pictures that never come, or come so often that they fill the disk.
void check_output(const Deck& deck, double cells, Findings& found) {
  const OutputDeck& output = deck.output;
  const double end = end_time_of(deck), turn = 180 / std::numbers::pi;
  const double speed = deck.tool ? deck.tool->spindle_speed : 0;
  const double interval =
      output.frame_time.value_or(output.frame_immersion ? *output.frame_immersion / speed : end / 20);
  const std::string key = output.frame_immersion ? "frame_immersion" : "frame_time";
  if (interval > end * (1 + 1e-9))
    found.warn(
        fmt::format("output.{} is {:.3g} times the run: there is a frame of its start and of its end. Take "
                    "less for more",
                    key, interval / end));
  if (output.checkpoint_time && *output.checkpoint_time > end * (1 + 1e-9))
    found.warn(
        fmt::format("output.checkpoint_time is {:.3g} times the run: there is no checkpoint before its end",
                    *output.checkpoint_time / end));
  constexpr double bytes_per_cell = 130; // of a frame, of particles as of hexes
  const double frames = std::ceil(end / interval), bytes = frames * cells * bytes_per_cell;
  if (bytes > 1e11 || frames > 1e5)
    found.warn(fmt::format("output.{}: {:.3g} frames, {:.3g} GB on the disk. Take a longer one", key, frames,
                           1e-9 * bytes));
  for (const double time : output.picture_time)
    if (time > end * (1 + 1e-9))
      found.warn(fmt::format(
          "output.picture_time: {:.4g} s lies beyond the end of the run, {:.4g} s: the last frame "
          "is drawn for it",
          time, end));
  for (const double angle : output.picture_immersion)
    if (deck.tool &&
        (angle < deck.tool->start_angle - 1e-9 || angle > deck.tool->start_angle + speed * end + 1e-9))
      found.warn(fmt::format(
          "output.picture_immersion: {:.4g} deg lies outside of the run, {:.4g} to {:.4g} deg: its "
          "first or last frame is drawn for it",
          turn * angle, turn * deck.tool->start_angle, turn * (deck.tool->start_angle + speed * end)));
}

// The chart was measured in one scene; where this one is another, its errors are a guess.
void compare_scene(const Deck& deck, const AccuracyPlan& plan, Findings& found) {
  const AccuracyChart& chart = *plan.chart;
  const ChartPoint& point = *plan.choices[plan.picked].point;
  const double edge = deck.tool->edge_radius / plan.cut.chip, rake = deck.tool->rake * 180 / std::numbers::pi;
  found.line("edge radius / uncut chip, rake", "{:.3g}, {:.3g} deg (chart: {:.3g}, {:.3g} deg)", edge, rake,
             chart.edge_over_chip, chart.rake);
  const double length = plan.cut.speed * end_time_of(deck),
               needed = (point.run_in + point.measured) * plan.cut.chip;
  found.line("cut", "{:.3g} um (chart: {:.3g} um)", 1e6 * length, 1e6 * needed);
  if (length < needed * (1 - 1e-9))
    found.warn("the cut is shorter than where the chart's mean force was taken: run for longer");
  const double slant =
      std::max(deck.tool->helix, std::abs(deck.tool->inclination)); // the chart's are straight
  if (slant > 0 || edge > 2 * chart.edge_over_chip || edge < chart.edge_over_chip / 2 ||
      std::abs(rake - chart.rake) > 10)
    found.warn(fmt::format("the edge is not that of {}: the chart's errors are a guess here", chart.deck));
}

// The deck with what run.accuracy chooses; says what there is to choose from if nothing is good enough.
Deck plan_deck(const std::string& file, std::optional<AccuracyPlan>& plan) {
  const Deck deck = read_deck(file);
  fmt::print("{}\n", file);
  if (!deck.run.accuracy) return deck;
  plan = plan_accuracy(deck);
  if (plan->picked < 0)
    fmt::print("{}  core-seconds are those of the machine that measured\n", show_choices(*plan, 1));
  std::fflush(stdout);
  return planned_deck(deck, *plan);
}

// Before anything is built: what would take minutes is worked out from a small block of each body.
bool is_large(const Deck& deck, Findings& found) {
  double cells = 0;
  for (const BodyDeck& body : deck.bodies) cells += count_cells(deck, body);
  if (cells <= most_cells_to_try) return false;
  check_memory(deck);
  found.line("cells of all bodies", "{:.4g}", cells);
  const SceneReport about = estimate_large(deck);
  for (const auto& [name, value] : about.lines) found.line(name.c_str(), "{}", value);
  for (const std::string& warning : about.warnings) found.warn(warning);
  check_output(deck, cells, found);
  check_inertia(deck, found);
  found.warn(
      fmt::format("{:.3g} cells: too many to build and look at here. What is said above is that of small "
                  "blocks of the same cells; swarf run --stop-after 10 builds and tries all",
                  cells));
  return true;
}

// Ten steps, or as many as a few seconds take.
int try_steps(Simulation& simulation, double end) {
  const auto begin = std::chrono::steady_clock::now();
  for (int k = 1;; ++k) {
    simulation.cut_step(end);
    simulation.step();
    if (simulation.steps_to_check() <= 0) simulation.check();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    if (k == 10 || taken.count() > 5 || simulation.time() >= end) return k;
  }
}

void check_steps(const Deck& deck, double steps, double seconds, Findings& found) {
  if (steps < 20) {
    const MaterialDeck& m = deck.materials.front();
    found.warn(
        fmt::format("only {:.0f} step(s) to the end: look at run.end_time, run.mass_factor, and at "
                    "material.{}.youngs_modulus = {:.3g} Pa and density = {:.3g} kg/m3, which give the step",
                    steps, m.name, m.youngs_modulus.greatest(), m.density));
  }
  if (seconds > 3.2e7)
    found.warn(fmt::format(
        "predicted to take {:.2g} years: end earlier (run.end_time), or take larger cells or a larger "
        "run.mass_factor",
        seconds / 3.156e7));
}

double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; } // of all threads

} // namespace

int check_deck(const std::string& file, const std::string& picture) {
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  std::optional<AccuracyPlan> plan;
  const Deck deck = plan_deck(file, plan);
  Findings found;
  if (is_large(deck, found)) return found.warnings;
  Simulation simulation(deck);
  const Scene& scene = simulation.scene();
  simulation.take_tool_temperature();
  simulation.start();
  refuse_endless(deck, simulation);
  const double start_up = seconds();
  found.line("particles", "{} (+ {} tied, {} ghosts)", scene.particles.whole, scene.tie.count,
             simulation.neighbors().ghosts);
  if (deck.sleep.distance)
    found.line("active at the start", "{} (+ {} tied)", scene.particles.count, scene.particles.tied);
  found.line("hexes", "{} ({} nodes)", scene.hexes.points.count, scene.hexes.nodes);
  if (scene.tool.heat.cells > 0)
    found.line("cells of heat in the tool", "{}, to {:.3g} um from where the bodies come",
               scene.tool.heat.cells, 1e6 * scene.heat_reach);
  found.line("mass", "{:.6g} kg", mass_of(scene));
  found.line("time step", "{:.4g} s, limited by {}", simulation.dt(), simulation.limiter());
  if (scene.conversion)
    found.line("hexes that may become particles", "{}, {} already have; the time below is that of now",
               scene.conversion->count(), scene.layout ? scene.layout->converted() : 0);
  const double steps = count_steps(deck, simulation);
  found.line("steps", "{:.4g} for {:.4g} s", steps, end_time_of(deck));
  if (const double heat = count_heat_steps(deck, simulation); heat > 0)
    found.line("steps of conduction in a step", "{:.0f}", heat);
  const SceneReport places = look_at_scene(deck, scene);
  for (const auto& [name, value] : places.lines) found.line(name.c_str(), "{}", value);
  if (!picture.empty()) {
    draw_scene(deck, scene, picture);
    found.line("picture of the scene", "{}", picture);
  }
  std::fflush(stdout);
  const double trial_begin = seconds(), cpu_begin = cpu_seconds();
  const int trial = try_steps(simulation, end_time_of(deck));
  const double per_step = (seconds() - trial_begin) / trial;
  const double core_seconds = steps * (cpu_seconds() - cpu_begin) / trial;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  found.line("time per step", "{:.4g} s on {} threads, start-up {:.2f} s", per_step,
             ExecSpace().concurrency(), start_up);
  found.line("predicted run time", "{:.3g} s ({:.3g} h)", steps * per_step, steps * per_step / 3600);
  if (deck.windows) {
    const double effort = effort_in_windows(deck);
    found.line("the same in windows", "{} windows, {}{:.3g} s ({:.1f} %)",
               cut_windows(deck, *deck.windows).size(), deck.sleep.distance ? "at least " : "",
               effort * steps * per_step, 100 * effort);
  }
  found.line("memory", "{:.0f} MiB of {:.1f} GiB", double(usage.ru_maxrss) / 1024,
             machine_memory() / (1 << 30));
  check_steps(deck, steps, steps * per_step, found);
  for (const std::string& warning : places.warnings) found.warn(warning);
  check_output(deck, double(scene.particles.whole) + scene.hexes.points.count, found);
  check_cutting(deck, scene, found);
  check_inertia(deck, found);
  if (plan) {
    compare_scene(deck, *plan, found);
    const double share = deck.windows ? effort_in_windows(deck) : 1;
    fmt::print("{}{}", show_choices(*plan, share * core_seconds / plan->choices[plan->picked].core_seconds),
               show_pick(deck));
  }
  fmt::print("{}\n", found.warnings == 0 ? "fit to run" : fmt::format("{} warning(s)", found.warnings));
  return found.warnings;
}

} // namespace swarf
