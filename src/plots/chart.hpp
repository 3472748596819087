// Curves and points over two axes, written as a PNG.
#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>
#include <vtkAxis.h>
#include <vtkPen.h>

namespace swarf {

using Colour = std::array<unsigned char, 3>;

// Distinct for colour-blind readers (Okabe & Ito 2008), black first.
constexpr Colour black{20, 20, 20}, blue{0, 114, 178}, vermilion{213, 94, 0}, green{0, 158, 115};
constexpr Colour sky{86, 180, 233}, orange{230, 159, 0}, purple{204, 121, 167}, grey{120, 120, 120};

struct Curve {
  std::string label; // "": not in the legend
  std::vector<double> values;
  Colour colour;
  float width;
  int line = vtkPen::SOLID_LINE; // NO_PEN: points
  unsigned char opacity = 255;
};

struct Level { // a labelled horizontal line
  std::string label;
  double value;
};

// Needs a Display (display.hpp).
class Chart {
 public:
  Chart(const std::string& title, const std::string& x_title, const std::string& y_title);
  ~Chart();
  Chart(const Chart&) = delete;
  Chart& operator=(const Chart&) = delete;

  void add(const std::vector<double>& x, const Curve& curve);
  // About eight ticks at round numbers. `which`: vtkAxis::LEFT or BOTTOM.
  void set_range(int which, double least, double most);
  void write(const std::filesystem::path& png, const std::vector<Level>& levels);

 private:
  struct Canvas;
  std::unique_ptr<Canvas> canvas;
};

// From 0 (or the least value) to the largest, with some air; spikes of raw samples do not count.
std::pair<double, double> vertical_range(const std::vector<Curve>& curves, const std::vector<Level>& levels);

} // namespace swarf
