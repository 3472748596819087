// How a Simulation finds that it has gone wrong, and what it says then.
#include "src/simulation/simulation.hpp"
#include <cmath>
#include <fmt/format.h>

namespace swarf {

unsigned long long value_of(const Status& status) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, status)();
}

// m c^2 of all points, J.
double elastic_scale_of(const MaterialPoints& points, const MaterialTable& table) {
  const auto mass = host_copy(points.mass);
  const auto row = host_copy(points.material);
  const auto materials = host_copy(table);
  double sum = 0;
  for (int i = 0; i < points.count; ++i)
    sum += double(mass(i)) * std::pow(double(longitudinal_wave_speed(materials(row(i)))), 2);
  return sum;
}

void Simulation::check_status() {
  const auto particle_fault = value_of(status), hex_fault = value_of(hex_status);
  if (particle_fault != no_fault) {
    const Fault fault = Fault(particle_fault >> 32);
    const unsigned of = unsigned(particle_fault);
    fail(fault, fault == Fault::particle_lost ? fmt::format("particle {}", of) : place_of_particle(of));
  }
  if (hex_fault != no_fault) fail(Fault(hex_fault >> 32), place_of_hex(unsigned(hex_fault)));
}

// An instability need not end in a number that is none: points may fly off and what is left go on. A strain
// of 1e-4 everywhere is the least that counts, or the first touch of a tool would.
void Simulation::check_energy(const HistorySample& s) const {
  const double given = energy.initial + std::abs(s.external);
  if (s.residual <= given || s.residual <= 1e-8 * elastic_scale) return;
  fail(fmt::format("it has made {:.3g} J of energy and was given {:.3g} J; fastest, {:.3g} m/s: {}",
                   s.residual, given, s.max_velocity, place_of_fastest()));
}

std::string Simulation::place_of_particle(unsigned row) const {
  const Vector3 x = load_vector(host_copy(model.particles.position), int(row));
  const bool tied = int(row) >= model.particles.count;
  return fmt::format("{} {} (row {}) at ({:.6g}, {:.6g}, {:.6g}) m", tied ? "tied particle" : "particle",
                     host_copy(model.particles.identity)(row), row, x.x, x.y, x.z);
}

std::string Simulation::place_of_hex(unsigned row) const {
  const Vector3 x = load_vector(host_copy(model.hexes.position), host_copy(model.hexes.connectivity)(row, 0));
  return fmt::format("hex {} (row {}) at ({:.6g}, {:.6g}, {:.6g}) m", row, row, x.x, x.y, x.z);
}

std::string Simulation::place_of_limiter() const {
  const int hex = limiting_row - model.particles.total;
  if (limiting_row < 0) return "nothing";
  return hex < 0 ? place_of_particle(unsigned(limiting_row)) : place_of_hex(unsigned(hex));
}

std::string Simulation::place_of_fastest() const {
  const auto fastest = [&](const VectorField& velocity, int rows) {
    const auto v = host_copy(velocity);
    int row = 0;
    for (int i = 1; i < rows; ++i)
      if (norm(load_vector(v, i)) > norm(load_vector(v, row))) row = i;
    return std::pair(rows > 0 ? norm(load_vector(v, row)) : Real(-1), row);
  };
  const auto [particle, row] = fastest(model.particles.velocity, model.particles.count);
  const auto [node, a] = fastest(model.hexes.velocity, model.hexes.nodes);
  if (particle >= node) return place_of_particle(unsigned(row));
  const Vector3 x = load_vector(host_copy(model.hexes.position), a);
  return fmt::format("node {} at ({:.6g}, {:.6g}, {:.6g}) m", a, x.x, x.y, x.z);
}

void Simulation::fail(Fault fault, const std::string& where) const {
  const char* what = fault == Fault::non_finite       ? "a state that is not a finite number, in "
                     : fault == Fault::inverted_hex   ? "turned inside out: "
                     : fault == Fault::return_mapping ? "a plastic return that did not converge, in "
                     : fault == Fault::particle_lost  ? "out of its periodic body: "
                                                      : "particles that outran the neighbour lists";
  fail(what + where);
}

void Simulation::fail(const std::string& what) const {
  throw SimulationFault(fmt::format("the run became unstable: {}; t = {:.6g} s, step {}. "
                                    "Try a smaller run.courant or run.mass_factor.",
                                    what, now, steps));
}

} // namespace swarf
