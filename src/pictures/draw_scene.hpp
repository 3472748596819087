// A scene before it runs.
#pragma once
#include "src/scene/scene.hpp"
#include <string>

namespace swarf {

// The bodies as they begin, coloured by material, and the tool at four times of its way. Throws ResultsError:
// no display, no place to write.
void draw_scene(const Deck& deck, const Scene& scene, const std::string& png);

} // namespace swarf
