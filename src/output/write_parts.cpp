#include "src/output/write_parts.hpp"
#include "src/files/results.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

namespace swarf {
namespace fs = std::filesystem;
namespace {

// Borrows the vector's memory; VTK does not write to it.
template <class Array, class T>
vtkSmartPointer<Array> borrow(const std::vector<T>& values, int components, const char* name) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetArray(const_cast<T*>(values.data()), vtkIdType(values.size()), 1);
  return array;
}

void add(vtkDataSetAttributes* to, const char* name, const std::vector<float>& values, int components = 1) {
  if (!values.empty()) to->AddArray(borrow<vtkFloatArray>(values, components, name));
}
void add(vtkDataSetAttributes* to, const char* name, const std::vector<int>& values) {
  if (!values.empty()) to->AddArray(borrow<vtkIntArray>(values, 1, name));
}

void add_state(vtkDataSetAttributes* to, const PointFields& state) {
  add(to, "temperature", state.temperature);
  add(to, "equivalent_plastic_strain", state.equivalent_plastic_strain);
  add(to, "plastic_strain_rate", state.plastic_strain_rate);
  add(to, "von_mises", state.von_mises), add(to, "pressure", state.pressure);
  add(to, "stress", state.stress, 6);
  add(to, "damage", state.damage), add(to, "volume", state.volume), add(to, "material", state.material);
}

void set_points(vtkPointSet* set, const std::vector<float>& position) {
  vtkNew<vtkPoints> points;
  points->SetData(borrow<vtkFloatArray>(position, 3, "position"));
  set->SetPoints(points);
}

// Cell k has the points corner[n * k] .. corner[n * k + n - 1].
vtkNew<vtkCellArray> make_cells(int points_per_cell, vtkIdType cells, const int* corner) {
  vtkNew<vtkCellArray> array;
  array->Use32BitStorage();
  array->AllocateExact(cells, cells * points_per_cell);
  std::vector<vtkIdType> ids(static_cast<std::size_t>(points_per_cell));
  for (vtkIdType c = 0; c < cells; ++c) {
    for (int k = 0; k < points_per_cell; ++k) {
      const vtkIdType at = c * points_per_cell + k;
      ids[std::size_t(k)] = corner ? corner[at] : at;
    }
    array->InsertNextCell(points_per_cell, ids.data());
  }
  return array;
}

void set_time(vtkDataObject* data, const FrameData& frame) {
  const auto number = [&](const char* name, double value) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    data->GetFieldData()->AddArray(array);
  };
  number("TimeValue", frame.time);
  if (frame.immersion) number("immersion", *frame.immersion);
}

// Returns the checksum of the file.
template <class Writer>
std::string write_data(const fs::path& file, vtkDataObject* data) {
  vtkNew<Writer> writer;
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->WriteToOutputStringOn();
  if (!writer->Write())
    throw ResultsError(file.string() + ": VTK cannot make this frame; too little memory?");
  const std::string text = writer->GetOutputString();
  write_file(file, text);
  return hash_text(text);
}

std::string write_particles(const fs::path& file, const FrameData& frame) {
  const FrameParticles& particles = frame.particles;
  vtkNew<vtkUnstructuredGrid> grid;
  set_points(grid, particles.position);
  grid->SetCells(VTK_VERTEX, make_cells(1, vtkIdType(particles.position.size() / 3), nullptr));
  add_state(grid->GetPointData(), particles.state);
  add(grid->GetPointData(), "velocity", particles.velocity, 3);
  add(grid->GetPointData(), "contact_force", particles.contact_force, 3);
  add(grid->GetPointData(), "body", particles.body),
      add(grid->GetPointData(), "identity", particles.identity),
      add(grid->GetPointData(), "retired", particles.retired);
  set_time(grid, frame);
  return write_data<vtkXMLUnstructuredGridWriter>(file, grid);
}

std::string write_hexes(const fs::path& file, const FrameData& frame) {
  const FrameHexes& hexes = frame.hexes;
  vtkNew<vtkUnstructuredGrid> grid;
  set_points(grid, hexes.position);
  grid->SetCells(VTK_HEXAHEDRON,
                 make_cells(8, vtkIdType(hexes.connectivity.size() / 8), hexes.connectivity.data()));
  add(grid->GetPointData(), "velocity", hexes.velocity, 3);
  add_state(grid->GetCellData(), hexes.state);
  add(grid->GetCellData(), "active", hexes.active);
  set_time(grid, frame);
  return write_data<vtkXMLUnstructuredGridWriter>(file, grid);
}

std::string write_tool(const fs::path& file, const FrameData& frame) {
  vtkNew<vtkPolyData> surface;
  set_points(surface, frame.tool);
  surface->SetPolys(make_cells(3, vtkIdType(frame.tool.size() / 9), nullptr));
  const ToolFields& fields = frame.tool_fields;
  add(surface->GetCellData(), "temperature", fields.temperature);
  add(surface->GetCellData(), "contact_pressure", fields.contact_pressure);
  add(surface->GetCellData(), "sliding_speed", fields.sliding_speed);
  add(surface->GetCellData(), "friction_power", fields.friction_power);
  add(surface->GetCellData(), "wear_depth", fields.wear_depth);
  set_time(surface, frame);
  return write_data<vtkXMLPolyDataWriter>(file, surface);
}

} // namespace

bool can_write_frames() { return true; }

std::string write_part(const fs::path& file, const std::string& part, const FrameData& frame) {
  if (part == "hexes") return write_hexes(file, frame);
  return part == "particles" ? write_particles(file, frame) : write_tool(file, frame);
}

} // namespace swarf
