#include "tests/stability/watch.hpp"
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace swarf::stability {

Lattice::Lattice(const std::vector<PointState>& at, const std::function<LatticeIndex(const Triple&)>& index,
                 int turn) {
  std::map<LatticeIndex, std::size_t> place;
  for (std::size_t i = 0; i < at.size(); ++i) place[index(at[i].x)] = i;
  for (const auto& [middle, unused] : place)
    for (int d = 0; d < 2; ++d) {
      std::array<std::size_t, 5> line{};
      bool whole = true;
      for (int k = -2; k <= 2 && whole; ++k) {
        LatticeIndex next = middle;
        next[std::size_t(d)] += k;
        if (d == 0 && turn > 0) next[0] = (next[0] % turn + turn) % turn;
        const auto found = place.find(next);
        whole = found != place.end();
        if (whole) line[std::size_t(k + 2)] = found->second;
      }
      if (whole) lines[d].push_back(line);
    }
}

double Lattice::sawtooth(const std::vector<Triple>& field) const {
  double most = 0;
  for (const auto& all : lines) {
    double sum = 0;
    for (const auto& [a, b, c, d, e] : all)
      for (std::size_t k = 0; k < 2; ++k)
        sum += std::pow(
            (field[a][k] - 4 * field[b][k] + 6 * field[c][k] - 4 * field[d][k] + field[e][k]) / 16, 2);
    if (!all.empty()) most = std::max(most, std::sqrt(sum / (2.0 * double(all.size()))));
  }
  return most;
}

Triple least_corner(const std::vector<PointState>& at) {
  Triple least = at[0].x;
  for (const PointState& p : at)
    for (std::size_t d = 0; d < 3; ++d) least[d] = std::min(least[d], p.x[d]);
  return least;
}

std::function<LatticeIndex(const Triple&)> block_index(const Triple& corner, double spacing) {
  return [=](const Triple& x) {
    LatticeIndex i{};
    for (std::size_t d = 0; d < 3; ++d) i[d] = int(std::lround((x[d] - corner[d]) / spacing));
    return i;
  };
}

Watch::Watch(Simulation& of, double a, Lattice l)
    : simulation(of), lattice(std::move(l)), start(snapshot(of.scene())), spacing(a) {
  simulation.start();
  energy = simulation.initial_kinetic();
}

void Watch::look_at_lattice() {
  const std::vector<PointState> now = snapshot(simulation.scene());
  std::vector<Triple> moved, velocity;
  double square = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    moved.push_back({now[i].x[0] - start[i].x[0], now[i].x[1] - start[i].x[1], 0});
    velocity.push_back(now[i].v);
    square += (now[i].v[0] * now[i].v[0] + now[i].v[1] * now[i].v[1]) / (2.0 * double(now.size()));
  }
  sawtooth = std::max(sawtooth, lattice.sawtooth(moved) / spacing);
  jitter = std::max(jitter, lattice.sawtooth(velocity));
  fastest = std::max(fastest, std::sqrt(square));
}

void Watch::run(double end, const std::function<void()>& look) {
  const double step_at_start = simulation.dt(), begin = simulation.time();
  const double most_steps = 10 * (end - begin) / step_at_start + 100;
  double next = 0;
  const auto at_check = [&] {
    const HistorySample s = simulation.take_sample();
    residual = std::max(residual, std::abs(s.residual));
    external = s.external;
    energy = std::max(energy, simulation.initial_kinetic() + std::abs(s.external));
    if (simulation.time() < next) return;
    next = simulation.time() + (end - begin) / 40;
    look_at_lattice();
    if (look) look();
  };
  try {
    while (simulation.time() < end && outcome.fault.empty()) {
      simulation.step();
      if (simulation.steps_to_check() > 0 && simulation.time() < end) continue;
      simulation.check();
      at_check();
      if (double(simulation.step_count()) > most_steps)
        outcome.fault = fmt::format("the step has fallen from {:.3g} to {:.3g} s, limited by {}",
                                    step_at_start, simulation.dt(), simulation.limiter());
    }
  } catch (const SimulationFault& fault) {
    outcome.fault = fault.what();
  }
  outcome.when = simulation.time() / end;
  outcome.steps = simulation.step_count();
}

Outcome Watch::result() const {
  Outcome o = outcome;
  o.measures.push_back({"energy_residual", residual / energy});
  if (!lattice.empty()) o.measures.push_back({"sawtooth", sawtooth});
  return o;
}

double scatter(int a, int b, int c, int d) {
  std::uint64_t z = std::uint64_t(a + 64) * 0x9E3779B97F4A7C15u +
                    std::uint64_t(b + 64) * 0xBF58476D1CE4E5B9u +
                    std::uint64_t(c + 64) * 0x94D049BB133111EBu + std::uint64_t(d + 1) * 0xD6E8FEB86659FD93u;
  for (int k = 0; k < 3; ++k) z = (z ^ (z >> 29)) * 0xBF58476D1CE4E5B9u;
  return double(z >> 11) / double(1ull << 52) - 1;
}

} // namespace swarf::stability
