// Where an end mill and the tip of its tooth 0, at the end face, are at an immersion.
#pragma once
#include "src/deck/deck.hpp"

namespace swarf {

struct MillMotion {
  ToolDeck tool;
  Triple axis{}; // of the rings: a point of it

  double radius() const { return 0.5 * tool.diameter; }
  double pitch() const;
  Triple position(double immersion) const;
  // Immersion of the tip seen from the rings' axis, clockwise from +y, without jumps; and its inverse.
  double about_ring(double immersion) const;
  double where_about_ring(double about) const;
  double tip_radius(double immersion) const; // from the rings' axis
  bool is_near_axis(double immersion) const; // less than a tenth of the radius away
};

// Angle by which the tooth's foremost point is ahead of its tip, where it is at least `deepest` from the
// mill's axis. Bound from above.
double lead_of_edge(const ToolDeck& tool, double deepest);

} // namespace swarf
