// In place of the plots, where swarf is built without VTK.
#include "src/plots/without_vtk.hpp"
#include "src/files/say.hpp"
#include "src/surface/surface.hpp"
#include <string>

namespace swarf {

void draw_surface(const std::string&, const SurfaceReport&) { complain("no pictures: {}", without_vtk); }

} // namespace swarf
