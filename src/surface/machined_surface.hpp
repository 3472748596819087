// The surface that a cut was meant to leave, and the points of the work measured from it.
#pragma once
#include "src/output/frame.hpp"
#include "src/tool/mill_motion.hpp"
#include <Eigen/Core>
#include <optional>

namespace swarf {

// Along the cut, m, from where the tool's tip was at time 0; above the surface that its path leaves
// (negative: in the work), m; along the edge. And the directions of the first two there.
struct SurfacePlace {
  double along = 0, above = 0, across = 0;
  Eigen::Vector3d direction{1, 0, 0}, normal{0, 1, 0};
};

// Of a wedge: the plane that its lowest point moves in. Of an end mill: what the tips of tooth 0, without
// run-out, leave in the ring, at the end face and, but for the lag of a helix, above it.
class MachinedSurface {
 public:
  explicit MachinedSurface(const Deck& deck); // throws ResultsError for other tools
  SurfacePlace place(const Eigen::Vector3d& x) const;
  double passed(double time) const; // how far the tip has come along; no farther once the tool has lifted off

 private:
  ToolDeck tool;
  std::optional<MillMotion> mill;
  Eigen::Vector3d forward{1, 0, 0}, up{0, 1, 0};
};

} // namespace swarf
