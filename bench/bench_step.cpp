// The whole step as a run takes it, with its checks, samples and neighbour lists, and where its time goes.
// The settings are those of the shipped deck for orthogonal cutting; only the bodies change with the size.
// They move and the tool rests, so that the lists age as fast as in the chip from the first step on. One
// iteration is the steps from one rebuild of the lists to the next. Items are particles, tied ones among
// them, and hexes. Bytes are those of the Views when they are most, and of the process: a process that has
// run another row before holds the most of both.
#include "bench/support/bench.hpp"
#include "bench/support/watch.hpp"
#include "src/simulation/simulation.hpp"

namespace swarf::bench {
namespace {

// As close to n cells as whole cells allow, in the proportions of the deck's bodies.
void set_cells(BodyDeck& body, double n) {
  const double cell = std::cbrt(body.size[0] * body.size[1] * body.size[2] / n);
  body.spacing.reset(), body.cells = {1, 1, 1};
  for (int d = 0; d < 3; ++d) (*body.cells)[d] = std::max(4, int(std::lround(body.size[d] / cell)));
}

Deck shipped() {
  Deck deck = read_deck(SWARF_SOURCE_DIR "/inputs/orthogonal_cutting.toml");
  const double speed = deck.tool->velocity[0];
  deck.tool->velocity[0] = 0;
  for (BodyDeck& body : deck.bodies) {
    body.velocity[0] = -speed;
    std::erase_if(body.faces, [](const FaceDeck& face) { return face.face == "x_max"; });
    for (FaceDeck& face : body.faces)
      if (face.kind == FaceKind::fixed) face = {face.face, FaceKind::velocity, body.velocity};
  }
  return deck;
}

// The chip's layer alone, thick enough along the slice for its periodic faces, and held below.
Deck particle_scene(double n) {
  Deck deck = shipped();
  deck.bodies.resize(1);
  BodyDeck& body = deck.bodies[0];
  body.tie.clear();
  body.faces.push_back({"y_min", FaceKind::velocity, body.velocity});
  set_cells(body, n);
  return deck;
}

// The bulk alone, moved up to where the tool cuts.
Deck hex_scene(double n) {
  Deck deck = shipped();
  deck.bodies.erase(deck.bodies.begin());
  BodyDeck& body = deck.bodies[0];
  body.origin[1] = 0.04e-3 - body.size[1];
  set_cells(body, n);
  return deck;
}

// The shipped scene: half of the cells are particles, half are hexes.
Deck hybrid_scene(double n) {
  Deck deck = shipped();
  set_cells(deck.bodies[0], n / 2), set_cells(deck.bodies[1], n / 2);
  return deck;
}

// No hourglass stiffness, whatever the deck has.
Deck plain_scene(double n) {
  Deck deck = particle_scene(n);
  deck.particles.hourglass_stiffness = 0;
  return deck;
}

void advance(Simulation& simulation) {
  simulation.step();
  if (simulation.steps_to_check() > 0) return;
  simulation.check();
  benchmark::DoNotOptimize(simulation.take_sample());
}

// To the next rebuild; hexes alone have no lists.
void advance_one_cycle(Simulation& simulation) {
  const long rebuilds = simulation.rebuilds();
  for (int k = 0; k < 200 && simulation.rebuilds() == rebuilds; ++k) {
    advance(simulation);
    if (simulation.scene().particles.count == 0 && k == 20) return;
  }
}

void report_phases(benchmark::State& state, const Simulation& simulation, const PhaseTimer& before,
                   long steps) {
  for (const auto& [name, seconds] : simulation.timer.totals()) {
    double spent = seconds;
    for (const auto& [old, earlier] : before.totals())
      if (old == name) spent -= earlier;
    state.counters["phase: " + name] = spent / double(steps);
  }
}

// Launches a step, of what some steps leave out.
void report_watch(benchmark::State& state, const Watch& watch, long steps) {
  for (const char* label :
       {"diffuse_pressure", "conduct_heat", "find_neighbors", "find_shifts", "transport_fields"}) {
    const auto found = watch.launches.find(label);
    if (found != watch.launches.end())
      state.counters["calls: " + found->first] = double(found->second) / double(steps);
  }
  for (const auto& [label, bytes] : watch.at_most)
    if (bytes > 0) state.counters["bytes: " + label] = double(bytes);
  state.counters["most_resident"] = most_resident(), state.counters["resident"] = resident();
}

void bench_step(benchmark::State& state, Deck (*scene)(double)) {
  Watch& watch = Watch::instance();
  watch.begin();
  Simulation simulation(scene(double(state.range(0))));
  simulation.start();
  advance_one_cycle(simulation);
  const Particles& particles = simulation.scene().particles;
  const int hexes = simulation.scene().hexes.points.count;
  const double items = double(particles.count) + particles.tied + hexes;
  const PhaseTimer before = simulation.timer;
  const long first = simulation.step_count();
  watch.restart();
  for (auto _ : state) advance_one_cycle(simulation);
  const long steps = simulation.step_count() - first;
  state.SetItemsProcessed(int64_t(double(steps) * items));
  state.counters["items"] = items, state.counters["steps"] = double(steps) / double(state.iterations());
  state.counters["particles"] = particles.count, state.counters["tied"] = particles.tied;
  state.counters["rows"] = double(particles.position.extent(0)); // with those of ghosts
  state.counters["ghosts"] = simulation.neighbors().ghosts, state.counters["hexes"] = hexes;
  report_phases(state, simulation, before, steps);
  report_watch(state, watch, steps);
}

void step_sizes(benchmark::internal::Benchmark* b) {
  for (const int64_t n : sizes()) b->Arg(n);
  b->UseRealTime()->Unit(benchmark::kMillisecond)->Iterations(1);
}
BENCHMARK_CAPTURE(bench_step, particles, particle_scene)->Name("step, particles")->Apply(step_sizes);
BENCHMARK_CAPTURE(bench_step, plain, plain_scene)->Name("step, particles, plain sums")->Apply(step_sizes);
BENCHMARK_CAPTURE(bench_step, hexes, hex_scene)->Name("step, hexes")->Apply(step_sizes);
BENCHMARK_CAPTURE(bench_step, hybrid, hybrid_scene)->Name("step, hybrid")->Apply(step_sizes);

} // namespace
} // namespace swarf::bench
