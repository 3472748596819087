// What a picture shows, counted.
#pragma once
#include "support/temporary_folder.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

#include <cstdlib>

// Where a test puts a picture: in its own folder, or in SWARF_KEEP_PICTURES to be looked at.
inline std::filesystem::path picture(const TemporaryFolder& folder, const std::string& name) {
  const char* keep = std::getenv("SWARF_KEEP_PICTURES");
  return keep ? std::filesystem::path(keep) / name : folder / name;
}

struct Pixels {
  vtkSmartPointer<vtkImageData> image;
  explicit Pixels(const std::filesystem::path& png) {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(png.c_str());
    reader->Update();
    image = reader->GetOutput();
  }
  int width() const { return image->GetDimensions()[0]; }
  int height() const { return image->GetDimensions()[1]; }
  const unsigned char* at(int x, int y) const {
    return static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
  }
  // Pixels of columns [from, to), `bottom` rows left out, that accept(r, g, b).
  template <class Accept>
  int count_if(int from, int to, Accept&& accept, int bottom = 0) const {
    int found = 0;
    for (int y = bottom; y < height(); ++y)
      for (int x = from; x < to; ++x) found += accept(at(x, y)[0], at(x, y)[1], at(x, y)[2]);
    return found;
  }
  // Pixels close to the colour r, g, b.
  int count(int r, int g, int b) const {
    return count_if(0, width(), [=](int R, int G, int B) {
      return std::abs(R - r) + std::abs(G - g) + std::abs(B - b) < 40;
    });
  }
};
