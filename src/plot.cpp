#include "src/plot.hpp"

#include "src/display.hpp"
#include "src/history.hpp"
#include "src/png.hpp"

#include <fmt/format.h>

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace swarf {
namespace {

using Colour = std::array<unsigned char, 3>;

// Distinct for colour-blind readers (Okabe & Ito 2008), black first.
constexpr Colour black{20, 20, 20}, blue{0, 114, 178}, vermilion{213, 94, 0}, green{0, 158, 115};
constexpr Colour sky{86, 180, 233}, orange{230, 159, 0}, purple{204, 121, 167}, grey{120, 120, 120};

struct Curve {
  std::string label; // "": not in the legend
  std::vector<double> values;
  Colour colour;
  float width;
  int line = vtkPen::SOLID_LINE;
  unsigned char opacity = 255;
};

struct Level { // a labelled horizontal line
  std::string label;
  double value;
};

struct Axis {
  std::string title;
  std::vector<double> values;
};

// Immersion where the run has one, else time in a unit that gives handy numbers.
Axis horizontal_axis(const HistoryTable& history) {
  const auto& angle = history.at("immersion");
  const auto [least, most] = std::minmax_element(angle.begin(), angle.end());
  if (*most > *least) return {"Immersion angle [deg]", angle};
  Axis axis{"", history.at("time")};
  const double end = axis.values.back();
  const auto [scale, unit] = end < 1e-3 ? std::pair(1e6, "\u00b5s")
                             : end < 1  ? std::pair(1e3, "ms")
                                        : std::pair(1.0, "s");
  for (double& t : axis.values) t *= scale;
  axis.title = fmt::format("Time [{}]", unit);
  return axis;
}

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

class Chart {
 public:
  Chart(const std::string& title, const std::string& x_title, const std::string& y_title) {
    vtkRenderWindow* window = view->GetRenderWindow();
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(8);
    window->SetSize(1800, 1080);
    view->GetRenderer()->SetBackground(1, 1, 1);
    view->GetScene()->AddItem(chart);
    chart->SetTitle(title);
    chart->GetTitleProperties()->SetFontSize(32);
    chart->SetBorders(130, 100, 40, 30); // left, bottom, right, top
    style_axis(vtkAxis::BOTTOM, x_title);
    style_axis(vtkAxis::LEFT, y_title);
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

  void add(const std::vector<double>& x, const Curve& curve) {
    vtkPlot* plot = chart->AddPlot(vtkChart::LINE);
    plot->SetInputData(make_table(x, curve.values, curve.label), 0, 1);
    plot->SetLabel(curve.label);
    plot->SetLegendVisibility(!curve.label.empty());
    plot->GetPen()->SetColor(curve.colour[0], curve.colour[1], curve.colour[2], curve.opacity);
    plot->GetPen()->SetLineType(curve.line);
    plot->SetWidth(curve.width);
  }

  // About eight ticks at round numbers.
  void set_range(int which, double least, double most) {
    vtkAxis* axis = chart->GetAxis(which);
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

  void write(const std::filesystem::path& png, const std::vector<Level>& levels) {
    view->GetRenderWindow()->Render(); // places the axes
    for (const Level& level : levels) add_label(level);
    write_png(view->GetRenderWindow(), png);
  }

 private:
  void style_axis(int which, const std::string& title) {
    vtkAxis* axis = chart->GetAxis(which);
    axis->SetTitle(title);
    axis->GetTitleProperties()->SetFontSize(28);
    axis->GetTitleProperties()->SetBold(false);
    axis->GetLabelProperties()->SetFontSize(24);
    axis->GetGridPen()->SetColor(228, 228, 228);
    axis->GetPen()->SetWidth(2);
  }

  // At the right end, just above its line.
  void add_label(const Level& level) {
    vtkAxis* axis = chart->GetAxis(vtkAxis::LEFT);
    const float low = axis->GetPosition1()[1], high = axis->GetPosition2()[1];
    const double share = (level.value - axis->GetMinimum()) / (axis->GetMaximum() - axis->GetMinimum());
    vtkNew<vtkTextActor> text;
    text->SetInput(level.label.c_str());
    text->GetTextProperty()->SetFontSize(24);
    text->GetTextProperty()->SetColor(0.25, 0.25, 0.25);
    text->GetTextProperty()->SetJustificationToRight();
    text->GetTextProperty()->SetVerticalJustificationToBottom();
    text->SetPosition(chart->GetAxis(vtkAxis::BOTTOM)->GetPosition2()[0] - 12,
                      low + share * (high - low) + 3);
    view->GetRenderer()->AddActor2D(text);
  }

  vtkNew<vtkContextView> view;
  vtkNew<vtkChartXY> chart;
};

HistoryTable load(const ResultsFolder& results) {
  const std::string why_not = open_display();
  if (!why_not.empty()) throw ResultsError(why_not);
  HistoryTable history = read_history(results.history());
  if (history.rows() < 2)
    throw ResultsError(fmt::format("{}: has {} samples, a curve needs two; let the run go on",
                                   results.history().string(), history.rows()));
  return history;
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double v : values)
    if (std::isfinite(v)) largest = std::max(largest, std::abs(v));
  return largest;
}

// From 0 (or the least value) to the largest, with some air; spikes of raw samples do not count.
std::pair<double, double> vertical_range(const std::vector<Curve>& curves, const std::vector<Level>& levels) {
  double least = 0, most = 0;
  for (const Curve& curve : curves)
    for (const double v : curve.values)
      if (std::isfinite(v)) least = std::min(least, v), most = std::max(most, v);
  for (const Level& level : levels) most = std::max(most, level.value);
  const double air = most > least ? 0.08 * (most - least) : 1;
  return {least < 0 ? least - air : 0, most + air};
}

} // namespace

void plot_forces(const ResultsFolder& results, const std::filesystem::path& png,
                 const std::vector<LabelledForce>& published, double filter_frequency) {
  const HistoryTable history = load(results);
  const HistoryTable filtered = filter_history(history, filter_frequency);
  const Axis axis = horizontal_axis(history);

  std::vector<Curve> thick{{"F_x", filtered.at("force_x"), blue, 3},
                           {"F_y", filtered.at("force_y"), vermilion, 3},
                           {"F_z", filtered.at("force_z"), green, 3},
                           {"planar resultant", filtered.at("force_planar"), black, 5}};
  const auto& planar = filtered.at("force_planar");
  const bool is_planar = largest_of(planar) > 0.01 * largest_of(filtered.at("force_z"));
  if (!is_planar) thick.erase(thick.begin(), thick.begin() + 2), thick.pop_back(); // a blow along z
  std::vector<Level> levels;
  for (const LabelledForce& force : published)
    levels.push_back({fmt::format("{} ({} N)", force.label, force.force), force.force});
  const auto [least, most] = vertical_range(thick, levels);

  Chart chart("Force on the tool", axis.title, "Force [N]");
  chart.add(axis.values,
            {is_planar ? "unfiltered resultant" : "unfiltered F_z",
             history.at(is_planar ? "force_planar" : "force_z"), grey, 1, vtkPen::SOLID_LINE, 110});
  for (const Level& level : levels)
    chart.add({axis.values.front(), axis.values.back()},
              {"", {level.value, level.value}, grey, 2.5, vtkPen::DASH_LINE});
  for (const Curve& curve : thick) chart.add(axis.values, curve);
  chart.set_range(vtkAxis::LEFT, least, most);
  chart.set_range(vtkAxis::BOTTOM, axis.values.front(), axis.values.back());
  chart.write(png, levels);
}

void plot_energies(const ResultsFolder& results, const std::filesystem::path& png) {
  const HistoryTable history = load(results);
  const Axis axis = horizontal_axis(history);
  const std::vector<std::pair<const char*, Colour>> terms{
      {"plastic_work", vermilion}, {"friction_work", orange},   {"elastic_energy", blue},
      {"kinetic_energy", sky},     {"viscous_work", green},     {"hourglass_work", purple},
      {"contact_energy", grey},    {"tie_work", {150, 110, 60}}};

  double largest = largest_of(history.at("external_work"));
  for (const auto& term : terms) largest = std::max(largest, largest_of(history.at(term.first)));
  const auto [scale, unit] = largest < 1e-6   ? std::pair(1e9, "nJ")
                             : largest < 1e-3 ? std::pair(1e6, "\u00b5J")
                             : largest < 1    ? std::pair(1e3, "mJ")
                                              : std::pair(1.0, "J");
  const auto scaled = [&, scale = scale](const char* name) {
    std::vector<double> values = history.at(name);
    for (double& v : values) v *= scale;
    return values;
  };
  const auto label = [](std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
  };
  std::vector<Curve> curves{{"external work", scaled("external_work"), black, 5}};
  for (const auto& [name, colour] : terms) {
    const auto values = scaled(name);
    if (largest_of(values) > 0) curves.push_back({label(name), values, colour, 3});
  }
  curves.push_back({"energy residual", scaled("energy_residual"), black, 2.5, vtkPen::DASH_LINE});

  Chart chart("Energy", axis.title, fmt::format("Energy [{}]", unit));
  for (const Curve& curve : curves) chart.add(axis.values, curve);
  const auto [least, most] = vertical_range(curves, {});
  chart.set_range(vtkAxis::LEFT, least, most);
  chart.set_range(vtkAxis::BOTTOM, axis.values.front(), axis.values.back());
  chart.write(png, {});
}

} // namespace swarf
