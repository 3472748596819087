// The tool alone, seen from where the chip comes and from the finished surface, coloured by what it feels.
#include "src/files/say.hpp"
#include "src/pictures/captions.hpp"
#include "src/pictures/render.hpp"
#include "src/pictures/render_view.hpp"
#include "src/plots/display.hpp"
#include "src/plots/png.hpp"
#include "src/tool/geometry.hpp"

#include <fmt/format.h>

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace swarf {
namespace {

using Vector = Eigen::Vector3d;
constexpr int view_size = 560; // pixels

struct Patch {
  Vector middle; // in units of the picture
  double area, pressure, shown;
};

std::vector<Patch> list_patches(vtkPolyData* tool) {
  std::vector<Patch> patches;
  vtkDataArray* pressure = tool->GetCellData()->GetArray("contact_pressure");
  vtkDataArray* shown = tool->GetCellData()->GetArray("shown");
  for (vtkIdType c = 0; c < tool->GetNumberOfCells(); ++c) {
    Vector x[3];
    for (vtkIdType k = 0; k < 3; ++k)
      tool->GetPoint(3 * c + k, x[k].data()); // as write_vtk.cpp lays them out
    patches.push_back({(x[0] + x[1] + x[2]) / 3, 0.5 * (x[1] - x[0]).cross(x[2] - x[0]).norm(),
                       pressure ? pressure->GetTuple1(c) : 0, shown->GetTuple1(c)});
  }
  return patches;
}

struct SeenTool {
  FrameEntry entry;
  vtkSmartPointer<vtkPolyData> tool;
  std::vector<Patch> patches;
  Vector centre{0, 0, 0};  // of the contact
  Vector forward, outward; // unit: of the cutting motion, and out of the finished surface
  double reach = 0;        // of the contact about its centre
};

// The cutting motion of the tool's material at the contact, and from the tool's middle to the contact across
// it: of a mill the radius, of a wedge down into the work.
void find_directions(SeenTool& frame, const ToolDeck& tool) {
  const ToolPose pose = tool_pose(tool, frame.entry.time);
  const Vector x = frame.centre / units_per_metre;
  const Vector3 v = surface_velocity(pose, {Real(x.x()), Real(x.y()), Real(x.z())});
  frame.forward = Vector(double(v.x), double(v.y), double(v.z));
  double box[6];
  frame.tool->GetBounds(box);
  Vector out = frame.centre - 0.5 * Vector(box[0] + box[1], box[2] + box[3], box[4] + box[5]);
  if (tool.spindle_speed > 0)
    out = frame.centre - units_per_metre * Vector(double(pose.position.x), double(pose.position.y), 0),
    out.z() = 0;
  if (frame.forward.norm() == 0)
    frame.forward = std::abs(out.z()) < 0.9 * out.norm() ? Vector(0, 0, 1) : Vector(1, 0, 0);
  frame.forward.normalize();
  out -= out.dot(frame.forward) * frame.forward;
  if (out.norm() == 0) out = frame.forward.unitOrthogonal();
  frame.outward = out.normalized();
}

std::optional<SeenTool> load(const ResultsFolder& results, const FrameEntry& entry, const ShownField& field,
                             const ToolDeck& tool) {
  SeenTool frame;
  frame.entry = entry, frame.tool = load_tool(results, entry, field);
  frame.patches = list_patches(frame.tool);
  double load = 0;
  for (const Patch& p : frame.patches)
    load += p.pressure * p.area, frame.centre += p.pressure * p.area * p.middle;
  if (!(load > 0)) return std::nullopt;
  frame.centre /= load;
  for (const Patch& p : frame.patches)
    if (p.pressure > 0)
      frame.reach = std::max(frame.reach, (p.middle - frame.centre).norm() + std::sqrt(p.area));
  find_directions(frame, tool);
  return frame;
}

// Of what is touched, from the least of all the tool.
ColourRange range_of(const std::vector<SeenTool>& frames) {
  std::vector<float> values;
  for (const SeenTool& frame : frames) {
    float least = std::numeric_limits<float>::infinity();
    for (const Patch& p : frame.patches) {
      least = std::min(least, float(p.shown));
      if (p.pressure > 0) values.push_back(float(p.shown));
    }
    values.push_back(least);
  }
  return find_range(std::move(values), 1);
}

vtkNew<vtkRenderer> make_tool_view(const SeenTool& frame, bool of_rake, double half_height,
                                   vtkLookupTable* colours) {
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputData(frame.tool);
  merged->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(merged->GetOutputPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray("shown");
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> body;
  body->SetMapper(mapper);
  body->GetProperty()->SetAmbient(0.75);
  body->GetProperty()->SetDiffuse(0.3);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  renderer->AddActor(body);
  renderer->AddActor(line_actor(merged->GetOutput()));
  const Vector towards = of_rake ? frame.forward : frame.outward;
  const Vector up = of_rake ? Vector(-frame.outward) : frame.forward;
  const Vector eye = frame.centre + 10 * half_height * towards;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(frame.centre.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(up.data());
  camera->SetParallelScale(half_height);
  renderer->ResetCameraClippingRange();
  return renderer;
}

void draw(const std::vector<SeenTool>& frames, const ShownField& field, const std::filesystem::path& png) {
  ColourRange range = range_of(frames);
  const int labels = count_labels(range);
  const auto colours = make_colours(range.least, range.most);
  double half_height = 0;
  for (const SeenTool& frame : frames) half_height = std::max(half_height, 1.15 * frame.reach);
  const int columns = int(frames.size()), width = std::max(columns * view_size, 800);
  const int height = 2 * view_size + bar_height;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(4);
  window->SetSize(width, height);
  vtkNew<vtkRenderer> paper;
  paper->SetBackground(1, 1, 1);
  window->AddRenderer(paper);
  const double margin = 0.5 * (width - columns * view_size), gap = 3;
  for (int k = 0; k < columns; ++k)
    for (const bool of_rake : {true, false}) {
      const SeenTool& frame = frames[std::size_t(k)];
      const auto view = make_tool_view(frame, of_rake, half_height, colours);
      const double left = margin + k * view_size, bottom = bar_height + (of_rake ? view_size : 0);
      view->SetViewport((left + gap) / width, (bottom + gap) / height, (left + view_size - gap) / width,
                        (bottom + view_size - gap) / height);
      add_text(view, {fmt::format("{}, {}", of_rake ? "rake" : "flank", frame_label(frame.entry)), 26, 20,
                      double(view_size - 46)});
      window->AddRenderer(view);
    }
  const auto bar = make_colour_bar(colours, field.title, labels, width);
  add_scale_bar(bar, 2 * half_height / view_size / units_per_metre);
  bar->SetViewport(0, 0, 1, double(bar_height) / height);
  window->AddRenderer(bar);
  write_png(window, png);
}

} // namespace

void render_tool(const std::string& results_folder, const std::string& name) {
  const ResultsFolder results = open_results(results_folder);
  const Deck deck = read_deck(results.deck().string(), results.path.string());
  if (!deck.tool) throw ResultsError(results_folder + ": the run had no tool to look at");
  if (const std::string why_not = open_display(); !why_not.empty()) throw ResultsError(why_not);
  const ShownField field = describe_field(!name.empty()                 ? name
                                          : deck.tool->material.empty() ? "contact_pressure"
                                                                        : "temperature");
  std::vector<double> angles = deck.output.picture_immersion;
  for (double& angle : angles) angle *= 180 / M_PI;
  const auto all = read_frame_list(results);
  std::vector<SeenTool> frames;
  const auto take = [&](const std::vector<FrameEntry>& entries) {
    for (const FrameEntry& entry : entries)
      if (entry.tool)
        if (auto frame = load(results, entry, field, *deck.tool)) frames.push_back(std::move(*frame));
  };
  take(choose_frames(all, angles, deck.output.picture_time));
  if (frames.empty()) take(all);
  if (frames.empty()) throw ResultsError(results_folder + ": the tool touches nothing in any of its frames");
  if (frames.size() > 4) frames.erase(frames.begin(), frames.end() - 4);
  make_folder(results.pictures());
  const auto png = results.pictures() / fmt::format("tool_{}.png", field.name);
  draw(frames, field, png);
  say("picture: {}\n", png.string());
}

} // namespace swarf
