// Heat through the faces of bodies: a film against surroundings, or a held temperature.
#pragma once
#include "swarf/material/thermal.hpp"

namespace swarf {

struct HeatedFace {
  Real resistance = 0;  // m2 K/W, of the film; 0: the surface is held at the temperature
  Real temperature = 0; // K, of the surroundings or of the surface
};
using HeatedFaces = View<HeatedFace*>;

// The nodes of heated faces of hexes; node k has entries [start(k), start(k + 1)), one for each of its faces.
struct HeatedNodes {
  int count = 0;
  IndexField node, start, face;
  ScalarField area; // m2, of the node on that face
};

// What comes through `area` in dt, J: from the face's temperature through the film, and through `own` more,
// m2 K/W, to a point at T of that heat capacity. Of the point's temperature that at the end of dt, so that a
// thin resistance does not overshoot.
SWARF_FN Real heat_through(const HeatedFace& face, Real own, Real area, Real T, Real capacity, Real dt) {
  return (face.temperature - T) * dt / ((face.resistance + own) / area + dt / capacity);
}

} // namespace swarf
