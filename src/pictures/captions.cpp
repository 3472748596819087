#include "src/pictures/captions.hpp"

#include <fmt/format.h>

#include <vtkActor2D.h>
#include <vtkCellData.h>
#include <vtkLineSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

namespace swarf {

ColourRange find_range(const std::vector<vtkPolyData*>& parts) {
  std::vector<float> values;
  for (vtkPolyData* part : parts) {
    if (!part) continue;
    for (vtkDataSetAttributes* data : {static_cast<vtkDataSetAttributes*>(part->GetPointData()),
                                       static_cast<vtkDataSetAttributes*>(part->GetCellData())})
      if (vtkDataArray* array = data->GetArray("shown"))
        for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
          if (std::isfinite(array->GetTuple1(i))) values.push_back(float(array->GetTuple1(i)));
  }
  return find_range(std::move(values), 0.999);
}

ColourRange find_range(std::vector<float> values, double share) {
  if (values.empty()) return {0, 1, 0.2};
  const auto quantile = [&](double part) {
    const auto at = values.begin() + long(part * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return double(*at);
  };
  double least = quantile(0), most = quantile(share);
  if (most <= least) most = quantile(1);
  if (most <= least)
    return {least, least + (least == 0 ? 1 : std::abs(least)), (least == 0 ? 1 : std::abs(least)) / 4};
  const double power = std::pow(10, std::floor(std::log10(most - least))), leading = (most - least) / power;
  const double step = power / (leading < 2 ? 10 : leading < 5 ? 5 : 2);
  return {std::floor(least / step) * step, std::ceil(most / step) * step, step};
}

int count_labels(ColourRange& range) {
  int steps = int(std::lround((range.most - range.least) / range.step));
  for (;; ++steps, range.most += range.step)
    for (int intervals = 7; intervals >= 3; --intervals)
      if (steps % intervals == 0) return intervals + 1;
}

void add_text(vtkRenderer* renderer, const Label& label) {
  vtkNew<vtkTextActor> text;
  text->SetInput(label.words.c_str());
  text->GetTextProperty()->SetFontSize(label.size);
  text->GetTextProperty()->SetColor(0, 0, 0);
  text->GetTextProperty()->SetBackgroundColor(1, 1, 1);
  text->GetTextProperty()->SetBackgroundOpacity(0.75);
  if (label.centred) text->GetTextProperty()->SetJustificationToCentered();
  text->SetPosition(label.x, label.y);
  renderer->AddActor2D(text);
}

std::string frame_label(const FrameEntry& entry) {
  if (entry.immersion) return fmt::format("immersion {:.1f}\u00b0", *entry.immersion);
  return entry.time < 1e-3 ? fmt::format("{:.3g} \u00b5s", entry.time * 1e6)
                           : fmt::format("{:.4g} ms", entry.time * 1e3);
}

void add_scale_bar(vtkRenderer* renderer, double metres_per_pixel) {
  const double wish = 160 * metres_per_pixel, power = std::pow(10, std::floor(std::log10(wish)));
  const double length = wish >= 5 * power ? 5 * power : wish >= 2 * power ? 2 * power : power;
  const double left = 30, right = left + length / metres_per_pixel, height = 40;
  vtkNew<vtkLineSource> line;
  line->SetPoint1(left, height, 0);
  line->SetPoint2(right, height, 0);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(line->GetOutputPort());
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0, 0, 0);
  actor->GetProperty()->SetLineWidth(6);
  renderer->AddActor2D(actor);
  const bool small = length < 0.999e-3;
  const std::string words = fmt::format("{:.4g} {}", length * (small ? 1e6 : 1e3), small ? "\u00b5m" : "mm");
  add_text(renderer, {words, 26, (left + right) / 2, height + 14, true});
}

vtkNew<vtkRenderer> make_colour_bar(vtkLookupTable* colours, const std::string& title, int labels,
                                    int picture_width) {
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(colours);
  bar->SetOrientationToHorizontal();
  bar->SetNumberOfLabels(labels);
  bar->SetMaximumNumberOfColors(256);
  bar->SetLabelFormat("%.4g");
  bar->UnconstrainedFontSizeOn();
  vtkTextProperty* text = bar->GetLabelTextProperty();
  text->SetColor(0, 0, 0);
  text->SetFontSize(24);
  text->ItalicOff(), text->BoldOff(), text->ShadowOff();
  const double width = std::min(0.55, 780.0 / picture_width);
  bar->SetPosition(0.5 - width / 2, 0.06);
  bar->SetWidth(width), bar->SetHeight(0.58);
  bar->SetBarRatio(0.5);
  renderer->AddActor2D(bar);
  add_text(renderer, {title, 26, picture_width / 2.0, double(bar_height - 38), true});
  return renderer;
}

} // namespace swarf
