#include "src/output/write_vtk.hpp"
#include "src/files/say.hpp"

#include <fmt/format.h>

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

#include <charconv>
#include <sstream>

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

const char* extension(const std::string& part) { return part == "tool" ? "vtp" : "vtu"; }

// Calls part(name) for each file that the frame has.
template <class Part>
void for_each_part(const FrameEntry& entry, Part&& part) {
  if (entry.hexes) part("hexes");
  if (entry.particles) part("particles");
  if (entry.tool) part("tool");
}

constexpr const char* list_header = "frame,time [s],immersion [deg],parts,checksums\n";
constexpr const char* old_list_header = "frame,time [s],immersion [deg],parts\n";

void say_what_is_missing(const ResultsFolder& results, const std::vector<FrameEntry>& entries) {
  std::string missing;
  int count = 0;
  for (const FrameEntry& entry : entries)
    for_each_part(entry, [&](const char* part) {
      const fs::path file = frame_file(results, entry.index, part);
      std::error_code ignored;
      if (fs::exists(file, ignored) || ++count > 5) return;
      missing += (missing.empty() ? "" : ", ") + file.string();
    });
  if (count > 0)
    complain("warning: {} file(s) of the earlier frames are missing: {}{}. The run goes on without them; "
             "copy them "
             "back if you need them.",
             count, missing, count > 5 ? ", ..." : "");
}

} // namespace

fs::path frame_file(const ResultsFolder& results, int index, const std::string& part) {
  return results.frames() / fmt::format("frame_{:04d}_{}.{}", index, part, extension(part));
}

FrameSeries::FrameSeries(const ResultsFolder& folder, int frames)
    : results(folder), entries(read_frame_list(folder)) {
  if (count() < frames)
    throw ResultsError(
        fmt::format("{}: lists {} frames, the checkpoint was written after {}; the frames were changed "
                    "after the run, start the run again",
                    results.frame_list().string(), count(), frames));
  while (count() > frames) {
    const FrameEntry last = entries.back();
    entries.pop_back();
    write_lists(); // first, so that no list names a file that is gone
    for_each_part(last, [&](const char* part) {
      std::error_code error;
      fs::remove(frame_file(results, last.index, part), error);
      if (error) fail_to(frame_file(results, last.index, part), "remove a frame of later", error.value());
    });
  }
  say_what_is_missing(results, entries);
}

void FrameSeries::write(const FrameData& frame) {
  FrameEntry entry{count(),
                   frame.time,
                   frame.immersion,
                   !frame.particles.position.empty(),
                   !frame.hexes.connectivity.empty(),
                   !frame.tool.empty(),
                   {}};
  for_each_part(entry, [&](const std::string& part) {
    const fs::path file = frame_file(results, entry.index, part);
    entry.checksums[part] = part == "hexes"       ? write_hexes(file, frame)
                            : part == "particles" ? write_particles(file, frame)
                                                  : write_tool(file, frame);
  });
  entries.push_back(entry);
  write_lists();
}

void FrameSeries::write_lists() const {
  std::string list = list_header,
              pvd = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                    "  <Collection>\n";
  for (const FrameEntry& entry : entries) {
    list += fmt::format("{},{},{},", entry.index, entry.time,
                        entry.immersion ? fmt::format("{}", *entry.immersion) : "");
    int part_number = 0;
    for_each_part(entry, [&](const std::string& part) {
      list += (part_number ? " " : "") + part;
      pvd += fmt::format("    <DataSet timestep=\"{}\" part=\"{}\" name=\"{}\" file=\"frames/{}\"/>\n",
                         entry.time, part_number++, part,
                         frame_file(results, entry.index, part).filename().string());
    });
    std::string checksums;
    for_each_part(entry, [&](const std::string& part) {
      const auto found = entry.checksums.find(part);
      if (found != entry.checksums.end()) checksums += (checksums.empty() ? "" : " ") + found->second;
    });
    list += "," + checksums + '\n';
  }
  pvd += "  </Collection>\n</VTKFile>\n";
  write_file(results.paraview(), pvd);
  write_file(results.frame_list(), list);
}

std::vector<FrameEntry> read_frame_list(const ResultsFolder& results) {
  std::error_code ignored;
  if (!fs::exists(results.frame_list(), ignored)) return {};
  const std::string text = read_text(results.frame_list());
  std::vector<FrameEntry> entries;
  const auto damaged = [&] {
    throw ResultsError(
        fmt::format("{}:{}: expected 'frame,time,immersion,parts'; the list of frames is damaged, "
                    "run again",
                    results.frame_list().string(), entries.size() + 2));
  };
  if (!text.starts_with(list_header) && !text.starts_with(old_list_header)) damaged();
  for (std::size_t start = text.find('\n') + 1; start < text.size();) {
    const auto end = std::min(text.find('\n', start), text.size());
    const char* at = text.data() + start;
    const char* const stop = text.data() + end;
    FrameEntry entry;
    const auto number = [&](auto& value) {
      const auto [next, error] = std::from_chars(at, stop, value);
      if (error != std::errc{} || next == stop || *next != ',') damaged();
      at = next + 1;
    };
    number(entry.index), number(entry.time);
    if (at != stop && *at != ',') {
      entry.immersion.emplace();
      number(*entry.immersion);
    } else {
      ++at;
    }
    const std::string_view rest(at, at < stop ? std::size_t(stop - at) : 0);
    const std::string_view parts = rest.substr(0, rest.find(','));
    std::istringstream checksums(std::string(rest.substr(std::min(rest.size(), parts.size() + 1))));
    entry.particles = parts.find("particles") != parts.npos, entry.hexes = parts.find("hexes") != parts.npos;
    entry.tool = parts.find("tool") != parts.npos;
    for_each_part(entry, [&](const char* part) {
      if (std::string sum; checksums >> sum) entry.checksums[part] = sum;
    });
    if (entry.index != int(entries.size())) damaged();
    entries.push_back(entry);
    start = end + 1;
  }
  return entries;
}

} // namespace swarf
