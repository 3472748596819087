// The wedge of the shipped deck for orthogonal cutting, pressed 0.1 spacings into a face of the cube. Counted
// for a point away from it, as most are: place in the tool's frame and cell of its grid 15. Those near it
// search its facets. Reals: position 3, area, friction_force 3 in; contact_force 3, friction_force 3,
// contact_energy out.
#include "bench/support/particle_cube.hpp"
#include "src/simulation/simulation.hpp"
#include "src/tool/geometry.hpp"
#include <filesystem>

namespace swarf::bench {
namespace {

void bench_tool_contact(benchmark::State& state) {
  const ParticleCube& c = particle_cube(state.range(0));
  const Particles& p = c.particles;
  const std::string file = SWARF_SOURCE_DIR "/inputs/orthogonal_cutting.toml";
  ToolDeck deck = *read_deck(file).tool;
  const double edge = std::cbrt(c.count()) * double(spacing);
  deck.rake = 0, deck.height = 2 * edge, deck.width = 2 * edge;
  const Tool tool = build_tool(make_tool_surface(deck, ""), deck, 4 * double(spacing));
  ToolPose pose;
  pose.position = {Real(0.1) * spacing, Real(-0.5 * edge), Real(0.5 * edge)};
  ContactLaw law;
  law.friction = Real(0.2), law.stiffness = Real(0.1), law.heat_to_workpiece = Real(0.5);
  const ContactPoints points = contact_points_of(p);
  for (auto _ : state) tool_contact(points, tool, pose, law, c.materials, Real(1), time_step);
  report(state, c.count(), {15, 14.0 * sizeof(Real)});
  state.counters["touching"] = count_points_inside(points, tool, pose, -Real(0.5) * spacing);
}
BENCHMARK(bench_tool_contact)->Name("tool_contact")->Apply(all_sizes);

} // namespace
} // namespace swarf::bench
