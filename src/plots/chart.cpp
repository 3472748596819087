#include "src/plots/chart.hpp"
#include "src/plots/png.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkPlotPoints.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace swarf {
namespace {

vtkNew<vtkTable> make_table(const std::vector<double>& x, const std::vector<double>& y,
                            const std::string& label) {
  vtkNew<vtkTable> table;
  const auto add = [&](const char* name, const std::vector<double>& values) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (const double v : values) column->InsertNextValue(v);
    table->AddColumn(column);
  };
  add("x", x), add(label.empty() ? "y" : label.c_str(), y);
  return table;
}

constexpr int label_size = 24; // pixels

} // namespace

struct Chart::Canvas {
  void style_axis(int which, const std::string& title) {
    vtkAxis* axis = chart->GetAxis(which);
    axis->SetTitle(title);
    axis->GetTitleProperties()->SetFontSize(28);
    axis->GetTitleProperties()->SetBold(false);
    axis->GetLabelProperties()->SetFontSize(24);
    axis->GetGridPen()->SetColor(228, 228, 228);
    axis->GetPen()->SetWidth(2);
  }

  double height_of(const Level& level) { // pixels
    vtkAxis* axis = chart->GetAxis(vtkAxis::LEFT);
    const float low = axis->GetPosition1()[1], high = axis->GetPosition2()[1];
    const double share = (level.value - axis->GetMinimum()) / (axis->GetMaximum() - axis->GetMinimum());
    return low + share * (high - low);
  }

  // At the right end just above its line, at the left end just below.
  void add_label(const Level& level, bool at_right) {
    vtkAxis* axis = chart->GetAxis(vtkAxis::BOTTOM);
    vtkNew<vtkTextActor> text;
    text->SetInput(level.label.c_str());
    text->GetTextProperty()->SetFontSize(label_size);
    text->GetTextProperty()->SetColor(0.25, 0.25, 0.25);
    text->GetTextProperty()->SetJustification(at_right ? VTK_TEXT_RIGHT : VTK_TEXT_LEFT);
    text->GetTextProperty()->SetVerticalJustification(at_right ? VTK_TEXT_BOTTOM : VTK_TEXT_TOP);
    text->SetPosition(at_right ? axis->GetPosition2()[0] - 12 : axis->GetPosition1()[0] + 12,
                      height_of(level) + (at_right ? 3 : -3));
    view->GetRenderer()->AddActor2D(text);
  }

  vtkNew<vtkContextView> view;
  vtkNew<vtkChartXY> chart;
};

Chart::Chart(const std::string& title, const std::string& x_title, const std::string& y_title)
    : canvas(std::make_unique<Canvas>()) {
  auto& [view, chart] = *canvas;
  vtkRenderWindow* surface = view->GetRenderWindow();
  surface->SetOffScreenRendering(1);
  surface->SetMultiSamples(8);
  surface->SetSize(1800, 1080);
  view->GetRenderer()->SetBackground(1, 1, 1);
  view->GetScene()->AddItem(chart);
  chart->SetTitle(title);
  chart->GetTitleProperties()->SetFontSize(32);
  chart->SetBorders(130, 100, 40, 30); // left, bottom, right, top
  canvas->style_axis(vtkAxis::BOTTOM, x_title);
  canvas->style_axis(vtkAxis::LEFT, y_title);
  chart->SetShowLegend(true);
  vtkChartLegend* legend = chart->GetLegend();
  legend->GetLabelProperties()->SetFontSize(24);
  legend->SetInline(false); // beside the curves, never over them
  legend->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  legend->SetVerticalAlignment(vtkChartLegend::TOP);
  legend->GetBrush()->SetColor(255, 255, 255, 255);
  legend->GetPen()->SetColor(255, 255, 255);
  legend->SetSymbolWidth(44);
  legend->SetPadding(10);
}

Chart::~Chart() = default;

void Chart::add(const std::vector<double>& x, const Curve& curve) {
  const bool points = curve.line == vtkPen::NO_PEN;
  vtkPlot* plot = canvas->chart->AddPlot(points ? vtkChart::POINTS : vtkChart::LINE);
  plot->SetInputData(make_table(x, curve.values, curve.label), 0, 1);
  plot->SetLabel(curve.label);
  plot->SetLegendVisibility(!curve.label.empty());
  plot->GetPen()->SetColor(curve.colour[0], curve.colour[1], curve.colour[2], curve.opacity);
  if (points) {
    vtkPlotPoints::SafeDownCast(plot)->SetMarkerStyle(vtkPlotPoints::CIRCLE);
    vtkPlotPoints::SafeDownCast(plot)->SetMarkerSize(3 * curve.width);
  } else {
    plot->GetPen()->SetLineType(curve.line);
  }
  plot->SetWidth(curve.width);
}

void Chart::set_range(int which, double least, double most) {
  vtkAxis* axis = canvas->chart->GetAxis(which);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(least, most);
  const double rough = (most - least) / 8, power = std::pow(10, std::floor(std::log10(rough)));
  const double step = power * (rough < 1.5 * power   ? 1
                               : rough < 3.5 * power ? 2
                               : rough < 7.5 * power ? 5
                                                     : 10);
  vtkNew<vtkDoubleArray> ticks;
  vtkNew<vtkStringArray> labels;
  for (double k = std::ceil(least / step); k * step <= most + 1e-9 * step; ++k) {
    ticks->InsertNextValue(k * step);
    labels->InsertNextValue(fmt::format("{:.4g}", k * step));
  }
  axis->SetCustomTickPositions(ticks, labels);
}

void Chart::write(const std::filesystem::path& png, const std::vector<Level>& levels) {
  canvas->view->GetRenderWindow()->Render(); // places the axes
  std::vector<Level> from_top = levels;
  std::sort(from_top.begin(), from_top.end(),
            [](const Level& a, const Level& b) { return a.value > b.value; });
  bool at_right = true; // a label that would meet the one above it goes to the other end
  for (std::size_t k = 0; k < from_top.size(); ++k) {
    const bool close =
        k > 0 && canvas->height_of(from_top[k - 1]) - canvas->height_of(from_top[k]) < 1.3 * label_size;
    at_right = close ? !at_right : true;
    canvas->add_label(from_top[k], at_right);
  }
  write_png(canvas->view->GetRenderWindow(), png);
}

std::pair<double, double> vertical_range(const std::vector<Curve>& curves, const std::vector<Level>& levels) {
  double least = 0, most = 0;
  for (const Curve& curve : curves)
    for (const double v : curve.values)
      if (std::isfinite(v)) least = std::min(least, v), most = std::max(most, v);
  for (const Level& level : levels) most = std::max(most, level.value);
  const double air = most > least ? 0.08 * (most - least) : 1;
  return {least < 0 ? least - air : 0, most + air};
}

} // namespace swarf
