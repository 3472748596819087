// `swarf surface`: what a cut has left on the work.
#pragma once
#include "src/surface/machined_surface.hpp"
#include <string>
#include <vector>

namespace swarf {

// Means over a layer of the work, weighted by volume, with the scatter (standard deviation) of the stresses.
struct DepthLayer {
  double depth = 0, volume = 0;                 // m, of its middle below the mean surface; m3
  double along = 0, across = 0, normal = 0;     // Pa: along the cut, along the edge, out of the surface
  double along_scatter = 0, across_scatter = 0; // Pa
  double plastic_strain = 0, temperature = 0;   // K
};

struct WorkSurface {
  double from = 0, to = 0;           // m along the cut, between which it was looked at
  double spacing = 0;                // m, of the particles: nothing finer is seen
  double mean_height = 0;            // m above the nominal surface
  double Ra = 0, Rz = 0;             // m, of the heights of its strips, each as long as the spacing
  double burr = 0, burr_along = 0;   // m, highest point of all that was cut, and where
  std::vector<double> strip, height; // m, along and above
  std::vector<DepthLayer> layers;    // from the surface down
  std::vector<int> outermost;        // identities of the particles of the first layer
};

// share: of the length that was cut, left out at each end.
WorkSurface measure_surface(const MachinedSurface& surface, const FrameData& frame, double share);

struct Moment {
  double time = 0, mean = 0, hottest = 0; // s, K
};

struct SurfaceReport {
  WorkSurface surface;
  std::vector<Moment> history; // of the outermost particles, in each frame
};

// DIR/surface.csv (layers), surface_heights.csv (strips), surface_history.csv (mean and largest temperature
// of the outermost particles in each frame), surface.json. Throws ResultsError.
SurfaceReport describe_surface(const std::string& results_folder, double share);

} // namespace swarf
