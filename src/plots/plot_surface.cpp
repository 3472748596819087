#include "src/files/results.hpp"
#include "src/files/say.hpp"
#include "src/plots/chart.hpp"
#include "src/plots/display.hpp"
#include "src/plots/plot.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <vtkAxis.h>

namespace swarf {
namespace {

template <class Value>
std::vector<double> column(const std::vector<DepthLayer>& layers, const Value& value) {
  std::vector<double> out;
  for (const DepthLayer& l : layers) out.push_back(value(l));
  return out;
}

void draw(const std::filesystem::path& png, const std::array<std::string, 3>& titles,
          const std::vector<double>& x, const std::vector<Curve>& curves) {
  Chart chart(titles[0], titles[1], titles[2]);
  double least = 0, most = 0;
  for (const Curve& curve : curves) {
    chart.add(x, curve);
    for (const double v : curve.values) least = std::min(least, v), most = std::max(most, v);
  }
  if (titles[2].find("[K]") != std::string::npos)
    least = *std::min_element(curves.back().values.begin(), curves.back().values.end());
  chart.set_range(vtkAxis::LEFT, least, most > least ? most : least + 1);
  chart.set_range(vtkAxis::BOTTOM, std::min(0.0, x.front()), x.back());
  chart.write(png, {});
}

void draw_all_of(const ResultsFolder& results, const WorkSurface& w, const std::vector<Moment>& history) {
  const std::vector<double> depth = column(w.layers, [](const DepthLayer& l) { return 1e6 * l.depth; });
  const auto in_MPa = [&](double DepthLayer::*field) {
    return column(w.layers, [&](const DepthLayer& l) { return 1e-6 * l.*field; });
  };
  const std::string micro = "Depth [\u00b5m]";
  if (depth.size() > 1) {
    draw(results.pictures() / "surface_stress.png", {"Stress below the new surface", micro, "Stress [MPa]"},
         depth,
         {{"along the cut", in_MPa(&DepthLayer::along), blue, 4},
          {"along the edge", in_MPa(&DepthLayer::across), vermilion, 4},
          {"out of the surface", in_MPa(&DepthLayer::normal), grey, 3}});
    draw(results.pictures() / "surface_strain.png",
         {"Plastic strain below the new surface", micro, "Equivalent plastic strain [-]"}, depth,
         {{"", column(w.layers, [](const DepthLayer& l) { return l.plastic_strain; }), blue, 4}});
  }
  if (history.size() < 2) return;
  std::vector<double> time, mean, hottest;
  for (const Moment& m : history)
    time.push_back(1e6 * m.time), mean.push_back(m.mean), hottest.push_back(m.hottest);
  draw(results.pictures() / "surface_temperature.png",
       {"Temperature of what became the surface", "Time [\u00b5s]", "Temperature [K]"}, time,
       {{"hottest", hottest, vermilion, 3}, {"mean", mean, blue, 4}});
}

} // namespace

void draw_surface(const std::string& results_folder, const SurfaceReport& report) {
  if (const std::string why_not = open_display(); !why_not.empty())
    return complain("no pictures of the surface: {}", why_not);
  const ResultsFolder results = open_results(results_folder);
  make_folder(results.pictures());
  draw_all_of(results, report.surface, report.history);
}

} // namespace swarf
