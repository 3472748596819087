// Heat in the tool: finite volumes fixed in its frame, and what crosses the interface with the work.
#pragma once
#include "swarf/core/tensor.hpp"

namespace swarf {

// Cells as a graph: whatever their shape, one gather conducts between them. Cells cut by the surface have the
// conductance of the open part of their faces between full-cell centres (Ng, Min & Gibou, J. Comput. Phys.
// 228 (2009) 8807): exact for linear fields between whole cells of one size. A tree finds the cell of a
// point: node n has children tree(n) .. tree(n) + 3 or 7, the one of low coordinates first, or is a leaf of
// cell -1 - tree(n).
struct ToolHeat {
  int cells = 0; // 0: the tool does not conduct
  Real conductivity = 0, start_temperature = 0;
  ScalarField capacity;       // J/K; infinite where the temperature is held
  ScalarField temperature;    // K
  ScalarField depth;          // m, of the cell's centre below the surface
  VectorField centre;         // m, in the tool's frame
  ScalarField heat;           // J, of the last conduction
  ScalarField out;            // J, that has gone into held cells
  IndexField start, neighbor; // CSR
  ScalarField conductance;    // W/K, of each entry

  IndexField tree;
  Vector3 low{0, 0, 0};   // of the root
  Real size = 0;          // m, edge of the root
  Real finest = 0;        // m, edge of the least cell
  bool one_layer = false; // a periodic slice: four children, and z does not matter

  IndexField first, source; // scratch of gather_tool_heat: rows of points by cell
};

// The cell at x, in the tool's frame; what lies beyond the root takes the nearest cell at its rim.
SWARF_FN int find_tool_cell(const ToolHeat& t, const Vector3& x) {
  Real half = Real(0.5) * t.size;
  Vector3 low = t.low;
  int node = 0;
  for (; t.tree(node) >= 0; half *= Real(0.5)) {
    const bool right = x.x >= low.x + half, up = x.y >= low.y + half, above = x.z >= low.z + half;
    node = t.tree(node) + (right ? 1 : 0) + (up ? 2 : 0) + (above && !t.one_layer ? 4 : 0);
    if (right) low.x += half;
    if (up) low.y += half;
    if (above && !t.one_layer) low.z += half;
  }
  return -1 - t.tree(node);
}

SWARF_FN void add_tool_heat(const ToolHeat& t, int cell, Real heat) {
  if (t.capacity(cell) < Kokkos::Experimental::infinity_v<Real>)
    t.temperature(cell) += heat / t.capacity(cell);
  else
    t.out(cell) += heat;
}

// A point of the work against a cell of the tool. Resistances, K/W, from the work's temperature to the middle
// of the interface and from there to the tool's: half the interface's own belongs to each.
struct HeatContact {
  Real work_temperature, tool_temperature; // K
  Real work_resistance, tool_resistance;   // K/W
  Real work_capacity;                      // J/K
};

// Heat that goes into the tool in dt, J, when friction makes `made` at the interface: the flow through both
// resistances in series, and the share of what is made that the resistance towards the work turns away,
//   q (R_w + R_t) = (T_w - T_t) dt + R_w made;  made - q goes into the work.
// Of the work's temperature that at the end of dt, so that a thin resistance does not overshoot.
SWARF_FN Real heat_into_tool(const HeatContact& at, Real made, Real dt) {
  const Real lag = dt / at.work_capacity;
  return ((at.work_temperature - at.tool_temperature) * dt + made * (at.work_resistance + lag)) /
         (at.work_resistance + at.tool_resistance + lag);
}

} // namespace swarf
