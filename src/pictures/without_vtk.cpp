// In place of all that draws, where swarf is built without VTK.
#include "src/plots/without_vtk.hpp"
#include "src/files/say.hpp"
#include "src/pictures/draw_scene.hpp"
#include "src/pictures/pictures.hpp"
#include "src/pictures/render.hpp"

namespace swarf {
namespace {

const std::string what_to_do = without_vtk;

} // namespace

void draw_plots(const std::string& results) { throw ResultsError(results + ": " + what_to_do); }
bool render_strip(const std::string& results) { throw ResultsError(results + ": " + what_to_do); }
void render_tool(const std::string& results, const std::string&) {
  throw ResultsError(results + ": " + what_to_do);
}
void render_film(const std::string& results) { throw ResultsError(results + ": " + what_to_do); }
void draw_scene(const Deck&, const Scene&, const std::string& png) {
  throw ResultsError(png + ": " + what_to_do);
}
void draw_windows(const std::string&) { complain("no picture: {}", what_to_do); }
void draw_all(const std::string&) { complain("no pictures: {}", what_to_do); }

} // namespace swarf
