#include "src/pictures/render_view.hpp"

#include "src/output/open_vtk.hpp"

#include <vtkCellData.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
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
void read(Reader* reader, const ResultsFolder& results, const FrameEntry& entry, const std::string& part) {
  open_frame_file(reader, results, entry, part);
  scale_points(reader->GetOutput());
}

void add_shown(vtkDataSetAttributes* data, const ShownField& field, const std::filesystem::path& file) {
  vtkDataArray* source = data->GetArray(field.name.c_str());
  if (!source) {
    std::string names;
    for (int k = 0; k < data->GetNumberOfArrays(); ++k) names += fmt::format(" {}", data->GetArrayName(k));
    throw ResultsError(fmt::format("{}: has no field '{}' to draw, only{}; ask for one of them",
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
    spacing += size / double(particles->GetNumberOfPoints());
    radius->InsertNextValue(float(0.71 * size));
  }
  particles->GetPointData()->AddArray(radius);
}

void find_contact(LoadedFrame& frame) {
  vtkDataArray* force = frame.particles->GetPointData()->GetArray("contact_force");
  if (!force) return;
  double total = 0, square = 0;
  for (vtkIdType i = 0; i < force->GetNumberOfTuples(); ++i) {
    const double* f = force->GetTuple3(i);
    const double weight = std::hypot(f[0], f[1], f[2]);
    double x[3];
    frame.particles->GetPoint(i, x);
    for (std::size_t c = 0; c < 3; ++c) frame.contact[c] += weight * x[c], square += weight * x[c] * x[c];
    total += weight;
  }
  frame.in_contact = total > 0;
  if (!frame.in_contact) return;
  for (double& c : frame.contact) c /= total, square -= total * c * c;
  frame.contact_spread = std::sqrt(std::max(0.0, square / total));
}

// Without what has retired, which may be anywhere.
vtkSmartPointer<vtkUnstructuredGrid> present_particles(vtkUnstructuredGrid* grid) {
  if (!grid->GetPointData()->HasArray("retired")) return grid;
  vtkNew<vtkThreshold> present;
  present->SetInputData(grid);
  present->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "retired");
  present->SetThresholdFunction(vtkThreshold::THRESHOLD_LOWER);
  present->SetLowerThreshold(0.5);
  present->Update();
  return present->GetOutput();
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

} // namespace

ShownField describe_field(const std::string& name) {
  if (name == "temperature") return {name, "Temperature [K]", 1};
  if (name == "equivalent_plastic_strain") return {name, "Equivalent plastic strain [-]", 1};
  if (name == "plastic_strain_rate") return {name, "Plastic strain rate [1/s]", 1};
  if (name == "von_mises") return {name, "Von Mises stress [MPa]", 1e-6};
  if (name == "pressure") return {name, "Pressure [MPa]", 1e-6};
  if (name == "velocity") return {name, "Speed [m/s]", 1};
  if (name == "contact_pressure") return {name, "Contact pressure [MPa]", 1e-6};
  if (name == "sliding_speed") return {name, "Sliding speed [m/s]", 1};
  if (name == "friction_power") return {name, "Friction power [W/mm\u00b2]", 1e-6};
  if (name == "wear_depth") return {name, "Depth of wear [nm]", 1e9};
  if (name == "material") return {name, "Material (row of the deck's)", 1};
  if (name == "damage") return {name, "Damage [-]", 1};
  return {name, name + " [SI]", 1};
}

vtkSmartPointer<vtkPolyData> load_tool(const ResultsFolder& results, const FrameEntry& entry,
                                       const std::optional<ShownField>& field) {
  const auto file = frame_file(results, entry.index, "tool");
  vtkNew<vtkXMLPolyDataReader> reader;
  read(reader.Get(), results, entry, "tool");
  vtkSmartPointer<vtkPolyData> tool = reader->GetOutput();
  if (field) add_shown(tool->GetCellData(), *field, file);
  return tool;
}

void check_frame(const ResultsFolder& results, const FrameEntry& entry) {
  for (const auto& [part, is_there] :
       {std::pair{"particles", entry.particles}, {"hexes", entry.hexes}, {"tool", entry.tool}})
    if (is_there) check_frame_file(frame_file(results, entry.index, part), entry, part);
}

LoadedFrame load_frame(const ResultsFolder& results, const FrameEntry& entry, const ShownField& field) {
  LoadedFrame frame;
  frame.entry = entry;
  if (entry.particles) {
    const auto file = frame_file(results, entry.index, "particles");
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    read(reader.Get(), results, entry, "particles");
    const auto present = present_particles(reader->GetOutput());
    frame.particles = vtkSmartPointer<vtkPolyData>::New();
    frame.particles->SetPoints(present->GetPoints());
    frame.particles->SetVerts(present->GetCells());
    frame.particles->GetPointData()->ShallowCopy(present->GetPointData());
    add_shown(frame.particles->GetPointData(), field, file);
    add_radius(frame.particles, frame.spacing);
    find_contact(frame);
  }
  if (entry.hexes) {
    const auto file = frame_file(results, entry.index, "hexes");
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    read(reader.Get(), results, entry, "hexes");
    vtkUnstructuredGrid* grid = reader->GetOutput();
    if (grid->GetPointData()->HasArray(field.name.c_str()))
      add_shown(grid->GetPointData(), field, file);
    else
      add_shown(grid->GetCellData(), field, file);
    frame.hexes = hex_surface(grid);
  }
  if (entry.tool) frame.tool = load_tool(results, entry, std::nullopt);
  return frame;
}

} // namespace swarf
