// One frame as VTK actors. Only for the .cpp files that draw.
#pragma once
#include "src/pictures/render.hpp"

#include <vtkActor.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <optional>

namespace swarf {

// Graphics cards compute in float and square lengths: micrometres suit them, metres do not.
inline constexpr double units_per_metre = 1e6;

// A frame read back, lengths times units_per_metre, with the array "shown" on particles and hexes: the field
// in the unit of its title.
struct LoadedFrame {
  FrameEntry entry;
  vtkSmartPointer<vtkPolyData> particles, hexes, tool; // null where the frame has none
  double spacing = 0;                                  // of the particles, mean
  std::array<double, 3> contact{};                     // where the tool presses, weighted by the force
  double contact_spread = 0;                           // root of the mean square distance from there
  bool in_contact = false;
};

struct ShownField {
  std::string name, title;
  double scale = 1;
};
ShownField describe_field(const std::string& name);

// Throws ResultsError that says which file is missing or damaged.
void check_frame(const ResultsFolder& results, const FrameEntry& entry);
LoadedFrame load_frame(const ResultsFolder& results, const FrameEntry& entry, const ShownField& field);
// The tool alone; the field, of its patches, as "shown".
vtkSmartPointer<vtkPolyData> load_tool(const ResultsFolder& results, const FrameEntry& entry,
                                       const std::optional<ShownField>& field);
vtkNew<vtkActor> line_actor(vtkPolyData* surface); // its sharp edges

// What all views of a picture share.
struct Camera {
  std::array<double, 3> direction{0, 0, 1}, right{1, 0, 0}, up{0, 1, 0}; // of the image, in the world
  double half_height = 0;
  int width = 640, height = 560;         // of a view, pixels
  std::array<double, 3> centre{0, 0, 0}; // of all that is shown
  bool follow = false;                   // the tool: not all is shown
  bool section = false;                  // a thin slice seen along its axis: the tool is cut to the slice
};

// Everything, or where the tool presses if that is a small part of it.
Camera aim_camera(const PictureOptions& options, const std::vector<LoadedFrame>& frames);
std::array<double, 3> find_focus(const Camera& camera, const std::vector<LoadedFrame>& frames, std::size_t k);

vtkNew<vtkRenderer> make_view(const LoadedFrame& frame, const Camera& camera,
                              const std::array<double, 3>& focus, vtkLookupTable* colours);
vtkNew<vtkLookupTable> make_colours(double least, double most);

} // namespace swarf
