#include "src/output/open_vtk.hpp"
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace swarf {
namespace {

vtkSmartPointer<vtkUnstructuredGrid> read_grid(const ResultsFolder& results, const FrameEntry& entry,
                                               const std::string& part) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  open_frame_file(reader.Get(), results, entry, part);
  return reader->GetOutput();
}

template <class T>
std::vector<T> values_of(vtkDataArray* array) {
  std::vector<T> values;
  if (!array) return values;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    for (int c = 0; c < array->GetNumberOfComponents(); ++c) values.push_back(T(array->GetComponent(i, c)));
  return values;
}

PointFields state_of(vtkDataSetAttributes* data) {
  PointFields state;
  state.temperature = values_of<float>(data->GetArray("temperature"));
  state.equivalent_plastic_strain = values_of<float>(data->GetArray("equivalent_plastic_strain"));
  state.stress = values_of<float>(data->GetArray("stress"));
  state.volume = values_of<float>(data->GetArray("volume"));
  return state;
}

} // namespace

FrameData read_frame(const ResultsFolder& results, const FrameEntry& entry) {
  FrameData frame;
  frame.time = entry.time, frame.immersion = entry.immersion;
  if (entry.particles) {
    const auto grid = read_grid(results, entry, "particles");
    frame.particles.position = values_of<float>(grid->GetPoints()->GetData());
    frame.particles.identity = values_of<int>(grid->GetPointData()->GetArray("identity"));
    frame.particles.retired = values_of<int>(grid->GetPointData()->GetArray("retired"));
    frame.particles.state = state_of(grid->GetPointData());
  }
  if (entry.hexes) {
    const auto grid = read_grid(results, entry, "hexes");
    frame.hexes.position = values_of<float>(grid->GetPoints()->GetData());
    frame.hexes.connectivity = values_of<int>(grid->GetCells()->GetConnectivityArray());
    frame.hexes.active = values_of<int>(grid->GetCellData()->GetArray("active"));
    frame.hexes.state = state_of(grid->GetCellData());
  }
  return frame;
}

} // namespace swarf
