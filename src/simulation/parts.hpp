// What a run keeps beside the model and the step, each with its own state: when something is due again, and
// the books of the energy. No kernels, no deck: numbers in, numbers out.
#pragma once
#include "src/output/history.hpp"
#include "swarf/kernels.hpp"
#include <utility>

namespace swarf {

// What is done more rarely than the step: conduction and the diffusion of pressure.
struct Pace {
  double waited = 0; // s, since it was done last
  void add(double step) { waited += step; }
  double by_next(double step) const { return waited + step; } // s, if it waits for one more step
  double take() { return std::exchange(waited, 0); }
};

// When the active region is looked for again.
struct FreezePlan {
  struct ToolAndPoints { // speeds, m/s, or ways, m
    double of_tool, of_points;
  };
  bool due = false;
  double looked_at = 0; // s

  // `elapsed`: s, from the last look to the next chance for one; ways that may be gone until then, infinite
  // where there is no tool.
  void plan(double elapsed, const ToolAndPoints& speed, const ToolAndPoints& way) {
    due = speed.of_tool * elapsed >= way.of_tool || speed.of_points * elapsed >= way.of_points;
  }
  void looked(double now) { due = false, looked_at = now; }
};

// When hexes that are to become particles are looked for again. A plastic strain may come at any time, the
// tool only as fast as it moves.
struct ConversionPlan {
  bool due = false;
  double looked_at = 0; // s
  void plan(double now, bool by_strain, double tool_speed, double way) {
    due = by_strain || tool_speed * (now - looked_at) >= way;
  }
  void looked(double now) { due = false, looked_at = now; }
};

// Energies since the start, J. The residual is what the method makes or loses.
struct EnergyLedger {
  PointSums particles, hexes; // at the last check
  PointSums frozen;           // of the particles: does not change until others freeze
  bool others_frozen = true;
  double initial = 0, tool_work = 0;
  double lost_in_conversion = 0; // of motion that particles do not have, and of the contact's springs

  // Less what was given up by points that were frozen at once.
  void begin() { initial = double(particles.kinetic) + hexes.kinetic - particles.external - hexes.external; }
  void take_tool_work(double work) { tool_work += work; }
  void fill(HistorySample& s) const {
    const PointSums &a = particles, &b = hexes;
    s.kinetic = double(a.kinetic) + b.kinetic;
    s.plastic = double(a.plastic) + b.plastic;
    s.elastic = double(a.internal) + b.internal - s.plastic;
    s.frictional = double(a.friction) + b.friction;
    s.viscous = double(a.viscous) + b.viscous;
    s.hourglass = double(a.hourglass) + b.hourglass;
    s.contact = double(a.contact) + b.contact;
    s.tie = lost_in_conversion, s.shifting = double(a.shifting);
    s.external = double(a.external) + b.external + tool_work;
    s.residual = s.kinetic + s.elastic + s.plastic + s.frictional + s.viscous + s.hourglass + s.contact +
                 s.tie + s.shifting - initial - s.external;
  }
};

} // namespace swarf
