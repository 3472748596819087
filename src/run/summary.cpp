#include "src/run/summary.hpp"
#include "src/files/say.hpp"
#include "src/scene/hex_conversion.hpp"
#include "src/scene/parts.hpp"
#include "swarf/kernels.hpp"
#include "swarf/material/thermal.hpp"
#include "swarf/region/retire.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>
#include <sys/resource.h>

namespace swarf {
namespace {

double mean_of_last_half(const HistoryTable& table, const std::string& column) {
  const std::vector<double>& values = table.at(column);
  const std::vector<double>& time = table.at("time");
  double sum = 0;
  long count = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (time[k] >= 0.5 * time.back()) sum += values[k], ++count;
  return count > 0 ? sum / double(count) : 0;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

double last(const std::vector<double>& values) { return values.empty() ? 0 : values.back(); }

rusage usage_so_far() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage;
}

double seconds_of(const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); }

// Of all threads, with the start: unlike the wall clock it does not count the waiting for other programs.
double cpu_seconds() {
  const rusage usage = usage_so_far();
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

double memory_bytes() { return 1024.0 * double(usage_so_far().ru_maxrss); }

// Length along z and largest radius about z of each body: what a Taylor bar is measured by.
Json shapes_of(const Deck& deck, const Scene& scene) {
  std::vector<Triple> low(deck.bodies.size(), Triple{1e300, 1e300, 1e300}),
      high(deck.bodies.size(), {-1e300, -1e300, -1e300});
  std::vector<double> radius(deck.bodies.size(), 0);
  const auto grow = [&](int body, const Vector3& x, double margin) {
    const std::array<double, 3> at{x.x, x.y, x.z};
    for (int c = 0; c < 3; ++c) {
      low[body][c] = std::min(low[body][c], at[c] - margin);
      high[body][c] = std::max(high[body][c], at[c] + margin);
    }
    const Triple& centre = deck.bodies[body].origin;
    radius[body] = std::max(radius[body], std::hypot(at[0] - centre[0], at[1] - centre[1]) + margin);
  };
  const auto x = host_copy(scene.particles.position);
  const auto gap = host_copy(scene.particles.contact_gap);
  const auto body = host_copy(scene.particles.body);
  const auto bits = host_copy(scene.particles.constraints);
  for (int i : particle_rows(scene.particles))
    if (!(bits(i) & retired_bit)) grow(body(i), load_vector(x, i), gap(i));
  const auto node = host_copy(scene.hexes.position);
  const auto corner = host_copy(scene.hexes.connectivity);
  const auto hex_body = host_copy(scene.hex_body);
  const auto left = host_copy(scene.hexes.points.mass); // none where particles have taken over
  for (int e = 0; e < scene.hexes.points.count; ++e)
    for (int a = 0; left(e) > 0 && a < 8; ++a) grow(hex_body(e), load_vector(node, corner(e, a)), 0);
  Json all;
  for (std::size_t b = 0; b < deck.bodies.size(); ++b) {
    Json one;
    one.set("length_x", high[b][0] - low[b][0]).set("length_y", high[b][1] - low[b][1]);
    one.set("length_z", high[b][2] - low[b][2]).set("largest_radius", radius[b]);
    all.set(deck.bodies[b].name, one);
  }
  return all;
}

Json forces_of(const ResultsFolder& folder) {
  const HistoryTable raw = read_history(folder.history()), filtered = read_history(folder.filtered_history());
  Json forces;
  forces.set("mean_force_x", mean_of_last_half(raw, "force_x"));
  forces.set("mean_force_y", mean_of_last_half(raw, "force_y"));
  forces.set("mean_force_z", mean_of_last_half(raw, "force_z"));
  forces.set("filtered_planar_peak", largest(filtered.at("force_planar")));
  forces.set("filtered_planar_mean", mean_of_last_half(filtered, "force_planar"));
  return forces;
}

Json energies_of(const ResultsFolder& folder) {
  const HistoryTable raw = read_history(folder.history());
  Json energies;
  double total = 0;
  for (const char* name : {"kinetic_energy", "elastic_energy", "plastic_work", "friction_work",
                           "viscous_work", "hourglass_work", "contact_energy", "tie_work", "shifting_work"}) {
    energies.set(name, last(raw.at(name)));
    total += std::abs(last(raw.at(name)));
  }
  energies.set("external_work", last(raw.at("external_work")))
      .set("energy_residual", last(raw.at("energy_residual")));
  // A body that is only slowed down does work on nothing: its initial energy is then the measure.
  const double initial = raw.rows() > 0 ? raw.at("kinetic_energy").front() : 0;
  const double measure = std::max(std::abs(last(raw.at("external_work"))), initial);
  double worst = 0;
  for (const double r : raw.at("energy_residual")) worst = std::max(worst, std::abs(r));
  energies.set("worst_residual_over_external", measure > 0 ? worst / measure : 0);
  energies.set("viscous_share", total > 0 ? last(raw.at("viscous_work")) / total : 0);
  return energies;
}

// What has left, and what it took along; inertia is that of the scaled mass.
Json retired_of(const Deck& deck, const Particles& p) {
  const auto mass = host_copy(p.points.mass), temperature = host_copy(p.points.temperature);
  const auto internal = host_copy(p.points.internal_work), plastic = host_copy(p.points.plastic_work);
  const auto material = host_copy(p.points.material), body = host_copy(p.body);
  const auto bits = host_copy(p.constraints);
  const auto velocity = host_copy(p.velocity);
  std::vector<Material> materials;
  for (const MaterialDeck& m : deck.materials) materials.push_back(make_material(m));
  double weight = 0, kinetic = 0, elastic = 0, dissipated = 0, heat = 0;
  Triple momentum{0, 0, 0};
  for (int i = 0; i < p.stored; ++i) {
    if (!(bits(i) & retired_bit)) continue;
    const double m = double(mass(i)), inertia = deck.run.mass_factor * m;
    for (int c = 0; c < 3; ++c) {
      momentum[std::size_t(c)] += inertia * double(velocity(i, c));
      kinetic += 0.5 * inertia * double(velocity(i, c)) * double(velocity(i, c));
    }
    weight += m, elastic += double(internal(i)) - double(plastic(i)), dissipated += double(plastic(i));
    heat += double(heat_between(materials[std::size_t(material(i))], mass(i),
                                Real(deck.bodies[std::size_t(body(i))].temperature), temperature(i)));
  }
  const RetiredCount count = count_retired(p);
  Json book;
  book.set("particles", count.all).set("met_since", count.met).set("mass", weight);
  book.set("momentum_x", momentum[0]).set("momentum_y", momentum[1]).set("momentum_z", momentum[2]);
  book.set("kinetic_energy", kinetic).set("elastic_energy", elastic);
  return book.set("plastic_work", dissipated).set("heat", heat);
}

// Most worn patch of the tool: depth, m, and where in its frame.
Json wear_of(const Tool& tool) {
  const auto shown = host_copy(show_tool_surface(tool, 0));
  const auto corner = host_copy(tool.surface.corner);
  int worst = 0;
  for (int p = 1; p < tool.surface.patches; ++p)
    if (shown(p, shown_wear) > shown(worst, shown_wear)) worst = p;
  Json wear;
  wear.set("largest_depth", double(shown(worst, shown_wear)));
  for (int d = 0; d < 3; ++d)
    wear.set(fmt::format("at_{}", "xyz"[d]),
             double(corner(worst, 0, d) + corner(worst, 1, d) + corner(worst, 2, d)) / 3);
  return wear;
}

} // namespace

void write_summary(const RunFacts& run, double seconds) {
  const auto& [folder, deck, s, recorder, ending] = run;
  const RunWatch& watch = recorder.watch;
  const Scene& scene = s.scene();
  Json cost;
  cost.set("wall_seconds", seconds).set("cpu_seconds", cpu_seconds());
  cost.set("threads", ExecSpace().concurrency()).set("steps", s.steps_this_run());
  cost.set("particle_steps_per_second", s.particle_steps() / seconds);
  cost.set("peak_memory_bytes", memory_bytes());
  for (const auto& [phase, time] : s.timer.totals()) cost.set("seconds: " + phase, time);
  const HistoryTable raw = read_history(folder.history());
  Json summary;
  summary.set("title", deck.title).set("ended", ending.how).set("why", ending.why);
  summary.set("warnings", fmt::format("{}", fmt::join(watch.warnings(), "; "))).set("version", SWARF_VERSION);
  summary.set("commit", SWARF_COMMIT); // "" outside of git
  if (deck.picked) {
    Json pick;
    pick.set("asked_percent", deck.picked->asked).set("why", deck.picked->why);
    summary.set("accuracy", pick.set("set", fmt::format("{}", fmt::join(deck.picked->changes, "; "))));
  }
  summary.set("particles", scene.particles.whole).set("tied_particles", scene.tie.count);
  summary.set("hexes", scene.hexes.points.count).set("nodes", scene.hexes.nodes);
  if (scene.conversion) summary.set("converted_hexes", scene.layout ? scene.layout->converted() : 0);
  summary.set("steps", s.step_count()).set("time", s.time()).set("dt", s.dt());
  summary.set("list_rebuilds", s.rebuilds()).set("leaked_particles", recorder.most_leaked().particles);
  summary.set("leaked_nodes", recorder.most_leaked().nodes);
  summary.set("hottest", largest(raw.at("max_temperature")));
  summary.set("largest_plastic_strain", largest(raw.at("max_plastic_strain")));
  if (deck.retire.distance) summary.set("retired", retired_of(deck, scene.particles));
  if (deck.tool) summary.set("contact", watch.touched());
  if (deck.tool && deck.tool->wear_A) summary.set("wear", wear_of(scene.tool));
  summary.set("forces", forces_of(folder)).set("energies", energies_of(folder));
  summary.set("shapes", shapes_of(deck, scene)).set("cost", cost);
  write_file(folder.summary(), summary.text() + "\n");
}

RetiredCount count_retired(const Particles& p) {
  RetiredCount count;
  const auto bits = host_copy(p.constraints);
  for (int i = 0; i < p.stored; ++i)
    count.all += bits(i) & retired_bit ? 1 : 0, count.met += bits(i) & met_bit ? 1 : 0;
  return count;
}

void report(const Simulation& s, double seconds) {
  say("{} steps in {:.1f} s, {} list rebuilds\n", s.step_count(), seconds, s.rebuilds());
  for (const auto& [phase, time] : s.timer.totals())
    say("  {:<18} {:8.2f} s {:5.1f} %\n", phase, time, 100 * time / seconds);
}

} // namespace swarf
