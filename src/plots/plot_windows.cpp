#include "src/plots/chart.hpp"
#include "src/plots/display.hpp"
#include "src/plots/plot.hpp"
#include <cmath>
#include <fmt/format.h>

namespace swarf {
namespace {

// Of one standard error, the window's own or that of the scatter between them, whichever is more.
struct Bar {
  double x, y, error, half_width;
};
void add_bar(Chart& chart, const Bar& bar, const Curve& style) {
  const auto [x, y, error, half_width] = bar;
  if (!(error > 0)) return; // NaN: unknown
  const auto line = [&](std::vector<double> xs, std::vector<double> ys) {
    chart.add(xs, {"", std::move(ys), style.colour, 0.5f * style.width});
  };
  line({x, x}, {y - error, y + error});
  for (const double end : {y - error, y + error}) line({x - half_width, x + half_width}, {end, end});
}

} // namespace

void plot_windows(const PassFolder& folder, const std::vector<LabelledForce>& published) {
  const std::string why_not = open_display();
  if (!why_not.empty()) throw ResultsError(why_not);
  const HistoryTable table = read_history(folder.table());
  if (table.rows() == 0) throw ResultsError(folder.table().string() + ": no window is complete");
  const auto& angle = table.at("immersion");
  std::vector<Curve> curves{{"F_x", table.at("force_x"), blue, 3},
                            {"F_y", table.at("force_y"), vermilion, 3},
                            {"F_z", table.at("force_z"), green, 3},
                            {"planar resultant", table.at("force_planar"), black, 5}};
  std::vector<Level> levels;
  for (const LabelledForce& force : published)
    levels.push_back({fmt::format("{} ({} N)", force.label, force.force), force.force});
  const double margin = angle.size() > 1 ? 0.5 * (angle[1] - angle[0]) : 5;
  const double left = angle.front() - margin, right = angle.back() + margin;

  Chart chart("Force on the tool, windows of immersion", "Immersion angle [deg]", "Force [N]");
  for (const Level& level : levels)
    chart.add({left, right}, {"", {level.value, level.value}, grey, 2.5, vtkPen::DASH_LINE});
  const char* errors[] = {"error_x", "error_y", "error_z", "error_planar"};
  for (std::size_t c = 0; c < curves.size(); ++c) {
    Curve points = curves[c];
    points.line = vtkPen::NO_PEN, points.label.clear();
    chart.add(angle, points);
    curves[c].width *= 0.6f, chart.add(angle, curves[c]);
    const double scatter = scatter_between(angle, points.values);
    for (std::size_t k = 0; k < angle.size(); ++k) {
      const double own = table.at(errors[c])[k];
      add_bar(chart, {angle[k], points.values[k], scatter > own ? scatter : own, 0.006 * (right - left)},
              points);
    }
  }
  std::vector<double> model_at;
  const Curve model = read_model(ResultsFolder{folder.path}.mechanistic(), left, right, model_at);
  if (model_at.size() > 1) chart.add(model_at, model), curves.push_back(model);
  const auto [least, most] = vertical_range(curves, levels);
  chart.set_range(vtkAxis::LEFT, least, most);
  chart.set_range(vtkAxis::BOTTOM, left, right);
  chart.write(folder.picture(), levels);
}

} // namespace swarf
