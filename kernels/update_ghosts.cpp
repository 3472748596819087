// Copies what neighbours read from the sources of ghosts. update_ghosts: what the drift moved, and what the
// sums before the forces read of a neighbour. update_ghost_state: what prepare_pair_state wrote and what the
// stress update changed.
#include "copy_to_ghosts.hpp"

namespace swarf {

void update_ghosts(const Particles& p, const Neighbors& n, const GhostPlanes& planes) {
  copy_to_ghosts<Ghosts::after_drift>("update_ghosts", p, n, planes);
}

void update_ghost_state(const Particles& p, const Neighbors& n, const GhostPlanes& planes) {
  copy_to_ghosts<Ghosts::before_forces>("update_ghost_state", p, n, planes);
}

} // namespace swarf
