// What can be known of a scene without building it.
#include "src/check/cost.hpp"
#include "src/check/scene.hpp"
#include "src/geometry/memory.hpp"
#include "src/geometry/shape.hpp"
#include "src/tool/geometry.hpp"
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace swarf {
namespace {

constexpr int probe_cells = 14; // along each edge: so few that ten steps take a part of a second

// A block of the body's cells, alone, with the deck's methods.
Deck probe_of(const Deck& deck, const BodyDeck& body, double cell) {
  Deck probe = deck;
  BodyDeck block(BodyShape::block, body.fill);
  block.name = "probe", block.material = body.material;
  block.size = {probe_cells * cell, probe_cells * cell, probe_cells * cell};
  block.cells = {probe_cells, probe_cells, probe_cells};
  block.temperature = body.temperature, block.line = body.line;
  probe.bodies = {block};
  probe.run.end_time = end_time_of(deck), probe.run.end_immersion.reset();
  probe.tool.reset(), probe.windows.reset();
  probe.sleep.distance.reset(), probe.retire.distance.reset();
  return probe;
}

struct Probe {
  double step = 0, heat_steps = 0, seconds_per_cell = 0; // of one step
};

Probe try_block(const Deck& deck) {
  Simulation simulation(deck);
  simulation.start();
  refuse_endless(deck, simulation);
  Probe probe{simulation.dt(), count_heat_steps(deck, simulation), 0};
  const auto begin = std::chrono::steady_clock::now();
  int steps = 0;
  double taken = 0;
  do {
    simulation.step();
    if (simulation.steps_to_check() <= 0) simulation.check();
    taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  } while (++steps < 10 && taken < 1);
  probe.seconds_per_cell = taken / steps / std::pow(probe_cells, 3);
  return probe;
}

} // namespace

SceneReport estimate_large(const Deck& deck) {
  SceneReport report;
  const auto line = [&](const std::string& name, const std::string& value) {
    report.lines.emplace_back(name, value);
  };
  double step = std::numeric_limits<double>::infinity(), seconds = 0, heat = 0;
  Box bodies;
  for (const BodyDeck& body : deck.bodies) {
    const Shape shape = make_shape(deck, body);
    const double count = count_cells(deck, body);
    const Probe probe = try_block(probe_of(deck, body, std::cbrt(shape.volume() / count)));
    step = std::min(step, probe.step), heat = std::max(heat, probe.heat_steps);
    seconds += count * probe.seconds_per_cell;
    Box box;
    for (const Triple& corner : find_box(deck, body)) box.grow(corner);
    bodies.add(box);
    line(fmt::format("box of \"{}\"", body.name),
         describe_box(box) + fmt::format(", {:.4g} {}", count, word_of(body.fill)));
  }
  const double end = end_time_of(deck), steps = std::ceil(end / step);
  line("time step", fmt::format("about {:.3g} s", step));
  line("steps", fmt::format("about {:.3g} for {:.4g} s", steps, end));
  if (heat > 0) line("steps of conduction in a step", fmt::format("about {:.0f}", heat));
  line("predicted run time",
       fmt::format("about {:.3g} s ({:.3g} h){}", steps * seconds, steps * seconds / 3600,
                   deck.sleep.distance ? ", if nothing were frozen" : ""));
  double cells = 0;
  for (const BodyDeck& body : deck.bodies) cells += count_cells(deck, body);
  line("memory", fmt::format("about {:.3g} of {:.1f} GiB", cells * bytes_per_cell / (1 << 30),
                             machine_memory() / (1 << 30)));
  if (!deck.tool) return report;
  const FacetSurface surface = make_tool_surface(*deck.tool, "");
  Scene scene;
  for (const auto& f : surface.facets)
    scene.tool_facets.push_back({surface.vertices[std::size_t(f[0])], surface.vertices[std::size_t(f[1])],
                                 surface.vertices[std::size_t(f[2])]});
  line("box of the tool", describe_box(box_of_tool(deck, scene, 0)));
  line("box of all its way", describe_box(way_of_tool(deck, scene)));
  if (!way_of_tool(deck, scene).meets(bodies))
    report.warnings.push_back(
        fmt::format("tool and bodies never meet where the bodies are now: the tool's way lies in {}. Look at "
                    "tool.position, velocity or start_angle, and at the end of the run",
                    describe_box(way_of_tool(deck, scene))));
  return report;
}

} // namespace swarf
