#include "src/render_view.hpp"

#include <fmt/format.h>

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkClipClosedSurface.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFeatureEdges.h>
#include <vtkFloatArray.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkThreshold.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>

namespace swarf {
namespace {

constexpr const char* shown = "shown";

void scale_points(vtkPointSet* set) {
  vtkPoints* points = set->GetPoints();
  double x[3];
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
    points->GetPoint(i, x);
    points->SetPoint(i, units_per_metre * x[0], units_per_metre * x[1], units_per_metre * x[2]);
  }
  points->Modified();
}

template <class Reader>
void read(Reader* reader, const std::filesystem::path& file) {
  static_cast<void>(read_text(file).size()); // says what the system says if it is not there
  vtkNew<vtkCallbackCommand> quiet;          // an observer keeps VTK from printing errors
  reader->AddObserver(vtkCommand::ErrorEvent, quiet);
  reader->SetParserErrorObserver(quiet);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, quiet);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfPoints() == 0)
    throw ResultsError(
        fmt::format("{}: is no frame that VTK can read; it was damaged after the run", file.string()));
  scale_points(reader->GetOutput());
}

void add_shown(vtkDataSetAttributes* data, const ShownField& field, const std::filesystem::path& file) {
  vtkDataArray* source = data->GetArray(field.name.c_str());
  if (!source) {
    std::string names;
    for (int k = 0; k < data->GetNumberOfArrays(); ++k) names += fmt::format(" {}", data->GetArrayName(k));
    throw ResultsError(
        fmt::format("{}: has no field '{}' to draw, only{}; set output.picture_field to one of them",
                    file.string(), field.name, names));
  }
  vtkNew<vtkFloatArray> values;
  values->SetName(shown);
  values->SetNumberOfTuples(source->GetNumberOfTuples());
  for (vtkIdType i = 0; i < source->GetNumberOfTuples(); ++i) {
    double sum = 0;
    for (int c = 0; c < source->GetNumberOfComponents(); ++c) sum += std::pow(source->GetComponent(i, c), 2);
    const double value = source->GetNumberOfComponents() == 1 ? source->GetComponent(i, 0) : std::sqrt(sum);
    values->SetValue(i, float(field.scale * value));
  }
  data->AddArray(values);
  data->SetActiveScalars(shown);
}

// Radius of the drawn spheres: spheres on a cubic lattice that just close the gaps along the face diagonals.
void add_radius(vtkPolyData* particles, double& spacing) {
  vtkDataArray* volume = particles->GetPointData()->GetArray("volume");
  vtkNew<vtkFloatArray> radius;
  radius->SetName("radius");
  spacing = 0;
  for (vtkIdType i = 0; i < particles->GetNumberOfPoints(); ++i) {
    const double size = volume ? units_per_metre * std::cbrt(volume->GetComponent(i, 0)) : 0;
    if (size > 0 && (spacing == 0 || size < spacing)) spacing = size;
    radius->InsertNextValue(float(0.71 * size));
  }
  particles->GetPointData()->AddArray(radius);
}

void find_contact(LoadedFrame& frame) {
  vtkDataArray* force = frame.particles->GetPointData()->GetArray("contact_force");
  if (!force) return;
  double total = 0;
  for (vtkIdType i = 0; i < force->GetNumberOfTuples(); ++i) {
    const double* f = force->GetTuple3(i);
    const double weight = std::hypot(f[0], f[1], f[2]);
    double x[3];
    frame.particles->GetPoint(i, x);
    for (std::size_t c = 0; c < 3; ++c) frame.contact[c] += weight * x[c];
    total += weight;
  }
  frame.in_contact = total > 0;
  if (frame.in_contact)
    for (double& c : frame.contact) c /= total;
}

vtkSmartPointer<vtkPolyData> hex_surface(vtkUnstructuredGrid* grid) {
  vtkNew<vtkThreshold> active;
  active->SetInputData(grid);
  active->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "active");
  active->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  active->SetUpperThreshold(0.5);
  vtkNew<vtkDataSetSurfaceFilter> surface;
  if (grid->GetCellData()->HasArray("active"))
    surface->SetInputConnection(active->GetOutputPort());
  else
    surface->SetInputData(grid);
  surface->Update();
  return surface->GetOutput();
}

void show_field(vtkMapper* mapper, vtkLookupTable* colours) {
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOff();
}

vtkNew<vtkActor> particle_actor(vtkPolyData* particles, vtkLookupTable* colours) {
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(particles);
  mapper->SetScaleArray("radius");
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(shown);
  show_field(mapper, colours);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.7);
  return actor;
}

vtkNew<vtkActor> hex_actor(vtkPolyData* surface, vtkLookupTable* colours) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  if (surface->GetCellData()->HasArray(shown))
    mapper->SetScalarModeToUseCellFieldData();
  else
    mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(shown);
  show_field(mapper, colours);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.7);
  actor->GetProperty()->EdgeVisibilityOn();
  actor->GetProperty()->SetEdgeColor(0.45, 0.45, 0.5);
  return actor;
}

// The part of the tool between two planes across `direction`, closed.
vtkSmartPointer<vtkPolyData> cut_to_slice(vtkPolyData* tool, const LoadedFrame& frame, const Camera& camera) {
  const double* box = (frame.particles ? frame.particles : frame.hexes)->GetBounds();
  vtkNew<vtkPlaneCollection> planes;
  for (const int side : {0, 1}) {
    std::array<double, 3> origin{}, normal{};
    for (std::size_t c = 0; c < 3; ++c) {
      const bool upper = (camera.direction[c] > 0) == (side == 1);
      origin[c] = box[2 * c + (upper ? 1 : 0)];
      normal[c] = camera.direction[c] * (side == 1 ? -1 : 1);
    }
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin.data());
    plane->SetNormal(normal.data());
    planes->AddItem(plane);
  }
  vtkNew<vtkClipClosedSurface> clip;
  clip->SetInputData(tool);
  clip->SetClippingPlanes(planes);
  clip->Update();
  return clip->GetOutput()->GetNumberOfPolys() > 0 ? clip->GetOutput() : tool;
}

void add_tool(vtkRenderer* renderer, const LoadedFrame& frame, const Camera& camera) {
  vtkNew<vtkCleanPolyData> merged; // the file has three points of its own for each facet
  merged->SetInputData(frame.tool);
  merged->Update();
  vtkSmartPointer<vtkPolyData> solid = merged->GetOutput();
  if (camera.section) solid = cut_to_slice(solid, frame, camera);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(solid);
  normals->SetFeatureAngle(35);
  normals->ConsistencyOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> body;
  body->SetMapper(mapper);
  body->GetProperty()->SetColor(0.72, 0.75, 0.80);
  body->GetProperty()->SetAmbient(0.3);
  body->GetProperty()->SetDiffuse(0.7);
  body->GetProperty()->SetSpecular(camera.section ? 0 : 0.5);
  body->GetProperty()->SetSpecularPower(30);
  if (!camera.section) body->GetProperty()->SetOpacity(0.45);
  renderer->AddActor(body);

  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(solid);
  edges->SetFeatureAngle(35);
  edges->ManifoldEdgesOff();
  edges->ColoringOff();
  vtkNew<vtkPolyDataMapper> line_mapper;
  line_mapper->SetInputConnection(edges->GetOutputPort());
  line_mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> lines;
  lines->SetMapper(line_mapper);
  lines->GetProperty()->SetColor(0.2, 0.22, 0.26);
  lines->GetProperty()->SetLineWidth(2);
  lines->GetProperty()->LightingOff();
  renderer->AddActor(lines);
}

} // namespace

ShownField describe_field(const std::string& name) {
  if (name == "temperature") return {name, "Temperature [K]", 1};
  if (name == "equivalent_plastic_strain") return {name, "Equivalent plastic strain [-]", 1};
  if (name == "plastic_strain_rate") return {name, "Plastic strain rate [1/s]", 1};
  if (name == "von_mises") return {name, "Von Mises stress [MPa]", 1e-6};
  if (name == "pressure") return {name, "Pressure [MPa]", 1e-6};
  if (name == "velocity") return {name, "Speed [m/s]", 1};
  if (name == "damage") return {name, "Damage [-]", 1};
  return {name, name + " [SI]", 1};
}

LoadedFrame load_frame(const ResultsFolder& results, const FrameEntry& entry, const ShownField& field) {
  LoadedFrame frame;
  frame.entry = entry;
  if (entry.particles) {
    const auto file = frame_file(results, entry.index, "particles");
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    read(reader.Get(), file);
    frame.particles = vtkSmartPointer<vtkPolyData>::New();
    frame.particles->SetPoints(reader->GetOutput()->GetPoints());
    frame.particles->SetVerts(reader->GetOutput()->GetCells());
    frame.particles->GetPointData()->ShallowCopy(reader->GetOutput()->GetPointData());
    add_shown(frame.particles->GetPointData(), field, file);
    add_radius(frame.particles, frame.spacing);
    find_contact(frame);
  }
  if (entry.hexes) {
    const auto file = frame_file(results, entry.index, "hexes");
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    read(reader.Get(), file);
    vtkUnstructuredGrid* grid = reader->GetOutput();
    if (grid->GetPointData()->HasArray(field.name.c_str()))
      add_shown(grid->GetPointData(), field, file);
    else
      add_shown(grid->GetCellData(), field, file);
    frame.hexes = hex_surface(grid);
  }
  if (entry.tool) {
    vtkNew<vtkXMLPolyDataReader> reader;
    read(reader.Get(), frame_file(results, entry.index, "tool"));
    frame.tool = reader->GetOutput();
  }
  return frame;
}

// Dark blue over violet and orange to pale yellow, rising in lightness: reads in grey print and by all eyes.
// Control colours after "inferno" and "plasma" of N. Smith and S. van der Walt (CC0).
vtkNew<vtkLookupTable> make_colours(double least, double most) {
  static constexpr double control[][3] = {{0.10, 0.13, 0.40}, {0.25, 0.18, 0.58}, {0.45, 0.14, 0.60},
                                          {0.65, 0.17, 0.52}, {0.82, 0.26, 0.38}, {0.93, 0.40, 0.22},
                                          {0.98, 0.60, 0.12}, {0.98, 0.81, 0.28}, {0.99, 0.98, 0.72}};
  constexpr int last = int(std::size(control)) - 1;
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(256);
  for (int k = 0; k < 256; ++k) {
    const double at = last * k / 255.0;
    const int i = std::min(int(at), last - 1);
    double rgb[3];
    for (int c = 0; c < 3; ++c) rgb[c] = control[i][c] + (at - i) * (control[i + 1][c] - control[i][c]);
    table->SetTableValue(k, rgb[0], rgb[1], rgb[2]);
  }
  table->SetRange(least, most);
  return table;
}

vtkNew<vtkRenderer> make_view(const LoadedFrame& frame, const Camera& camera,
                              const std::array<double, 3>& focus, vtkLookupTable* colours) {
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  if (frame.hexes) renderer->AddActor(hex_actor(frame.hexes, colours));
  if (frame.particles) renderer->AddActor(particle_actor(frame.particles, colours));
  if (frame.tool) add_tool(renderer, frame, camera);
  vtkCamera* eye = renderer->GetActiveCamera();
  eye->ParallelProjectionOn();
  eye->SetFocalPoint(focus.data());
  const double distance = 10 * camera.half_height;
  eye->SetPosition(focus[0] + distance * camera.direction[0], focus[1] + distance * camera.direction[1],
                   focus[2] + distance * camera.direction[2]);
  eye->SetViewUp(camera.up.data());
  eye->SetParallelScale(camera.half_height);
  renderer->ResetCameraClippingRange();
  return renderer;
}

} // namespace swarf
