// What stands around the views of a picture: scale, colour bar, labels. Only for the .cpp files that draw.
#pragma once
#include "src/output/write_vtk.hpp"

#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <string>
#include <vector>

namespace swarf {

inline constexpr int bar_height = 130; // pixels

struct ColourRange {
  double least, most, step;
};
// From the least value to the one that only a part 1 - share exceeds, at round numbers.
ColourRange find_range(std::vector<float> values, double share);
ColourRange find_range(const std::vector<vtkPolyData*>& parts); // of "shown"; 1 in 1000 exceeds it

// Labels of the colour bar at round numbers: as many intervals as divide the range in whole steps, 3 to 7.
int count_labels(ColourRange& range);
vtkNew<vtkRenderer> make_colour_bar(vtkLookupTable* colours, const std::string& title, int labels,
                                    int picture_width);
// A bar of a round length, about a quarter of a view, at the lower left.
void add_scale_bar(vtkRenderer* renderer, double metres_per_pixel);
struct Label {
  std::string words;
  int size;             // of the font
  double x, y;          // pixels, of its lower left corner
  bool centred = false; // about x
};
void add_text(vtkRenderer* renderer, const Label& label);
std::string frame_label(const FrameEntry& entry);

} // namespace swarf
